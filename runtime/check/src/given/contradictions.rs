//! State matrices of one speed that are not the same, and eigenvalues without their conjugates.

use carvallo::ModelInfo;

use super::{Eigenvalues, Given, Reading, StateMatrix};
use crate::form::{mended, order};
use crate::states::states;

/// Relative to an entry: what programs that add in another order may differ by.
const ROUNDING: f64 = 1e-9;

/// What no machine has: entries of state matrices at one speed, of each two matrices all (`A_31 at 5 m/s is 9.490 and 11.000`), and
/// complex eigenvalues without their conjugates, where all at a speed are given.
pub fn contradictions(given: &Given, info: &ModelInfo) -> Vec<String> {
    let mended = mended(given, info).map(|(own, _)| own);
    let all = &mended.as_ref().unwrap_or(given).state_matrices;
    let count = states(info).len();
    let mut found: Vec<String> = given.eigenvalues.iter().flat_map(|own| unpaired(own, count)).collect();
    for (at, first) in all.iter().enumerate() {
        for second in all[at + 1..].iter().filter(|own| own.speed == first.speed) {
            found.extend(of_two(first, second, info));
        }
    }
    found
}

fn of_two(first: &StateMatrix, second: &StateMatrix, info: &ModelInfo) -> Vec<String> {
    let [order, others] = [first, second].map(|own| order(own, info));
    let place = |state: usize| others.iter().position(|own| *own == state);
    let mut found = Vec::new();
    for (row, entries) in first.rows.iter().enumerate() {
        for (column, entry) in entries.iter().enumerate() {
            let (Some(a), Some(at_row), Some(at_column)) = (entry, place(order[row]), place(order[column])) else {
                continue;
            };
            let Some(b) = &second.rows[at_row][at_column] else { continue };
            // Cut off or rounded, both may be of one number.
            let allowed = 2.0 * (a.tolerance + b.tolerance) + ROUNDING * a.value.abs();
            if (a.value - b.value).abs() > allowed {
                let name = carvallo_slips::indices(row, column);
                found.push(format!("A{name} at {} m/s is {} and {}", first.speed, a.written, b.written));
            }
        }
    }
    found
}

/// The complex eigenvalues of a speed without their conjugates, where as many are given as there are states.
fn unpaired(Eigenvalues { speed, values }: &Eigenvalues, count: usize) -> Vec<String> {
    let known: Vec<(&Reading, &Reading)> = values.iter().filter_map(|(re, im)| Some((re, im.as_ref()?))).collect();
    if known.len() != count {
        return Vec::new();
    }
    // Cut off or rounded, both may be of one number.
    let near = |a: &Reading, b: f64, other: &Reading| {
        (a.value - b).abs() <= 2.0 * (a.tolerance + other.tolerance) + ROUNDING * b.abs()
    };
    let is_alone = |&&(re, im): &&(&Reading, &Reading)| {
        let is_complex = im.value.abs() > im.tolerance;
        is_complex && !known.iter().any(|(other, part)| near(other, re.value, re) && near(part, -im.value, im))
    };
    let all = known.iter().filter(is_alone);
    all.map(|(re, im)| format!("the eigenvalue {}{:+}i at {speed} m/s without its conjugate", re.value, im.value))
        .collect()
}
