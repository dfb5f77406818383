//! Whether the kinetic energy of every parameter set is that of a mechanical system.

use proc_macro2::Ident;

use crate::model::{Expr, Matrices, ParameterSet};
use crate::report::Report;
use crate::syntax::MatrixName;

/// Reports parameter sets at which a symmetric mass matrix is not positive definite.
///
/// Only for a declaration without mistakes.
pub fn check(sets: &[ParameterSet], definitions: &[(Ident, Expr)], matrices: &Matrices, report: &mut Report) {
    let Some((_, mass)) = matrices.iter().find(|(name, _)| *name == MatrixName::M) else { return };
    for set in sets {
        let mut values = Vec::with_capacity(definitions.len());
        for (_, definition) in definitions {
            values.push(definition.evaluate(&set.values, &values));
        }
        let mass: Vec<Vec<f64>> =
            mass.iter().map(|row| row.iter().map(|entry| entry.evaluate(&set.values, &values)).collect()).collect();
        if let Some((size, pivot)) = first_without_energy(mass) {
            let message = format!(
                "the mass matrix of the set `{}` is not positive definite: elimination leaves {pivot} as entry \
                 {size}, {size}; expected > 0, as every motion has a kinetic energy",
                set.name,
            );
            report.error(&set.name, message);
        }
    }
}

/// The first pivot of a symmetric matrix that is not positive, with its row from 1; none for other matrices.
fn first_without_energy(mut matrix: Vec<Vec<f64>>) -> Option<(usize, f64)> {
    let n = matrix.len();
    let differs = |row: usize, column: usize| matrix[row][column] != matrix[column][row];
    if (0..n).any(|row| (0..row).any(|column| differs(row, column))) {
        return None;
    }
    for pivot in 0..n {
        let value = matrix[pivot][pivot];
        if value <= 0.0 {
            return Some((pivot + 1, value));
        }
        let (done, rest) = matrix.split_at_mut(pivot + 1);
        for row in rest {
            let factor = row[pivot] / value;
            row.iter_mut().zip(&done[pivot]).skip(pivot + 1).for_each(|(entry, above)| *entry -= factor * above);
        }
    }
    None
}
