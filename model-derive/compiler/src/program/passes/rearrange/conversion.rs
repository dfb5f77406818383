//! Between a program and its sums and products.

use rustc_hash::FxHashMap;

use super::super::cse;
use super::network::{Network, Node, Operation, Signed};
use crate::program::{Instruction, Program, Value};

/// A program as sums and products, with what computes the others.
pub struct Rearranged {
    pub network: Network,
    /// Of the first nodes, whether they are numbers.
    pub is_number: Vec<bool>,
    /// What is neither a sum nor a product, with its operand if it has one.
    others: Vec<(Instruction, Option<Signed>)>,
    outputs: Vec<Signed>,
    labels: Vec<(Signed, usize)>,
    parameters: usize,
}

impl Rearranged {
    /// Of a program without whole powers and without equal instructions.
    pub fn new(program: &Program) -> Self {
        let mut new = Self {
            network: Network::default(),
            is_number: Vec::new(),
            others: Vec::new(),
            outputs: Vec::new(),
            labels: Vec::new(),
            parameters: program.parameters,
        };
        let mut reciprocals: FxHashMap<Signed, Signed> = FxHashMap::default();
        let mut values: Vec<Signed> = Vec::with_capacity(program.instructions.len());
        for &instruction in &program.instructions {
            let mut reciprocal = |new: &mut Self, divisor: Value| {
                let divisor = values[divisor];
                *reciprocals.entry(divisor).or_insert_with(|| new.other(Instruction::Reciprocal(0), Some(divisor)))
            };
            let value = match instruction {
                Instruction::Add(a, b) => new.network.sum(values[a], values[b]),
                Instruction::Sub(a, b) => new.network.sum(values[a], values[b].signed(true)),
                Instruction::Mul(a, b) => new.multiply(values[a], values[b]),
                Instruction::Square(a) => new.multiply(values[a], values[a]),
                Instruction::Neg(a) => values[a].signed(true),
                Instruction::Reciprocal(a) => reciprocal(&mut new, a),
                Instruction::Div(a, b) => {
                    let reciprocal = reciprocal(&mut new, b);
                    new.multiply(values[a], reciprocal)
                }
                other => new.other(other, other.operands().next().map(|operand| values[operand])),
            };
            values.push(value);
        }
        new.outputs = program.outputs.iter().map(|output| values[*output]).collect();
        new.labels = program.labels.iter().map(|(value, index)| (values[*value], *index)).collect();
        new.outputs.iter().for_each(|output| new.network.add_user(output.node));
        new.network.commit();
        new
    }

    fn multiply(&mut self, a: Signed, b: Signed) -> Signed {
        self.network.product(a.node, b.node).signed(a.minus != b.minus)
    }

    /// These have a user in any case: what computes nothing goes in the end.
    fn other(&mut self, instruction: Instruction, operand: Option<Signed>) -> Signed {
        let value = self.network.make(Operation::Other(self.others.len()));
        self.others.push((instruction, operand));
        self.is_number.resize(value.node + 1, false);
        self.is_number[value.node] = matches!(instruction, Instruction::Constant(_));
        [Some(value), operand].into_iter().flatten().for_each(|used| self.network.add_user(used.node));
        value
    }

    /// Puts a value in the place of a node that is equal to it.
    pub fn put(&mut self, node: Node, value: Signed) {
        for (node, value) in self.network.merge(node, value) {
            let operands = self.others.iter_mut().filter_map(|(_, operand)| operand.as_mut());
            let labelled = self.labels.iter_mut().map(|(labelled, _)| labelled);
            for used in operands.chain(&mut self.outputs).chain(labelled) {
                if used.node == node {
                    *used = value.signed(used.minus);
                }
            }
        }
    }

    /// The program, with labels for what is still there.
    pub fn into_program(self) -> Program {
        let mut program = Program::new(self.parameters);
        let mut values: Vec<Option<Value>> = vec![None; self.network.len()];
        // Depth first with a stack of our own: long programs must not exhaust the thread's.
        let mut stack: Vec<Node> = self.outputs.iter().rev().map(|output| output.node).collect();
        while let Some(&node) = stack.last() {
            let missing: Vec<Node> =
                self.operands(node).into_iter().filter(|operand| values[*operand].is_none()).collect();
            if values[node].is_none() && !missing.is_empty() {
                stack.extend(missing.into_iter().rev());
                continue;
            }
            stack.pop();
            if values[node].is_none() {
                values[node] = Some(self.compute(node, &mut program, |node| values[node].unwrap_or_default()));
            }
        }
        let signed = |program: &mut Program, Signed { node, minus }: Signed| {
            let value = values[node]?;
            Some(if minus { program.push(Instruction::Neg(value)) } else { value })
        };
        program.outputs = self.outputs.iter().filter_map(|output| signed(&mut program, *output)).collect();
        let kept = self.labels.iter().filter(|(label, _)| !label.minus && self.network.users(label.node) > 0);
        program.labels = kept.filter_map(|(label, index)| Some((values[label.node]?, *index))).collect();
        cse::eliminate(program)
    }

    fn operands(&self, node: Node) -> Vec<Node> {
        match self.network.operation(node).0 {
            Operation::Other(index) => self.others[index].1.iter().map(|operand| operand.node).collect(),
            operation => operation.operands().into_iter().flatten().collect(),
        }
    }

    fn compute(&self, node: Node, program: &mut Program, at: impl Fn(Node) -> Value) -> Value {
        let negated = |program: &mut Program, value: Value| program.push(Instruction::Neg(value));
        let (operation, minus) = self.network.operation(node);
        let value = match operation {
            Operation::Product(a, b) => program.push(Instruction::Mul(at(a), at(b))),
            Operation::Sum(a, b) => {
                let [first, second] = [a, b].map(|term| at(term.node));
                program.push(if b.minus { Instruction::Sub(first, second) } else { Instruction::Add(first, second) })
            }
            Operation::Other(index) => {
                let (instruction, operand) = self.others[index];
                let operand =
                    operand.map(|Signed { node, minus }| if minus { negated(program, at(node)) } else { at(node) });
                program.push(instruction.map(|_| operand.unwrap_or_default()))
            }
        };
        if minus { negated(program, value) } else { value }
    }
}
