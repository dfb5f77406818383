//! Which values of a program are written where they are used, and which have a variable: the same in every language.

use std::collections::HashMap;

use crate::program::{Instruction, Program, Value};

/// Where a value is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// In the expression that uses it.
    Nested,
    /// In a variable of its own.
    Variable,
    /// In a variable, as the sine or the cosine of an angle of which both are wanted: they come from one call.
    Pair {
        sine: Value,
        cosine: Value,
        /// Whether it is the earlier of the two, and stands for both.
        is_first: bool,
    },
}

/// How strongly an expression holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Strength {
    Sum,
    Product,
    Negation,
    /// Names, numbers and calls.
    Atom,
}

impl Strength {
    /// That of what an instruction is written as.
    pub fn of(instruction: Instruction) -> Self {
        match instruction {
            Instruction::Add(..) | Instruction::Sub(..) => Self::Sum,
            Instruction::Mul(..) | Instruction::Div(..) | Instruction::Square(_) | Instruction::Reciprocal(_) => {
                Self::Product
            }
            Instruction::Neg(_) => Self::Negation,
            _ => Self::Atom,
        }
    }
}

/// Values that are used once and have no name nest into the expression that uses them, up to this depth.
const MAX_DEPTH: usize = 6;

/// The place of each value.
pub fn places(program: &Program) -> Vec<Place> {
    let mut uses = program.uses();
    for instruction in &program.instructions {
        if let Instruction::Square(a) = instruction {
            // It is written twice.
            uses[*a] += 1;
        }
    }
    let mut named = vec![false; program.instructions.len()];
    for value in program.labels.iter().map(|(value, _)| value).chain(&program.outputs) {
        named[*value] = true;
    }
    let zeros =
        program.outputs.iter().filter(|value| program.instructions[**value] == Instruction::Constant(0.0)).count();
    let pairs = pairs(program);
    // How deep each value's expression nests; zero for names and numbers.
    let mut depths: Vec<usize> = Vec::new();
    let mut place = |(value, instruction): (Value, &Instruction)| {
        if let Instruction::Sin(angle) | Instruction::Cos(angle) = instruction
            && let Some(&(sine, cosine)) = pairs.get(angle)
        {
            depths.push(0);
            return Place::Pair { sine, cosine, is_first: value == sine.min(cosine) };
        }
        let depth = instruction.operands().map(|value| depths[value] + 1).max().unwrap_or(0);
        let repeated = *instruction == Instruction::Constant(0.0) && zeros > 1;
        if depth == 0 && !repeated || uses[value] == 1 && !named[value] && depth < MAX_DEPTH {
            depths.push(depth);
            Place::Nested
        } else {
            depths.push(0);
            Place::Variable
        }
    };
    program.instructions.iter().enumerate().map(&mut place).collect()
}

/// For each angle of which sine and cosine are both wanted, the values that they are.
fn pairs(program: &Program) -> HashMap<Value, (Value, Value)> {
    let instructions = || program.instructions.iter().enumerate();
    let sines: HashMap<Value, Value> = instructions()
        .filter_map(|(value, i)| if let Instruction::Sin(angle) = i { Some((*angle, value)) } else { None })
        .collect();
    instructions()
        .filter_map(|(value, instruction)| match instruction {
            Instruction::Cos(angle) => Some((*angle, (*sines.get(angle)?, value))),
            _ => None,
        })
        .collect()
}
