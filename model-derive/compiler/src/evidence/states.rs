//! Which positions and rates of the coordinates are states: what is said of it, and of the others what is proved.

use super::samples::Samples;
use super::zero::is_zero;
use crate::check::Checked;
use crate::derivation::Derived;
use crate::formula::Formula;
use crate::matrix_name::{MatrixName, Whole};
use crate::report::Report;
use crate::states::States;
use crate::syntax::{Coordinate, Declaration};

/// Settles which positions and rates are states. A coordinate is one of first order if its column of M is proved to be zero,
/// and matters by its rate alone if that of every stiffness matrix is: what is proved to be zero there is zero from here on.
///
/// Reports coordinates of which more is a state than is said, or less, and those whose motion nothing determines.
pub fn settle_states(checked: &Checked<'_>, mut derived: Derived, report: &mut Report) -> Derived {
    let declaration = checked.declaration;
    let samples = Samples::new(&checked.domains, &derived.definitions);
    for (column, coordinate) in declaration.coordinates.iter().enumerate() {
        let has_acceleration = !proves_zero(&mut derived, &[MatrixName::M], column, &samples);
        let has_position = !proves_zero(&mut derived, Whole::Stiffness.parts(), column, &samples);
        let Some((_, said)) = coordinate.only else {
            derived.states[column] = match derived.states[column] {
                States::Both if !has_acceleration => States::Position,
                States::Both if !has_position => States::Rate,
                known => known,
            };
            continue;
        };
        match said {
            States::Position if has_acceleration => {
                report_entries(declaration, &derived, column, &[MatrixName::M], "position", "acceleration", report);
            }
            States::Rate if has_position => {
                report_entries(declaration, &derived, column, Whole::Stiffness.parts(), "rate", "position", report);
            }
            States::Rate | States::Both if !has_acceleration => report_no_acceleration(coordinate, said, report),
            _ => {}
        }
    }
    if report.is_empty() {
        report_undetermined(declaration, &mut derived, &samples, report);
    }
    derived
}

/// Whether the column of some matrices is zero for all parameters; what is proved to be is replaced by zero if all of it is.
fn proves_zero(derived: &mut Derived, names: &[MatrixName], column: usize, samples: &Samples) -> bool {
    if !find_entries(derived, names, column).all(|(_, _, entry)| is_zero(entry, samples, derived)) {
        return false;
    }
    let matrices = derived.matrices.iter_mut().filter(|(name, _)| names.contains(name));
    matrices
        .flat_map(|(_, rows)| rows)
        .filter_map(|row| row.get_mut(column))
        .for_each(|entry| *entry = Formula::zero());
    true
}

/// Reports what multiplies a state that there is not to be.
fn report_entries(
    declaration: &Declaration,
    derived: &Derived,
    column: usize,
    names: &[MatrixName],
    word: &str,
    what: &str,
    report: &mut Report,
) {
    let coordinate = &declaration.coordinates[column];
    let (name, span) = (&coordinate.name, coordinate.only.map_or(coordinate.name.span(), |(span, _)| span));
    for (matrix, row, _) in find_entries(derived, names, column) {
        let message = format!(
            "`{name}` is said to matter by its {word} alone, but row {}, column {} of `{}` multiplies its {what}: expected 0 \
             there, or no `only {word}`",
            row + 1,
            column + 1,
            matrix.name()
        );
        let entry = declaration.find_declared(matrix).and_then(|declared| declared.rows.get(row)?.1.get(column));
        report.error(entry.map_or(span.into(), |entry| entry.region), message);
    }
}

/// Reports that a coordinate whose rate is said to be a state is one of first order.
fn report_no_acceleration(Coordinate { name, only, .. }: &Coordinate, said: States, report: &mut Report) {
    let Some((span, _)) = only else { return };
    let (what, word) = match said {
        States::Both => ("to have its position and its rate as states", "both"),
        _ => ("to matter by its rate alone", "only rate"),
    };
    let message = format!(
        "`{name}` is said {what}, but nothing multiplies its acceleration, so that its rate is no state: expected an entry in \
         its column of `M`, or no `{word}`"
    );
    report.error(*span, message);
}

/// Reports coordinates and equations that leave the motion undetermined at all parameters: coordinates of first order without
/// a rate, and equations without an acceleration and without the rate of a coordinate of first order.
fn report_undetermined(declaration: &Declaration, derived: &mut Derived, samples: &Samples, report: &mut Report) {
    let is_first_order: Vec<bool> = derived.states.iter().map(|states| *states == States::Position).collect();
    for (column, Coordinate { name, only, .. }) in declaration.coordinates.iter().enumerate() {
        if is_first_order[column] && proves_zero(derived, Whole::Damping.parts(), column, samples) {
            let message = format!(
                "nothing multiplies the rate of `{name}`, which so has no motion of its own: expected an entry of its column of \
                 `C-1`, `C0` or `C1`"
            );
            report.error(only.map_or(name.span(), |(span, _)| span), message);
        }
    }
    if !report.is_empty() {
        return;
    }
    for (row, Coordinate { name, .. }) in declaration.coordinates.iter().enumerate() {
        let determines = |column: usize| {
            let names = if is_first_order[column] { Whole::Damping.parts() } else { &[MatrixName::M] };
            find_entries(derived, names, column).any(|(_, at, entry)| at == row && !is_zero(entry, samples, derived))
        };
        if !(0..is_first_order.len()).any(determines) {
            let message = format!(
                "row {}, the equation of `{name}`, has neither an acceleration nor the rate of a coordinate of first order: \
                 expected one of them; an equation without either is to be solved for a coordinate, which is then left out",
                row + 1
            );
            report.error(name, message);
        }
    }
}

/// The entries of some matrices in a column that are not zero as they stand, each with its row.
fn find_entries<'a>(
    derived: &'a Derived,
    names: &'a [MatrixName],
    column: usize,
) -> impl Iterator<Item = (MatrixName, usize, &'a Formula)> {
    let matrices = derived.matrices.iter().filter(|(name, _)| names.contains(name));
    matrices.flat_map(move |(name, rows)| {
        let entries = rows.iter().enumerate().filter_map(move |(row, entries)| Some((row, entries.get(column)?)));
        entries.filter(|(_, entry)| !entry.is_zero()).map(move |(row, entry)| (*name, row, entry))
    })
}
