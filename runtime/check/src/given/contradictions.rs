//! State matrices of one speed that are not the same.

use carvallo::ModelInfo;

use super::{Given, StateMatrix};
use crate::form::{mended, order};

/// Relative to an entry: what programs that add in another order may differ by.
const ROUNDING: f64 = 1e-9;

/// The entries of state matrices at one speed that no machine has both of, of each two matrices all: `A_31 at 5 m/s is 9.490 and 11.000`.
pub fn contradictions(given: &Given, info: &ModelInfo) -> Vec<String> {
    let mended = mended(given, info).map(|(own, _)| own);
    let all = &mended.as_ref().unwrap_or(given).state_matrices;
    let mut found = Vec::new();
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
