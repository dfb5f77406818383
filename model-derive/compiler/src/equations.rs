//! What is left of a model for the symbolic stage: formulas in the parameters alone.

use crate::model::{Expr, Model};

/// Formulas to be evaluated together, as one program.
#[derive(Clone, Debug, PartialEq)]
pub struct Equations {
    /// The number of parameters.
    pub parameters: usize,
    /// Each uses only earlier ones.
    pub definitions: Vec<Expr>,
    /// What the program computes, in this order.
    pub outputs: Vec<Expr>,
}

impl Equations {
    /// The entries of the declared matrices, row by row.
    pub fn of_matrices(model: &Model) -> Self {
        Self::of(model, model.matrices.iter().flat_map(|(_, rows)| rows.iter().flatten()).cloned().collect())
    }

    /// The left-hand sides of the requirements.
    pub fn of_requirements(model: &Model) -> Self {
        Self::of(model, model.requirements.iter().map(|requirement| requirement.value.clone()).collect())
    }

    fn of(model: &Model, outputs: Vec<Expr>) -> Self {
        Self {
            parameters: model.parameters.len(),
            definitions: model.definitions.iter().map(|(_, expr)| expr.clone()).collect(),
            outputs,
        }
    }
}
