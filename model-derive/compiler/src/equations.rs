//! What is left of a model for the symbolic stage: formulas in the parameters alone.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use proc_macro2::Ident;

use crate::model::{Expr, Function, Model};
use crate::program::{Instruction, Program, Value};
use crate::syntax::Decimal;

/// Formulas to be evaluated together, as one program.
#[derive(Clone, Debug, PartialEq)]
pub struct Equations {
    /// The number of parameters.
    pub parameters: usize,
    /// Each uses only earlier ones.
    pub definitions: Vec<Expr>,
    /// For each definition its position in the model; behind those of the model if it is none of them.
    pub origins: Vec<usize>,
    /// What the program computes, in this order.
    pub outputs: Vec<Expr>,
}

impl Equations {
    /// The entries of the declared matrices, row by row.
    pub fn of_matrices(model: &Model) -> Self {
        Self::of_formulas(
            model.parameters.len(),
            &model.definitions,
            model.matrices.iter().flat_map(|(_, rows)| rows.iter().flatten()).cloned().collect(),
        )
    }

    /// The left-hand sides of the requirements.
    pub fn of_requirements(model: &Model) -> Self {
        Self::of_formulas(
            model.parameters.len(),
            &model.definitions,
            model.requirements.iter().map(|requirement| requirement.value.clone()).collect(),
        )
    }

    /// The rates and forces that follow from a mechanism.
    pub fn of_kinematics(model: &Model) -> Option<Self> {
        let outputs = model.kinematics.as_ref()?.formulas().cloned().collect();
        Some(Self::of_formulas(model.parameters.len(), &model.definitions, outputs))
    }

    /// What a program of a model computes, with a definition for each value that is used more than once or has a name,
    /// and for each reciprocal, in which the derivatives of quotients are products.
    pub fn of_program(model: &Model, program: &Program) -> Self {
        let uses = program.uses();
        let labels: BTreeMap<Value, usize> = program.labels.iter().rev().copied().collect();
        let mut equations =
            Self { parameters: program.parameters, definitions: Vec::new(), origins: Vec::new(), outputs: Vec::new() };
        let mut reciprocals: BTreeMap<Value, Expr> = BTreeMap::new();
        let mut values: Vec<Expr> = Vec::with_capacity(program.instructions.len());
        for (value, &instruction) in program.instructions.iter().enumerate() {
            let label = labels.get(&value).copied();
            if let Instruction::Reciprocal(divisor) | Instruction::Div(_, divisor) = instruction
                && !reciprocals.contains_key(&divisor)
            {
                let label = label.filter(|_| matches!(instruction, Instruction::Reciprocal(_)));
                let formula = formula(Instruction::Reciprocal(divisor), &values);
                reciprocals.insert(divisor, equations.define(formula, model, label));
            }
            let formula = match instruction {
                Instruction::Reciprocal(divisor) => reciprocals[&divisor].clone(),
                Instruction::Div(dividend, divisor) => {
                    Expr::Product(vec![(false, values[dividend].clone()), (false, reciprocals[&divisor].clone())])
                }
                other => formula(other, &values),
            };
            let plain = matches!(formula, Expr::Parameter(_) | Expr::Definition(_) | Expr::Number(_) | Expr::Pi);
            let worth_a_name = !plain && (uses[value] > 1 || label.is_some());
            values.push(if worth_a_name { equations.define(formula, model, label) } else { formula });
        }
        equations.outputs = program.outputs.iter().map(|value| values[*value].clone()).collect();
        equations
    }

    /// Appends a definition, which may be one of the model, and returns what stands for its value.
    fn define(&mut self, formula: Expr, model: &Model, origin: Option<usize>) -> Expr {
        let position = self.definitions.len();
        self.definitions.push(formula);
        self.origins.push(origin.unwrap_or(model.definitions.len() + position));
        Expr::Definition(position)
    }

    /// Any formulas, with the definitions that they depend on, and no others.
    pub fn of_formulas(parameters: usize, definitions: &[(Ident, Expr)], outputs: Vec<Expr>) -> Self {
        let mut needed = vec![false; definitions.len()];
        outputs.iter().for_each(|output| mark(output, &mut needed));
        // Each definition uses only earlier ones, so one way back finds them all.
        for (index, (_, expr)) in definitions.iter().enumerate().rev() {
            if needed[index] {
                mark(expr, &mut needed);
            }
        }
        let origins: Vec<usize> = (0..needed.len()).filter(|index| needed[*index]).collect();
        let mut new = vec![0; needed.len()];
        for (position, origin) in origins.iter().enumerate() {
            new[*origin] = position;
        }
        Self {
            parameters,
            definitions: origins.iter().map(|origin| definitions[*origin].1.renumbered(&new)).collect(),
            origins,
            outputs: outputs.iter().map(|output| output.renumbered(&new)).collect(),
        }
    }
}

fn mark(expr: &Expr, needed: &mut [bool]) {
    expr.walk(&mut |part| {
        if let Expr::Definition(index) = part {
            needed[*index] = true;
        }
    });
}

/// What an instruction computes, from what its operands do.
fn formula(instruction: Instruction, values: &[Expr]) -> Expr {
    let at = |value: Value| values[value].clone();
    let call = |function, value| Expr::Call(function, Box::new(at(value)));
    match instruction {
        Instruction::Parameter(index) => Expr::Parameter(index),
        Instruction::Constant(PI) => Expr::Pi,
        Instruction::Constant(value) => {
            let number = Expr::Number(Decimal::nearest(value.abs()));
            if value < 0.0 { Expr::Sum(vec![(true, number)]) } else { number }
        }
        Instruction::Add(a, b) => Expr::Sum(vec![(false, at(a)), (false, at(b))]),
        Instruction::Sub(a, b) => Expr::Sum(vec![(false, at(a)), (true, at(b))]),
        Instruction::Mul(a, b) => Expr::Product(vec![(false, at(a)), (false, at(b))]),
        Instruction::Div(a, b) => Expr::Product(vec![(false, at(a)), (true, at(b))]),
        Instruction::Neg(a) => Expr::Sum(vec![(true, at(a))]),
        Instruction::Square(a) => Expr::Power(Box::new(at(a)), 2),
        Instruction::Reciprocal(a) => Expr::Product(vec![(false, Expr::one()), (true, at(a))]),
        Instruction::Power(a, exponent) => Expr::Power(Box::new(at(a)), exponent),
        Instruction::Sqrt(a) => call(Function::Sqrt, a),
        Instruction::Sin(a) => call(Function::Sin, a),
        Instruction::Cos(a) => call(Function::Cos, a),
        Instruction::Tan(a) => call(Function::Tan, a),
    }
}
