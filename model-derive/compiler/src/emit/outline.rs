//! What can be had of a model with mistakes.

use std::collections::HashSet;

use crate::matrix_name::MatrixName;
use crate::model::Model;

/// The model without what would be a second mistake in its code: fields and constants of the same name.
pub fn sound(mut model: Model) -> Model {
    let mut names = HashSet::new();
    let first: Vec<bool> = model.parameters.iter().map(|parameter| names.insert(parameter.name.to_string())).collect();
    keep(&mut model.parameters, &first);
    model.sets.iter_mut().for_each(|set| keep(&mut set.values, &first));
    // Another parameter may stand at its position now.
    model.gravity = None;
    // A constant of this name would stand beside the one of the trait.
    let mut constants = HashSet::from(["INFO".to_string()]);
    model.sets.retain(|set| constants.insert(set.name.to_string().to_uppercase()));
    // Every model has one.
    if !model.matrices.iter().any(|(name, _)| *name == MatrixName::M) {
        model.matrices.insert(0, (MatrixName::M, Vec::new()));
    }
    model
}

fn keep<T>(items: &mut Vec<T>, kept: &[bool]) {
    let mut kept = kept.iter();
    items.retain(|_| kept.next().copied().unwrap_or(true));
}
