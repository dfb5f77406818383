//! Whether the kinetic energy of a parameter set is that of a mechanical system.

use std::collections::HashMap;

use crate::check::constants::Constant;
use crate::report::{Report, number};
use crate::syntax::{Declaration, MatrixName, ParameterSet};

/// Reports a parameter set at which the mass matrix, if it is symmetric, is not positive definite; `values` are those of
/// all names there.
pub fn check(declaration: &Declaration, set: &ParameterSet, values: &HashMap<String, Constant>, report: &mut Report) {
    let mass = declaration.matrices.iter().find(|matrix| matrix.name == MatrixName::M);
    let Some(mass) = mass.filter(|mass| mass.symmetric || mass.rows.len() == 1) else { return };
    let entries = mass.rows.iter().map(|(_, row)| row.iter().map(|entry| Constant::evaluate_with(entry, values)));
    // An entry without a value is reported where it is.
    let Ok(entries) = entries.map(Iterator::collect).collect::<Result<Vec<Vec<Constant>>, _>>() else { return };
    if let Some((size, pivot)) = first_without_energy(entries) {
        let pivot = number(pivot.to_f64().unwrap_or(0.0));
        let message = format!(
            "the mass matrix of the set `{}` is not positive definite: elimination leaves {pivot} as entry {size}, \
             {size}; expected > 0, as every motion has a kinetic energy",
            set.name,
        );
        report.error(&set.name, message);
    }
}

/// The first pivot of a symmetric matrix that is not positive, with its row from 1.
fn first_without_energy(mut matrix: Vec<Vec<Constant>>) -> Option<(usize, Constant)> {
    let diagonal: Vec<Constant> = matrix.iter().enumerate().map(|(index, row)| row[index].clone()).collect();
    for pivot in 0..matrix.len() {
        let value = matrix[pivot][pivot].clone();
        if !value.is_positive_beside(&diagonal[pivot]) {
            return Some((pivot + 1, value));
        }
        let (done, rest) = matrix.split_at_mut(pivot + 1);
        for row in rest {
            let factor = row[pivot].over(&value);
            for (entry, above) in row.iter_mut().zip(&done[pivot]).skip(pivot + 1) {
                *entry = entry.minus_product(&factor, above);
            }
        }
    }
    None
}
