//! Whether the kinetic energy of a parameter set is that of a mechanical system.

use crate::constant::{Constant, Constants};
use crate::derivation::Derived;
use crate::matrix_name::MatrixName;
use crate::report::{Report, number};
use crate::syntax::ParameterSet;

/// Reports a parameter set at which the mass matrix, if it is symmetric, is not positive definite; `values` are those of
/// all names there.
pub fn check_energy(derived: &Derived, set: &ParameterSet, values: &Constants<'_>, report: &mut Report) {
    let Derived { matrices, symmetric, .. } = derived;
    let Some((name, mass)) = matrices.iter().find(|(name, _)| *name == MatrixName::M) else { return };
    if mass.len() > 1 && !symmetric.contains(name) {
        return;
    }
    let entries = mass.iter().map(|row| row.iter().map(|entry| values.of(entry)).collect());
    // An entry without a value is reported where it is.
    let Ok(entries) = entries.collect::<Result<Vec<Vec<Constant>>, _>>() else { return };
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
