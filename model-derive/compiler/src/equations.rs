//! What is left of a model for the symbolic stage: formulas in the parameters alone.

use proc_macro2::Ident;

use crate::model::{Expr, Model};

/// Formulas to be evaluated together, as one program.
#[derive(Clone, Debug, PartialEq)]
pub struct Equations {
    /// The number of parameters.
    pub parameters: usize,
    /// Each uses only earlier ones.
    pub definitions: Vec<Expr>,
    /// For each definition its position in the model.
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
