//! Common subexpressions are computed once, and what no output needs goes: value numbering over the instructions of a
//! straight-line program, and elimination of dead code.

use std::mem::{Discriminant, discriminant};

use rustc_hash::FxHashMap;

use crate::program::{Instruction, Program, Value};

/// Appends instructions to a program; one that is there already is not repeated.
pub struct Builder {
    program: Program,
    known: FxHashMap<Key, Value>,
}

/// An instruction as a key: constants by their bits, operands that commute in order.
#[derive(PartialEq, Eq, Hash)]
enum Key {
    Constant(u64),
    Other(Discriminant<Instruction>, i64, i64),
}

fn key(instruction: Instruction) -> Key {
    let (first, second) = match instruction {
        Instruction::Constant(value) => return Key::Constant(value.to_bits()),
        Instruction::Parameter(index) => (index as i64, -1),
        Instruction::Add(a, b) | Instruction::Mul(a, b) => (a.min(b) as i64, a.max(b) as i64),
        Instruction::Sub(a, b) | Instruction::Div(a, b) => (a as i64, b as i64),
        Instruction::Power(a, n) => (a as i64, i64::from(n)),
        Instruction::Neg(a)
        | Instruction::Square(a)
        | Instruction::Reciprocal(a)
        | Instruction::Sqrt(a)
        | Instruction::Sin(a)
        | Instruction::Cos(a)
        | Instruction::Tan(a) => (a as i64, -1),
    };
    Key::Other(discriminant(&instruction), first, second)
}

impl Builder {
    /// Without instructions, for so many parameters.
    pub fn new(parameters: usize) -> Self {
        Self { program: Program::new(parameters), known: FxHashMap::default() }
    }

    /// The value of an instruction, computed once.
    pub fn push(&mut self, instruction: Instruction) -> Value {
        // A product of a value with itself is its square.
        let instruction = match instruction {
            Instruction::Mul(a, b) if a == b => Instruction::Square(a),
            other => other,
        };
        *self.known.entry(key(instruction)).or_insert_with(|| self.program.push(instruction))
    }

    /// The value of an instruction, if it was computed already.
    pub fn find(&self, instruction: Instruction) -> Option<Value> {
        self.known.get(&key(instruction)).copied()
    }

    /// What computes a value.
    pub fn instruction(&self, value: Value) -> Instruction {
        self.program.instructions[value]
    }

    /// What there is so far.
    pub fn program(&self) -> &Program {
        &self.program
    }

    /// The program, with the outputs and labels of the old one at their new values; labels may lose theirs.
    pub fn finish(
        mut self,
        old: &Program,
        output: impl Fn(Value) -> Value,
        label: impl Fn(Value) -> Option<Value>,
    ) -> Program {
        self.program.outputs = old.outputs.iter().map(|value| output(*value)).collect();
        self.program.labels = old.labels.iter().filter_map(|(value, index)| Some((label(*value)?, *index))).collect();
        self.program
    }
}

/// Afterwards no two instructions are equal, and every value is used.
pub fn eliminate(program: Program) -> Program {
    let mut used = vec![false; program.instructions.len()];
    program.outputs.iter().for_each(|value| used[*value] = true);
    for (value, instruction) in program.instructions.iter().enumerate().rev() {
        if used[value] {
            instruction.operands().for_each(|operand| used[operand] = true);
        }
    }
    let mut builder = Builder::new(program.parameters);
    let mut new: Vec<Value> = Vec::with_capacity(program.instructions.len());
    for (value, instruction) in program.instructions.iter().enumerate() {
        new.push(if used[value] { builder.push(instruction.map(|operand| new[operand])) } else { 0 });
    }
    builder.finish(&program, |value| new[value], |value| used[value].then(|| new[value]))
}
