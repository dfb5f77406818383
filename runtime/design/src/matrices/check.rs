//! Whether given matrices are equations of motion, and the coordinate for which they are none.

use carvallo::{MatrixName, ModelInfo, States};

use super::entry_name;
use crate::model::Equations;
use crate::number::shortest;

/// All matrices, each column by column.
pub type Matrices<'a> = [(MatrixName, &'a [f64]); 8];

/// # Errors
/// If M is singular, or if what is said to be no state has an entry that is not zero.
pub fn check(matrices: &Matrices, info: &ModelInfo) -> Result<(), String> {
    for (column, coordinate) in info.coordinates.iter().enumerate() {
        let name = coordinate.name;
        let first = |names: &[MatrixName]| first_entry(matrices, names, column);
        match coordinate.states {
            States::Both => {}
            States::Position => {
                if let Some((entry, value)) = first(&[MatrixName::M]) {
                    return Err(format!(
                        "`{entry}` is {value}, but of `{name}` only the position is a state: its column of `M` must be zero"
                    ));
                }
                if first(&[MatrixName::Cm1, MatrixName::C0, MatrixName::C1]).is_none() {
                    return Err(format!(
                        "of `{name}` only the position is a state, but no damping matrix has its rate: its column of \
                         `C-1`, `C0` or `C1` must not be zero"
                    ));
                }
            }
            States::Rate => {
                let stiffness = [MatrixName::Kc, MatrixName::K0, MatrixName::K1, MatrixName::K2];
                if let Some((entry, value)) = first(&stiffness) {
                    return Err(format!(
                        "`{entry}` is {value}, but of `{name}` only the rate is a state: its column of every stiffness \
                         matrix must be zero"
                    ));
                }
            }
        }
    }
    let (_, m) = matrices[0];
    let has_rate = |column: usize| info.coordinates[column].states != States::Position;
    match dependent_column(m, info.coordinates.len(), &has_rate) {
        None => Ok(()),
        Some(column) => Err(singular(m, column, info)),
    }
}

/// The coordinates of which no stiffness matrix has the position, although it is a state.
pub fn free<'a>(equations: &dyn Equations, info: &'a ModelInfo) -> Vec<&'a str> {
    let matrices = equations.matrices();
    let stiffness =
        |name: &MatrixName| matches!(name, MatrixName::Kc | MatrixName::K0 | MatrixName::K1 | MatrixName::K2);
    let is_free = |column: usize| {
        let mut rows = matrices.iter().filter(|(name, _)| stiffness(name)).flat_map(|(_, rows)| rows);
        info.coordinates[column].states == States::Both && rows.all(|row| row[column] == 0.0)
    };
    (0..info.coordinates.len()).filter(|&column| is_free(column)).map(|column| info.coordinates[column].name).collect()
}

/// The first entry of a column that is not zero, and its value.
fn first_entry(matrices: &Matrices, names: &[MatrixName], column: usize) -> Option<(String, String)> {
    matrices.iter().filter(|(name, _)| names.contains(name)).find_map(|&(name, entries)| {
        let count = entries.len().isqrt();
        let entries = &entries[count * column..count * (column + 1)];
        let row = entries.iter().position(|&entry| entry != 0.0)?;
        Some((entry_name(name, row, column, count), shortest(entries[row])))
    })
}

/// That M is singular, by the coordinate whose column depends on others.
fn singular(m: &[f64], column: usize, info: &ModelInfo) -> String {
    let count = info.coordinates.len();
    let name = info.coordinates[column].name;
    let is_singular = "`M` is singular, and it must be invertible:";
    if m[count * column..count * (column + 1)].iter().all(|&entry| entry == 0.0) {
        return format!(
            "{is_singular} its column of `{name}` is zero; where only the position of `{name}` is a state, `coordinates` \
             says so by `only = \"position\"`"
        );
    }
    // The equation of a coordinate of first order may have no acceleration.
    let has_order_one = info.coordinates.iter().any(|coordinate| coordinate.states == States::Position);
    match (0..count).position(|row| m.iter().skip(row).step_by(count).all(|&entry| entry == 0.0)) {
        Some(row) if !has_order_one => format!("{is_singular} its row of `{}` is zero", info.coordinates[row].name),
        _ => format!("{is_singular} its column of `{name}` depends on those before it"),
    }
}

/// The first of the columns that count which depends on those before it, by elimination with pivots that are the largest
/// relative to their rows. As for the library, a pivot is zero if it is no more than the rounding of the terms that were
/// subtracted to form it.
pub fn dependent_column(m: &[f64], count: usize, counts: &dyn Fn(usize) -> bool) -> Option<usize> {
    let at = |row: usize, column: usize| row + count * column;
    let mut m = m.to_vec();
    let mut terms: Vec<f64> = m.iter().map(|entry| entry.abs()).collect();
    let columns: Vec<usize> = (0..count).filter(|&column| counts(column)).collect();
    for (step, &column) in columns.iter().enumerate() {
        let relative = |row: usize| {
            let largest =
                columns[step..].iter().fold(0.0, |largest: f64, &column| largest.max(m[at(row, column)].abs()));
            if largest > 0.0 { m[at(row, column)].abs() / largest } else { 0.0 }
        };
        let pivot = (step..count).max_by(|&a, &b| relative(a).total_cmp(&relative(b)))?;
        for column in 0..count {
            m.swap(at(step, column), at(pivot, column));
            terms.swap(at(step, column), at(pivot, column));
        }
        if m[at(step, column)].abs() <= 8.0 * f64::EPSILON * terms[at(step, column)] {
            return Some(column);
        }
        for row in step + 1..count {
            let factor = m[at(row, column)] / m[at(step, column)];
            for &column in &columns[step..] {
                let product = factor * m[at(step, column)];
                m[at(row, column)] -= product;
                terms[at(row, column)] += product.abs();
            }
        }
    }
    None
}
