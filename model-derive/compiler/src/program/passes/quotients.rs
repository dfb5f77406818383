//! A reciprocal that one product uses becomes a division; values that divide several times become one reciprocal.

use rustc_hash::FxHashMap;

use super::cse::{self, Builder};
use crate::program::{Instruction, Program, Value};

/// Afterwards a reciprocal serves several products, or is an output, and no value divides more than once.
pub fn divide(program: Program) -> Program {
    let uses = program.uses();
    let mut divisions: FxHashMap<Value, usize> = FxHashMap::default();
    for instruction in &program.instructions {
        if let Instruction::Div(_, divisor) | Instruction::Reciprocal(divisor) = instruction {
            *divisions.entry(*divisor).or_default() += 1;
        }
    }
    let mut builder = Builder::new(program.parameters);
    let mut new: Vec<Value> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let single = |value: Value| match program.instructions[value] {
            Instruction::Reciprocal(divisor) if uses[value] == 1 && divisions[&divisor] == 1 => Some(new[divisor]),
            _ => None,
        };
        let value = match *instruction {
            Instruction::Mul(a, b) => match (single(a), single(b)) {
                (_, Some(divisor)) => builder.push(Instruction::Div(new[a], divisor)),
                (Some(divisor), None) => builder.push(Instruction::Div(new[b], divisor)),
                (None, None) => builder.push(Instruction::Mul(new[a], new[b])),
            },
            Instruction::Div(a, divisor) if divisions[&divisor] > 1 => {
                let reciprocal = builder.push(Instruction::Reciprocal(new[divisor]));
                builder.push(Instruction::Mul(new[a], reciprocal))
            }
            other => builder.push(other.map(|value| new[value])),
        };
        new.push(value);
    }
    cse::eliminate(builder.finish(&program, |value| new[value], |value| Some(new[value])))
}
