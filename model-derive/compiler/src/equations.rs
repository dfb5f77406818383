//! What is left of a model for the symbolic stage: formulas in the parameters alone.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use nanoserde::{DeBin, SerBin};

use crate::formula::{Decimal, Factor, Formula, Function, Term};
use crate::model::Model;
use crate::program::{Instruction, Program, Value};

/// Formulas to be evaluated together, as one program.
#[derive(Clone, Debug, DeBin, PartialEq, SerBin)]
pub struct Equations {
    /// The number of parameters.
    pub parameters: usize,
    /// Each uses only earlier ones.
    pub definitions: Vec<Formula>,
    /// For each definition its position in the model; behind those of the model if it is none of them.
    pub origins: Vec<usize>,
    /// What the program computes, in this order.
    pub outputs: Vec<Formula>,
}

impl Equations {
    /// The entries of the declared matrices, row by row.
    pub fn of_matrices(model: &Model) -> Self {
        Self::of_formulas(
            model.parameters.len(),
            model.formulas_of_definitions(),
            model.matrices.iter().flat_map(|(_, rows)| rows.iter().flatten()).cloned().collect(),
        )
    }

    /// The same of a mechanism, in formulas that are summed over its bodies.
    pub fn of_matrices_by_bodies(model: &Model) -> Option<Self> {
        let outputs = model.by_bodies.as_ref()?.iter().flat_map(|(_, rows)| rows.iter().flatten()).cloned().collect();
        Some(Self::of_formulas(model.parameters.len(), model.formulas_of_definitions(), outputs))
    }

    /// The left-hand sides of the requirements.
    pub fn of_requirements(model: &Model) -> Self {
        Self::of_formulas(
            model.parameters.len(),
            model.formulas_of_definitions(),
            model.requirements.iter().map(|requirement| requirement.value.clone()).collect(),
        )
    }

    /// The rates and forces that follow from a mechanism.
    pub fn of_kinematics(model: &Model) -> Option<Self> {
        let outputs = model.kinematics.as_ref()?.formulas().cloned().collect();
        Some(Self::of_formulas(model.parameters.len(), model.formulas_of_definitions(), outputs))
    }

    /// What a program of a model computes, with a definition for each value that is used more than once or has a name,
    /// and for each reciprocal, in which the derivatives of quotients are products.
    pub fn of_program(model: &Model, program: &Program) -> Self {
        let uses = program.uses();
        let labels: BTreeMap<Value, usize> = program.labels.iter().rev().copied().collect();
        let mut equations =
            Self { parameters: program.parameters, definitions: Vec::new(), origins: Vec::new(), outputs: Vec::new() };
        let mut reciprocals: BTreeMap<Value, Formula> = BTreeMap::new();
        let mut values: Vec<Formula> = Vec::with_capacity(program.instructions.len());
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
                Instruction::Div(dividend, divisor) => Formula::Product(vec![
                    Factor::times(values[dividend].clone()),
                    Factor::times(reciprocals[&divisor].clone()),
                ]),
                other => formula(other, &values),
            };
            let plain =
                matches!(formula, Formula::Parameter(_) | Formula::Definition(_) | Formula::Number(_) | Formula::Pi);
            let worth_a_name = !plain && (uses[value] > 1 || label.is_some());
            values.push(if worth_a_name { equations.define(formula, model, label) } else { formula });
        }
        equations.outputs = program.outputs.iter().map(|value| values[*value].clone()).collect();
        equations
    }

    /// Appends a definition, which may be one of the model, and returns what stands for its value.
    fn define(&mut self, formula: Formula, model: &Model, origin: Option<usize>) -> Formula {
        let position = self.definitions.len();
        self.definitions.push(formula);
        self.origins.push(origin.unwrap_or(model.definitions.len() + position));
        Formula::Definition(position)
    }

    /// Any formulas, with the definitions that they depend on, and no others.
    pub fn of_formulas<'a>(
        parameters: usize,
        definitions: impl IntoIterator<Item = &'a Formula>,
        outputs: Vec<Formula>,
    ) -> Self {
        let definitions: Vec<&Formula> = definitions.into_iter().collect();
        let mut needed = vec![false; definitions.len()];
        outputs.iter().flat_map(Formula::find_definitions).for_each(|index| needed[index] = true);
        // Each definition uses only earlier ones, so one way back finds them all.
        for (index, definition) in definitions.iter().enumerate().rev() {
            if needed[index] {
                definition.find_definitions().into_iter().for_each(|index| needed[index] = true);
            }
        }
        let origins: Vec<usize> = (0..needed.len()).filter(|index| needed[*index]).collect();
        let mut new = vec![0; needed.len()];
        for (position, origin) in origins.iter().enumerate() {
            new[*origin] = position;
        }
        Self {
            parameters,
            definitions: origins.iter().map(|origin| definitions[*origin].renumbered(&new)).collect(),
            origins,
            outputs: outputs.iter().map(|output| output.renumbered(&new)).collect(),
        }
    }
}

/// What an instruction computes, from what its operands do.
fn formula(instruction: Instruction, values: &[Formula]) -> Formula {
    let at = |value: Value| values[value].clone();
    let call = |function, value| Formula::Call(function, Box::new(at(value)));
    match instruction {
        Instruction::Parameter(index) => Formula::Parameter(index),
        Instruction::Constant(PI) => Formula::Pi,
        Instruction::Constant(value) => {
            let number = Formula::Number(Decimal::nearest(value.abs()));
            if value < 0.0 { Formula::Sum(vec![Term::minus(number)]) } else { number }
        }
        Instruction::Add(a, b) => Formula::Sum(vec![Term::plus(at(a)), Term::plus(at(b))]),
        Instruction::Sub(a, b) => Formula::Sum(vec![Term::plus(at(a)), Term::minus(at(b))]),
        Instruction::Mul(a, b) => Formula::Product(vec![Factor::times(at(a)), Factor::times(at(b))]),
        Instruction::Div(a, b) => Formula::Product(vec![Factor::times(at(a)), Factor::over(at(b))]),
        Instruction::Neg(a) => Formula::Sum(vec![Term::minus(at(a))]),
        Instruction::Square(a) => Formula::Power(Box::new(at(a)), 2),
        Instruction::Reciprocal(a) => Formula::Product(vec![Factor::times(Formula::one()), Factor::over(at(a))]),
        Instruction::Power(a, exponent) => Formula::Power(Box::new(at(a)), exponent),
        Instruction::Sqrt(a) => call(Function::Sqrt, a),
        Instruction::Sin(a) => call(Function::Sin, a),
        Instruction::Cos(a) => call(Function::Cos, a),
        Instruction::Tan(a) => call(Function::Tan, a),
    }
}
