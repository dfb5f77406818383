//! Whether the kinetic energy of a parameter set is that of a mechanical system.

use crate::constant::{Constant, Constants, eliminate};
use crate::derivation::Derived;
use crate::matrix_name::MatrixName;
use crate::report::{Report, number};
use crate::states::States;
use crate::syntax::ParameterSet;

/// Reports a parameter set at which the mass matrix, if it is symmetric, is not positive definite; `values` are those of
/// all names there.
pub fn check_energy(derived: &Derived, set: &ParameterSet, values: &Constants, report: &mut Report) {
    let Derived { matrices, symmetric, .. } = derived;
    let Some((name, mass)) = matrices.iter().find(|(name, _)| *name == MatrixName::M) else { return };
    if mass.len() > 1 && !symmetric.contains(name) {
        return;
    }
    // A coordinate of first order has no kinetic energy.
    let moves: Vec<bool> = derived.states.iter().map(|states| *states != States::Position).collect();
    let entries = keep(mass, &moves).map(|row| keep(row, &moves).map(|entry| values.of(entry)).collect());
    // An entry without a value is reported where it is.
    let Ok(mut entries) = entries.collect::<Result<Vec<Vec<Constant>>, _>>() else { return };
    if let Some(row) = eliminate(&mut entries, Constant::is_positive_beside) {
        let (size, pivot) = (row + 1, number(entries[row][row].to_f64().unwrap_or(0.0)));
        let message = format!(
            "the mass matrix of the set `{}` is not positive definite: elimination leaves {pivot} as entry {size}, \
             {size}; expected > 0, as every motion has a kinetic energy",
            set.name,
        );
        report.error(&set.name, message);
    }
}

fn keep<'a, T>(items: &'a [T], kept: &'a [bool]) -> impl Iterator<Item = &'a T> {
    items.iter().zip(kept).filter(|(_, kept)| **kept).map(|(item, _)| item)
}
