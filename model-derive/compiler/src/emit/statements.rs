//! A program as text: statements for the runtime to read, of names with numbers and without blanks, as short as they may be.

use super::nesting::{Place, Strength, places};
use crate::program::{Instruction, Program, Value};

/// As long as a line may be that has more than one statement.
const WIDTH: usize = 108;

/// The statements of a program, one behind the other in lines: `T0=A1*A2;R0=T0+A3`. What it reads is called as `read` says, what
/// it computes by a letter and its place among the outputs.
pub fn write(program: &Program, read: impl Fn(usize) -> String, output: char) -> Vec<String> {
    let mut text = Text { values: Vec::new(), strengths: Vec::new() };
    let mut statements: Vec<String> = Vec::new();
    let mut others = 0..;
    let mut stands: Vec<bool> = vec![false; program.outputs.len()];
    for (value, (&instruction, place)) in program.instructions.iter().zip(places(program)).enumerate() {
        let (expression, strength) = match instruction {
            Instruction::Parameter(index) => (read(index), Strength::Atom),
            other => (text.expression(other), strength(other)),
        };
        if place == Place::Nested {
            text.push(expression, strength);
            continue;
        }
        let of_output = program.outputs.iter().position(|output| *output == value);
        let name = match of_output {
            Some(place) => {
                stands[place] = true;
                format!("{output}{place}")
            }
            None => format!("T{}", others.next().unwrap_or_default()),
        };
        statements.push(format!("{name}={expression}"));
        text.push(name, Strength::Atom);
    }
    // What is read or computed already, and numbers.
    for (place, value) in program.outputs.iter().enumerate().filter(|(place, _)| !stands[*place]) {
        statements.push(format!("{output}{place}={}", text.values[*value]));
    }
    fill(&statements)
}

/// Statements in lines.
fn fill(statements: &[String]) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for statement in statements {
        match lines.last_mut() {
            Some(line) if line.len() + statement.len() < WIDTH => {
                line.push(';');
                line.push_str(statement);
            }
            _ => lines.push(statement.clone()),
        }
    }
    lines
}

/// How strongly an instruction holds together as it is written here: negative numbers have a sign.
fn strength(instruction: Instruction) -> Strength {
    match instruction {
        Instruction::Constant(value) if value < 0.0 => Strength::Negation,
        other => Strength::of(other),
    }
}

/// Each value as an expression, with what it is to the operators around it.
struct Text {
    values: Vec<String>,
    strengths: Vec<Strength>,
}

impl Text {
    fn push(&mut self, value: String, strength: Strength) {
        self.values.push(value);
        self.strengths.push(strength);
    }

    fn operand(&self, value: Value, needed: Strength) -> String {
        let text = &self.values[value];
        if self.strengths[value] >= needed { text.clone() } else { format!("({text})") }
    }

    fn expression(&self, instruction: Instruction) -> String {
        let sum =
            |a, sign, b| format!("{}{sign}{}", self.operand(a, Strength::Sum), self.operand(b, Strength::Product));
        let product =
            |a, sign, b| format!("{}{sign}{}", self.operand(a, Strength::Product), self.operand(b, Strength::Atom));
        let call = |function: &str, argument: Value| format!("{function}({})", self.values[argument]);
        match instruction {
            Instruction::Constant(value) => format!("{value:?}"),
            Instruction::Add(a, b) => sum(a, "+", b),
            Instruction::Sub(a, b) => sum(a, "-", b),
            Instruction::Mul(a, b) => product(a, "*", b),
            Instruction::Div(a, b) => product(a, "/", b),
            Instruction::Square(a) => format!("{}^2", self.operand(a, Strength::Atom)),
            Instruction::Neg(a) => format!("-{}", self.operand(a, Strength::Atom)),
            Instruction::Reciprocal(a) => format!("1/{}", self.operand(a, Strength::Atom)),
            Instruction::Sqrt(a) => call("sqrt", a),
            Instruction::Sin(a) => call("sin", a),
            Instruction::Cos(a) => call("cos", a),
            Instruction::Tan(a) => call("tan", a),
            Instruction::Parameter(_) => unreachable!("they are read"),
            Instruction::Power(..) => unreachable!("the pass `powers` leaves none"),
        }
    }
}
