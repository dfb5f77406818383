//! Minus signs move outward through sums, products and functions, where they cost nothing.

use rustc_hash::FxHashMap;

use super::cse::{self, Builder};
use crate::program::{Instruction, Program, Value};

/// A value, and whether it stands for its negative.
#[derive(Clone, Copy)]
struct Signed {
    negative: bool,
    value: Value,
}

/// Afterwards no instruction uses a negation or a negative constant; outputs may.
pub fn collect(program: Program) -> Program {
    let mut builder = Builder::new(program.parameters);
    let mut new: Vec<Signed> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let signed = signed(&mut builder, *instruction, &new);
        new.push(signed);
    }
    let plain: FxHashMap<Value, Value> =
        program.outputs.iter().map(|value| (*value, plain(&mut builder, new[*value]))).collect();
    let label = |value: Value| (!new[value].negative).then(|| new[value].value);
    cse::eliminate(builder.finish(&program, |value| plain[&value], label))
}

fn signed(builder: &mut Builder, instruction: Instruction, new: &[Signed]) -> Signed {
    let mut unary = |negative, instruction| Signed { negative, value: builder.push(instruction) };
    match instruction {
        Instruction::Parameter(_) => unary(false, instruction),
        Instruction::Constant(c) => unary(c < 0.0, Instruction::Constant(c.abs())),
        Instruction::Neg(a) => Signed { negative: !new[a].negative, ..new[a] },
        Instruction::Add(a, b) => sum(builder, new[a], new[b]),
        Instruction::Sub(a, b) => sum(builder, new[a], Signed { negative: !new[b].negative, ..new[b] }),
        Instruction::Mul(a, b) => product(builder, new[a], new[b]),
        Instruction::Div(a, b) => {
            unary(new[a].negative != new[b].negative, Instruction::Div(new[a].value, new[b].value))
        }
        Instruction::Square(a) => unary(false, Instruction::Square(new[a].value)),
        Instruction::Cos(a) => unary(false, Instruction::Cos(new[a].value)),
        Instruction::Reciprocal(a) => unary(new[a].negative, Instruction::Reciprocal(new[a].value)),
        Instruction::Sin(a) => unary(new[a].negative, Instruction::Sin(new[a].value)),
        Instruction::Tan(a) => unary(new[a].negative, Instruction::Tan(new[a].value)),
        Instruction::Power(a, n) => unary(new[a].negative && n % 2 != 0, Instruction::Power(new[a].value, n)),
        Instruction::Sqrt(a) => {
            let value = plain(builder, new[a]);
            Signed { negative: false, value: builder.push(Instruction::Sqrt(value)) }
        }
    }
}

fn sum(builder: &mut Builder, a: Signed, b: Signed) -> Signed {
    let zero = |side: Signed| builder.instruction(side.value) == Instruction::Constant(0.0);
    if zero(a) {
        return b;
    }
    if zero(b) {
        return a;
    }
    if a.negative == b.negative {
        return Signed { negative: a.negative, value: builder.push(Instruction::Add(a.value, b.value)) };
    }
    let (plus, minus) = if a.negative { (b, a) } else { (a, b) };
    // The opposite difference serves as well.
    match builder.find(Instruction::Sub(minus.value, plus.value)) {
        Some(value) => Signed { negative: true, value },
        None => Signed { negative: false, value: builder.push(Instruction::Sub(plus.value, minus.value)) },
    }
}

fn product(builder: &mut Builder, a: Signed, b: Signed) -> Signed {
    let negative = a.negative != b.negative;
    let one = |side: Signed| builder.instruction(side.value) == Instruction::Constant(1.0);
    let value = match (one(a), one(b)) {
        (true, _) => b.value,
        (_, true) => a.value,
        _ => builder.push(Instruction::Mul(a.value, b.value)),
    };
    Signed { negative, value }
}

/// The value itself, negated if need be.
fn plain(builder: &mut Builder, signed: Signed) -> Value {
    match builder.instruction(signed.value) {
        _ if !signed.negative => signed.value,
        Instruction::Constant(c) => builder.push(Instruction::Constant(-c)),
        // The opposite difference costs no more than the difference.
        Instruction::Sub(a, b) => builder.push(Instruction::Sub(b, a)),
        _ => builder.push(Instruction::Neg(signed.value)),
    }
}
