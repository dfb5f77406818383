//! Minus signs move outward through sums, products and functions, where they cost nothing.

use rustc_hash::FxHashMap;

use super::cse::{self, Builder};
use crate::program::{Counts, Instruction, Program, Value};

/// A value, and whether it stands for its negative.
#[derive(Clone, Copy)]
struct Signed {
    negative: bool,
    value: Value,
}

/// Afterwards no instruction uses a negation or a negative constant; outputs may.
pub fn collect(program: Program) -> Program {
    collect_with(&program, |_| false)
}

/// Longer programs are not looked at: that would take as many times as they have instructions.
const MAX_CHOSEN: usize = 200;

/// In how many rounds the instructions are looked at.
const ROUNDS: usize = 3;

/// The same, with the opposite of differences in their place where outputs need no negation then.
///
/// One opposite more may save nothing by itself, and something together with others: so it stays if it costs nothing.
pub fn choose(program: Program) -> Program {
    let cost = |program: &Program| Counts::of(program).cost();
    let mut best = collect(program.clone());
    if Counts::of(&best).negations == 0 || program.instructions.len() > MAX_CHOSEN {
        return best;
    }
    let mut opposite = vec![false; program.instructions.len()];
    let mut least = cost(&best);
    for value in (0..ROUNDS).flat_map(|_| 0..program.instructions.len()) {
        if !matches!(program.instructions[value], Instruction::Add(..) | Instruction::Sub(..)) {
            continue;
        }
        opposite[value] ^= true;
        let changed = collect_with(&program, |value| opposite[value]);
        let changed_cost = cost(&changed);
        if changed_cost > least {
            opposite[value] ^= true;
        } else if changed_cost < least {
            (best, least) = (changed, changed_cost);
        }
    }
    best
}

/// With the opposite of some of the differences.
fn collect_with(program: &Program, opposite: impl Fn(Value) -> bool) -> Program {
    let mut builder = Builder::new(program.parameters);
    let mut new: Vec<Signed> = Vec::with_capacity(program.instructions.len());
    for (value, instruction) in program.instructions.iter().enumerate() {
        let signed = signed(&mut builder, *instruction, &new, opposite(value));
        new.push(signed);
    }
    let plain: FxHashMap<Value, Value> =
        program.outputs.iter().map(|value| (*value, plain(&mut builder, new[*value]))).collect();
    let label = |value: Value| (!new[value].negative).then(|| new[value].value);
    cse::eliminate(builder.finish(program, |value| plain[&value], label))
}

fn signed(builder: &mut Builder, instruction: Instruction, new: &[Signed], opposite: bool) -> Signed {
    let mut unary = |negative, instruction| Signed { negative, value: builder.push(instruction) };
    match instruction {
        Instruction::Parameter(_) => unary(false, instruction),
        Instruction::Constant(c) => unary(c < 0.0, Instruction::Constant(c.abs())),
        Instruction::Neg(a) => Signed { negative: !new[a].negative, ..new[a] },
        Instruction::Add(a, b) => sum(builder, new[a], new[b], opposite),
        Instruction::Sub(a, b) => sum(builder, new[a], Signed { negative: !new[b].negative, ..new[b] }, opposite),
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

fn sum(builder: &mut Builder, a: Signed, b: Signed, opposite: bool) -> Signed {
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
    let [difference, negated] =
        [(plus, minus), (minus, plus)].map(|(plus, minus)| Instruction::Sub(plus.value, minus.value));
    // The opposite difference serves as well.
    let negative = builder.find(negated).is_some() || opposite && builder.find(difference).is_none();
    Signed { negative, value: builder.push(if negative { negated } else { difference }) }
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
