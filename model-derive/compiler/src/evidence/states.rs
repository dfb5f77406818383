//! Coordinates of which only the position or only the rate is a state.

use crate::derivation::Derived;
use crate::formula::Formula;
use crate::matrix_name::{MatrixName, Whole};
use crate::report::Report;
use crate::states::States;
use crate::syntax::Declaration;

/// Reports coordinates of which more is a state than is said: no acceleration of one of first order may matter, and no
/// position of one that matters by its rate. Reports those, too, whose motion nothing determines.
pub fn check_states(declaration: &Declaration, derived: &Derived, report: &mut Report) {
    for (column, coordinate) in declaration.coordinates.iter().enumerate() {
        let Some((span, states)) = coordinate.only else { continue };
        let name = &coordinate.name;
        let (what, word, absent): (_, _, &[MatrixName]) = match states {
            States::Both => continue,
            States::Position => ("acceleration", "position", &[MatrixName::M]),
            States::Rate => ("position", "rate", Whole::Stiffness.parts()),
        };
        for (matrix, row) in find_entries(derived, absent, column) {
            let message = format!(
                "`{name}` is said to matter by its {word} alone, but row {}, column {} of `{}` multiplies its {what}: expected \
                 0 there, or no `only {word}`",
                row + 1,
                column + 1,
                matrix.name()
            );
            let entry = declaration.find_declared(matrix).and_then(|declared| declared.rows.get(row)?.1.get(column));
            report.error(entry.map_or(span.into(), |entry| entry.region), message);
        }
        if states == States::Position && find_entries(derived, Whole::Damping.parts(), column).next().is_none() {
            let message = format!(
                "nothing multiplies the rate of `{name}`, which so has no motion of its own: expected an entry of its column of \
                 `C-1`, `C0` or `C1`"
            );
            report.error(span, message);
        }
    }
}

/// The entries of some matrices in a column that are not zero as they stand, each with its row.
fn find_entries<'a>(
    derived: &'a Derived,
    names: &'a [MatrixName],
    column: usize,
) -> impl Iterator<Item = (MatrixName, usize)> + 'a {
    let matrices = derived.matrices.iter().filter(|(name, _)| names.contains(name));
    matrices.flat_map(move |(name, rows)| {
        let is_there = move |row: &&Vec<Formula>| row.get(column).is_some_and(|entry| !entry.is_zero());
        rows.iter().enumerate().filter(move |(_, row)| is_there(row)).map(move |(row, _)| (*name, row))
    })
}
