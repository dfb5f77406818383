//! The engine's instructions to a [`Program`]: slots, which are written again and again, become single assignments.

use std::collections::HashMap;

use symbolica::atom::Symbol;
use symbolica::domains::float::Complex;
use symbolica::domains::rational::Rational;
use symbolica::evaluate::{ExportedInstructions, Instruction as Exported, Slot};
use symbolica::transcendental::{cot, csc, sec, tan};

use crate::program::{Instruction, Program, Value};

/// Appends the exported instructions to a program, with `inputs` in the place of the engine's parameters, and returns
/// the values of the outputs.
///
/// # Panics
/// On an instruction that no formula of the declaration language leads to; the door reports that as its failure.
pub fn append(
    program: &mut Program,
    exported: &ExportedInstructions<Complex<Rational>>,
    inputs: &[Value],
) -> Vec<Value> {
    let constants = exported.constants.iter().map(to_f64).collect();
    let mut slots = Slots { program, inputs, constants, values: HashMap::new() };
    for instruction in &exported.instructions {
        slots.run(instruction);
    }
    (0..exported.output_count).map(|index| slots.get(Slot::Out(index))).collect()
}

struct Slots<'a> {
    program: &'a mut Program,
    inputs: &'a [Value],
    constants: Vec<f64>,
    /// What each temporary and output slot holds now.
    values: HashMap<Slot, Value>,
}

impl Slots<'_> {
    fn get(&mut self, slot: Slot) -> Value {
        match slot {
            Slot::Param(index) => self.inputs[index],
            Slot::Const(index) => self.program.push(Instruction::Constant(self.constants[index])),
            Slot::Temp(_) | Slot::Out(_) => self.values[&slot],
        }
    }

    fn chain(&mut self, arguments: &[Slot], join: fn(Value, Value) -> Instruction) -> Value {
        let mut result = self.get(arguments[0]);
        for argument in &arguments[1..] {
            let next = self.get(*argument);
            result = self.program.push(join(result, next));
        }
        result
    }

    fn run(&mut self, instruction: &Exported) {
        let (target, value) = match instruction {
            Exported::Add(out, arguments, _) => (*out, self.chain(arguments, Instruction::Add)),
            Exported::Mul(out, arguments, _) => (*out, self.chain(arguments, Instruction::Mul)),
            Exported::Pow(out, base, exponent, _) => {
                let base = self.get(*base);
                let exponent = i32::try_from(*exponent).expect("a power within the limits of the syntax");
                (*out, self.program.push(Instruction::Power(base, exponent)))
            }
            Exported::Powf(out, base, exponent, _) => (*out, self.root(*base, *exponent)),
            Exported::Fun(out, call, _) => {
                let argument = self.get(call.2[0]);
                (*out, self.call(call.0, argument))
            }
            Exported::Assign(out, from) => (*out, self.get(*from)),
            other => panic!("an instruction that formulas do not lead to: {other:?}"),
        };
        self.values.insert(target, value);
    }

    /// A power whose exponent is no whole number, as nested roots have: its whole part, times a root for each binary
    /// digit behind the point.
    fn root(&mut self, base: Slot, exponent: Slot) -> Value {
        let Slot::Const(index) = exponent else { panic!("a power with a variable exponent") };
        let exponent = self.constants[index];
        let mut root = self.get(base);
        let (whole, mut rest) = (exponent.abs().trunc(), exponent.abs().fract());
        let mut result = match whole as i32 {
            0 => None,
            1 => Some(root),
            whole => Some(self.program.push(Instruction::Power(root, whole))),
        };
        while rest != 0.0 {
            root = self.program.push(Instruction::Sqrt(root));
            rest *= 2.0;
            if rest >= 1.0 {
                rest -= 1.0;
                result = Some(result.map_or(root, |so_far| self.program.push(Instruction::Mul(so_far, root))));
            }
        }
        let Some(value) = result else { panic!("a power of {exponent}") };
        if exponent < 0.0 { self.program.push(Instruction::Reciprocal(value)) } else { value }
    }

    fn call(&mut self, function: Symbol, argument: Value) -> Value {
        let direct = [
            (Symbol::SIN, Instruction::Sin as fn(Value) -> Instruction),
            (Symbol::COS, Instruction::Cos),
            (tan(), Instruction::Tan),
            (Symbol::SQRT, Instruction::Sqrt),
        ];
        let inverse = [
            (csc(), Instruction::Sin as fn(Value) -> Instruction),
            (sec(), Instruction::Cos),
            (cot(), Instruction::Tan),
        ];
        if let Some((_, make)) = direct.iter().find(|(symbol, _)| *symbol == function) {
            return self.program.push(make(argument));
        }
        if let Some((_, make)) = inverse.iter().find(|(symbol, _)| *symbol == function) {
            let value = self.program.push(make(argument));
            return self.program.push(Instruction::Reciprocal(value));
        }
        panic!("a function that formulas do not lead to: {function}")
    }
}

/// The nearest `f64` of an exact constant.
///
/// # Panics
/// If there is none.
fn to_f64(constant: &Complex<Rational>) -> f64 {
    assert!(constant.im.is_zero(), "a constant in a formula is not real");
    let value = constant.re.to_f64();
    assert!(value.is_finite() && (value != 0.0 || constant.re.is_zero()), "a constant is beyond the range of f64");
    value
}
