//! Whole powers to squares, products and reciprocals.

use super::cse::{self, Builder};
use crate::program::{Instruction, Program, Value};

/// Afterwards the program has no `Power`.
pub fn expand(program: Program) -> Program {
    let program = cse::eliminate(program);
    let mut builder = Builder::new(program.parameters);
    let mut new: Vec<Value> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        new.push(match instruction.map(|value| new[value]) {
            Instruction::Power(base, exponent) => power(&mut builder, base, exponent),
            other => builder.push(other),
        });
    }
    let program = builder.finish(&program, |value| new[value], |value| Some(new[value]));
    debug_assert!(!program.instructions.iter().any(|i| matches!(i, Instruction::Power(..))));
    program
}

/// By repeated squaring, shared with other powers of the same base.
fn power(builder: &mut Builder, base: Value, exponent: i32) -> Value {
    let mut square = base;
    let mut rest = exponent.unsigned_abs();
    let mut result = None;
    while rest > 0 {
        if rest % 2 == 1 {
            result = Some(result.map_or(square, |so_far| builder.push(Instruction::Mul(so_far, square))));
        }
        rest /= 2;
        if rest > 0 {
            square = builder.push(Instruction::Square(square));
        }
    }
    match result {
        None => builder.push(Instruction::Constant(1.0)),
        Some(value) if exponent < 0 => builder.push(Instruction::Reciprocal(value)),
        Some(value) => value,
    }
}
