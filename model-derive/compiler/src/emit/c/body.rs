//! A program as the statements of a function of C.

use std::collections::HashSet;

use super::super::nesting::{Place, Strength, places};
use super::names::identifier;
use super::precision::Precision;
use super::template::wrap;
use crate::free_name::take_free_name;
use crate::program::{Instruction, Program, Value};

/// A program as statements, and each value as an expression.
pub struct Body {
    precision: Precision,
    /// Each with its semicolon.
    statements: Vec<String>,
    pub values: Vec<String>,
    /// What each value's expression is to the operators around it.
    strengths: Vec<Strength>,
    reads_parameters: bool,
}

impl Body {
    /// With `read` for the expression of a parameter, and `variable` for the name of a value; names that the function has
    /// for something else are `taken`.
    pub fn new(
        program: &Program,
        precision: Precision,
        taken: &[&str],
        read: impl Fn(usize) -> String,
        variable: impl Fn(Value) -> String,
    ) -> Self {
        let mut taken: HashSet<String> = taken.iter().map(ToString::to_string).collect();
        let mut names = vec![None; program.instructions.len()];
        let mut name = |value: Value| {
            names[value].get_or_insert_with(|| take_free_name(&identifier(&variable(value)), &mut taken)).clone()
        };
        let mut body = Self {
            precision,
            statements: Vec::new(),
            values: Vec::new(),
            strengths: Vec::new(),
            reads_parameters: false,
        };
        let number = precision.number();
        for (value, (&instruction, place)) in program.instructions.iter().zip(places(program)).enumerate() {
            match (place, instruction) {
                (_, Instruction::Parameter(index)) => {
                    body.reads_parameters = true;
                    body.push(read(index), Strength::Atom);
                    continue;
                }
                (Place::Nested, _) | (_, Instruction::Constant(_)) => {
                    let expression = body.expression(instruction);
                    body.push(expression, Strength::of(instruction));
                    continue;
                }
                (Place::Variable, _) => {
                    let expression = body.expression(instruction);
                    body.statements.push(format!("const {number} {} = {expression};", name(value)));
                }
                (Place::Pair { sine, cosine, is_first: true }, _) => {
                    let angle = instruction.operands().next().unwrap_or_else(|| unreachable!("functions have one"));
                    let (sine, cosine) = (name(sine), name(cosine));
                    let zero = precision.literal(0.0);
                    body.statements.push(format!("{number} {sine} = {zero};"));
                    body.statements.push(format!("{number} {cosine} = {zero};"));
                    body.statements.push(format!(
                        "carvallo_sin_cos_{}({}, &{sine}, &{cosine});",
                        precision.name(),
                        body.values[angle]
                    ));
                }
                (Place::Pair { .. }, _) => {}
            }
            body.push(name(value), Strength::Atom);
        }
        body
    }

    /// Whether there is a parameter in it: a function that reads none says so.
    pub fn reads_parameters(&self) -> bool {
        self.reads_parameters
    }

    /// The statements, each in as many lines as it needs, with so many spaces before them.
    pub fn statements(&self, indent: usize) -> String {
        self.statements.iter().map(|statement| wrap(statement, indent)).collect()
    }

    /// A value as an expression that is one whatever stands around it.
    pub fn atom(&self, value: Value) -> String {
        self.operand(value, Strength::Atom)
    }

    fn push(&mut self, expression: String, strength: Strength) {
        self.values.push(expression);
        self.strengths.push(strength);
    }

    /// A value as an operand: in parentheses unless nobody could doubt what belongs together.
    fn operand(&self, value: Value, needed: Strength) -> String {
        let (expression, strength) = (&self.values[value], self.strengths[value]);
        if strength == needed || strength == Strength::Atom { expression.clone() } else { format!("({expression})") }
    }

    fn expression(&self, instruction: Instruction) -> String {
        // Operators of one strength are applied from the left.
        let operation = |a, sign, b, strength| format!("{} {sign} {}", self.operand(a, strength), self.atom(b));
        let call = |function: String, argument: Value| format!("{function}({})", self.values[argument]);
        let precision = self.precision;
        match instruction {
            Instruction::Constant(value) => precision.literal(value),
            Instruction::Add(a, b) => operation(a, "+", b, Strength::Sum),
            Instruction::Sub(a, b) => operation(a, "-", b, Strength::Sum),
            Instruction::Mul(a, b) => operation(a, "*", b, Strength::Product),
            Instruction::Div(a, b) => operation(a, "/", b, Strength::Product),
            Instruction::Square(a) => operation(a, "*", a, Strength::Product),
            Instruction::Neg(a) => format!("-{}", self.atom(a)),
            Instruction::Reciprocal(a) => {
                format!("{} / {}", precision.literal(1.0), self.atom(a))
            }
            Instruction::Sqrt(a) => call(precision.function("sqrt"), a),
            Instruction::Sin(a) => call(format!("carvallo_sin_{}", precision.name()), a),
            Instruction::Cos(a) => call(format!("carvallo_cos_{}", precision.name()), a),
            // In double precision that of the platform, as in Rust.
            Instruction::Tan(a) => match precision {
                Precision::Double => call(precision.function("tan"), a),
                Precision::Single => call(format!("carvallo_tan_{}", precision.name()), a),
            },
            Instruction::Parameter(_) => unreachable!("they are read"),
            Instruction::Power(..) => unreachable!("the pass `powers` leaves none"),
        }
    }
}
