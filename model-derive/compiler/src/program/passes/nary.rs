//! Programs with n-ary sums and products: associative chains of them are flattened, so that their parts can be chosen
//! anew.

use rustc_hash::FxHashMap;

use super::cse;
use crate::program::{Instruction, Program, Value};

/// The position of a node. Terms and factors are nodes, and no node depends on itself.
pub type Node = usize;

/// What computes a node.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// Terms, in order, each with whether it is subtracted.
    Sum(Vec<(Node, bool)>),
    /// Factors, in order.
    Product(Vec<Node>),
    /// An instruction that is neither, at this position of `others`, on other nodes.
    Other(usize),
}

/// A program in which a sum or product that is used once is part of the sum or product that uses it.
#[derive(Debug)]
pub struct NaryProgram {
    pub nodes: Vec<Operation>,
    others: Vec<Instruction>,
    outputs: Vec<Node>,
    labels: Vec<(Node, usize)>,
    parameters: usize,
}

/// A sum or product takes in no further one once it has so many operands: powers of powers would grow without end.
const MAX_OPERANDS: usize = 64;

impl NaryProgram {
    /// Flattens a program without whole powers and without equal instructions.
    pub fn flatten(program: &Program) -> Self {
        let uses = program.uses();
        let mut nary = Self {
            nodes: Vec::with_capacity(program.instructions.len()),
            others: Vec::new(),
            outputs: Vec::new(),
            labels: Vec::new(),
            parameters: program.parameters,
        };
        let (mut known, mut reciprocals) = (FxHashMap::default(), FxHashMap::default());
        let mut new: Vec<Node> = Vec::with_capacity(program.instructions.len());
        for instruction in &program.instructions {
            let whole = |value: Value| uses[value] > 1;
            let two = |value: Value| program.instructions[value] == Instruction::Constant(2.0);
            let operation = match *instruction {
                Instruction::Add(a, b) => nary.sum([(new[a], false, whole(a)), (new[b], false, whole(b))]),
                Instruction::Sub(a, b) => nary.sum([(new[a], false, whole(a)), (new[b], true, whole(b))]),
                // Twice a value is its sum with itself, of which one half may be part of another sum.
                Instruction::Mul(a, b) if two(a) => nary.sum([(new[b], false, true); 2]),
                Instruction::Mul(a, b) if two(b) => nary.sum([(new[a], false, true); 2]),
                Instruction::Mul(a, b) => nary.product([(new[a], whole(a)), (new[b], whole(b))]),
                Instruction::Square(a) => nary.product([(new[a], whole(a)); 2]),
                Instruction::Div(a, b) => {
                    let reciprocal = nary.reciprocal(new[b], &mut reciprocals);
                    nary.product([(new[a], whole(a)), (reciprocal, true)])
                }
                Instruction::Reciprocal(a) => {
                    new.push(nary.reciprocal(new[a], &mut reciprocals));
                    continue;
                }
                other => nary.other(other.map(|value| new[value])),
            };
            new.push(nary.push(operation, &mut known));
        }
        nary.outputs = program.outputs.iter().map(|value| new[*value]).collect();
        nary.labels = program.labels.iter().map(|(value, index)| (new[*value], *index)).collect();
        nary
    }

    fn push(&mut self, operation: Operation, known: &mut FxHashMap<Operation, Node>) -> Node {
        *known.entry(operation).or_insert_with_key(|operation| {
            self.nodes.push(operation.clone());
            self.nodes.len() - 1
        })
    }

    /// Of each divisor there is one reciprocal, whatever it divides.
    fn reciprocal(&mut self, divisor: Node, known: &mut FxHashMap<Node, Node>) -> Node {
        *known.entry(divisor).or_insert_with(|| {
            let operation = self.other(Instruction::Reciprocal(divisor));
            self.nodes.push(operation);
            self.nodes.len() - 1
        })
    }

    fn other(&mut self, instruction: Instruction) -> Operation {
        // Of the others no two are equal in a program without equal instructions.
        self.others.push(instruction);
        Operation::Other(self.others.len() - 1)
    }

    /// Of two nodes, each with whether it is subtracted, and whether it stays whole.
    fn sum(&self, sides: [(Node, bool, bool); 2]) -> Operation {
        let mut terms = Vec::new();
        for (node, minus, whole) in sides {
            match &self.nodes[node] {
                Operation::Sum(inner) if !whole && inner.len() < MAX_OPERANDS => {
                    terms.extend(inner.iter().map(|(term, inner)| (*term, *inner != minus)));
                }
                _ => terms.push((node, minus)),
            }
        }
        terms.sort_unstable();
        Operation::Sum(terms)
    }

    /// Of two nodes, each with whether it stays whole.
    fn product(&self, sides: [(Node, bool); 2]) -> Operation {
        let mut factors = Vec::new();
        for (node, whole) in sides {
            match &self.nodes[node] {
                Operation::Product(inner) if !whole && inner.len() < MAX_OPERANDS => factors.extend(inner),
                _ => factors.push(node),
            }
        }
        factors.sort_unstable();
        Operation::Product(factors)
    }

    /// The nodes that compute a node.
    fn operands(&self, node: Node) -> Vec<Node> {
        match &self.nodes[node] {
            Operation::Sum(terms) => terms.iter().map(|(term, _)| *term).collect(),
            Operation::Product(factors) => factors.clone(),
            Operation::Other(index) => self.others[*index].operands().collect(),
        }
    }

    /// Which nodes the outputs need: what became part of another sum or product is there, and not needed.
    pub fn needed(&self) -> Vec<bool> {
        let mut needed = vec![false; self.nodes.len()];
        self.outputs.iter().for_each(|node| needed[*node] = true);
        // As long as they are those of a program, no node comes before one that it depends on.
        for node in (0..needed.len()).rev() {
            if needed[node] {
                self.operands(node).into_iter().for_each(|operand| needed[operand] = true);
            }
        }
        needed
    }

    /// The program that applies each operation to two operands at a time.
    pub fn into_program(self) -> Program {
        let mut program = Program::new(self.parameters);
        let mut new: Vec<Option<Value>> = vec![None; self.nodes.len()];
        // Depth first with a stack of our own: long programs must not exhaust the thread's.
        let mut stack: Vec<Node> = self.outputs.iter().copied().rev().collect();
        while let Some(&node) = stack.last() {
            let missing: Vec<Node> =
                self.operands(node).into_iter().filter(|operand| new[*operand].is_none()).collect();
            if new[node].is_none() && !missing.is_empty() {
                stack.extend(missing.into_iter().rev());
                continue;
            }
            stack.pop();
            if new[node].is_none() {
                new[node] = Some(self.compute(node, &mut program, |operand| new[operand].unwrap_or_default()));
            }
        }
        program.outputs = self.outputs.iter().map(|node| new[*node].unwrap_or_default()).collect();
        // A definition that became part of a sum or product has no value of its own.
        program.labels = self.labels.iter().filter_map(|(node, index)| Some((new[*node]?, *index))).collect();
        cse::eliminate(program)
    }

    fn compute(&self, node: Node, program: &mut Program, at: impl Fn(Node) -> Value) -> Value {
        match &self.nodes[node] {
            Operation::Other(index) => program.push(self.others[*index].map(at)),
            Operation::Product(factors) => {
                let first = at(factors[0]);
                factors[1..].iter().fold(first, |so_far, factor| program.push(Instruction::Mul(so_far, at(*factor))))
            }
            Operation::Sum(terms) => {
                let (plus, minus): (Vec<_>, Vec<_>) = terms.iter().partition(|(_, minus)| !minus);
                let mut terms = plus.into_iter().chain(minus);
                let (first, negative) = terms.next().unwrap_or_else(|| unreachable!("a sum has terms"));
                let first = at(first);
                let first = if negative { program.push(Instruction::Neg(first)) } else { first };
                terms.fold(first, |so_far, (term, minus)| {
                    let term = at(term);
                    program.push(if minus { Instruction::Sub(so_far, term) } else { Instruction::Add(so_far, term) })
                })
            }
        }
    }
}
