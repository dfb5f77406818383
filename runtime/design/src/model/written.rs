//! Matrices of any number of coordinates written out. Not generic in that number, so that it is compiled once.

use carvallo::{Complex, MatrixName, States};

use super::equations::Shape;
use crate::matrices::dependent_column;

/// The rows of all matrices, each of which is given column by column.
pub(super) fn all<'a>(matrix: &dyn Fn(MatrixName) -> &'a [f64], count: usize) -> [(MatrixName, Vec<Vec<f64>>); 8] {
    let rows = |columns: &[f64]| (0..count).map(|row| self::row(columns, row, count).collect()).collect();
    MatrixName::ALL.map(|name| (name, rows(matrix(name))))
}

/// Matrices row by row, of those that are given column by column.
pub(super) fn by_rows(matrices: [&[f64]; 3], count: usize) -> [Vec<f64>; 3] {
    matrices.map(|columns| (0..count).flat_map(|row| self::row(columns, row, count)).collect())
}

/// A and B row by row, of the [state space](super::Equations::state_space) of coordinates with these states: what is solved
/// for, of positions, rates and forces, column by column.
pub(super) fn state_space([stiffness, damping, input]: [&[f64]; 3], states: &[States]) -> [Vec<f64>; 2] {
    let count = states.len();
    let positions = || (0..count).filter(|&index| states[index] != States::Rate);
    let rates = || (0..count).filter(|&index| states[index] != States::Position);
    let [mut a, mut b] = [Vec::new(), Vec::new()];
    let solved = |row: usize, a: &mut Vec<f64>, b: &mut Vec<f64>| {
        a.extend(positions().map(|column| stiffness[row + count * column]));
        a.extend(rates().map(|column| damping[row + count * column]));
        b.extend(self::row(input, row, count));
    };
    for row in positions() {
        if states[row] == States::Position {
            solved(row, &mut a, &mut b);
            continue;
        }
        a.extend(positions().map(|_| 0.0));
        a.extend(rates().map(|column| if column == row { 1.0 } else { 0.0 }));
        b.extend((0..count).map(|_| 0.0));
    }
    rates().for_each(|row| solved(row, &mut a, &mut b));
    [a, b]
}

/// The right and the left eigenvector of an eigenvalue.
pub(super) fn shape(right: &[Complex<f64>], left: &[Complex<f64>]) -> Shape {
    // Adding zero turns -0 into 0.
    let positive_zeros = |entry: &Complex<f64>| Complex::new(entry.re + 0.0, entry.im + 0.0);
    Shape { right: right.iter().map(positive_zeros).collect(), left: left.iter().map(positive_zeros).collect() }
}

/// Why there are no equations of motion at rest, if there are none, of M, C-1 and C0 column by column.
pub(super) fn without_rest([m, cm1, c0]: [&[f64]; 3], states: &[States]) -> Option<&'static str> {
    if cm1.iter().any(|&entry| entry != 0.0) {
        return Some("C-1 is divided by the speed");
    }
    let count = states.len();
    let mut leading = m.to_vec();
    for column in (0..count).filter(|&column| states[column] == States::Position) {
        let place = count * column..count * (column + 1);
        leading[place.clone()].copy_from_slice(&c0[place]);
    }
    let is_singular = states.contains(&States::Position) && dependent_column(&leading, count, &|_| true).is_some();
    is_singular.then_some("the rate of a coordinate of first order is multiplied by the speed alone")
}

fn row(columns: &[f64], row: usize, count: usize) -> impl Iterator<Item = f64> + '_ {
    columns.iter().skip(row).step_by(count).copied()
}
