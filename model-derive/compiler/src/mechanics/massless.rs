//! Motions of the coordinates without a kinetic energy.

use super::Fault;
use super::formulas::Formulas;
use super::matrix::{self, Matrix};
use crate::constant::{Constant, Constants, NoValue, eliminate};
use crate::symbolic::Sample;

/// Values of the parameters that are looked at before a proof is attempted.
const TRIED: usize = 3;

/// Larger determinants would grow too long to be proved zero.
const MAX_PROVED: usize = 5;

/// A coordinate that, with some of those before it, moves without a kinetic energy, whatever the parameters.
///
/// Doubles decide for most mechanisms that there is none, many more digits for all others that are right: a mass matrix
/// that is regular for some parameters. What is left is proved, or undecided. Parameter sets are looked at elsewhere.
pub fn find_massless(mass: &Matrix, coordinates: &[usize], formulas: &Formulas<'_>) -> Option<Fault> {
    if is_regular(mass, formulas) {
        return None;
    }
    let mut found = None;
    for values in (0..TRIED).filter_map(|turn| formulas.constants(turn).ok()) {
        let Ok(entries) = evaluate(mass, formulas, &values) else { continue };
        found = Some(find_dependent(entries)?);
    }
    // Where nothing has a value nothing is refused.
    let Dependent { last, others } = found?;
    let joint = coordinates[last];
    let moving: Vec<usize> = others.iter().copied().chain([last]).collect();
    let block = matrix::new(moving.len(), moving.len(), |row, column| mass[moving[row]][moving[column]].clone());
    let is_proved = moving.len() <= MAX_PROVED && formulas.is_zero(&matrix::determinant(&block));
    let along = others.iter().map(|other| coordinates[*other]).collect();
    Some(if is_proved { Fault::Massless { joint, along } } else { Fault::PerhapsMassless { joint, along } })
}

/// Whether elimination in doubles finds a pivot in each row that is not zero, whatever rounding has done.
fn is_regular(mass: &Matrix, formulas: &Formulas<'_>) -> bool {
    let mut rows: Vec<Vec<Sample>> =
        mass.iter().map(|row| row.iter().map(|entry| formulas.at_sample(entry)).collect()).collect();
    (0..rows.len()).all(|pivot| {
        let (done, rest) = rows.split_at_mut(pivot + 1);
        let divisor = done[pivot][pivot];
        for row in rest {
            let factor = row[pivot].over(divisor);
            row.iter_mut()
                .zip(&done[pivot])
                .skip(pivot)
                .for_each(|(entry, above)| *entry = entry.minus_product(factor, *above));
        }
        divisor.is_not_zero()
    })
}

fn evaluate(mass: &Matrix, formulas: &Formulas<'_>, values: &Constants) -> Result<Vec<Vec<Constant>>, NoValue> {
    mass.iter().map(|row| row.iter().map(|entry| formulas.at(entry, values)).collect()).collect()
}

/// A column of a symmetric matrix that is a combination of others before it.
struct Dependent {
    last: usize,
    others: Vec<usize>,
}

/// The first such column, up to more digits than rounding could take.
fn find_dependent(mut entries: Vec<Vec<Constant>>) -> Option<Dependent> {
    let last = eliminate(&mut entries, Constant::is_apart_from_zero_beside)?;
    // What is above the diagonal says of which: from below, one after the other.
    let mut factors = vec![Constant::zero(); last + 1];
    factors[last] = Constant::one();
    for row in (0..last).rev() {
        let sum = (row + 1..=last)
            .fold(Constant::zero(), |sum, column| sum.minus_product(&entries[row][column], &factors[column]));
        factors[row] = sum.over(&entries[row][row]);
    }
    let others = (0..last).filter(|column| factors[*column].is_apart_from_zero_beside(&factors[last])).collect();
    Some(Dependent { last, others })
}
