//! Derivatives by differences.

use nalgebra::DMatrix;

/// The distance of the points: what is left out is its fourth power, and rounding is divided by it.
const STEP: f64 = 1e-3;

/// The matrix of the derivatives of a function, row by row those of each of its values, to about 1e-12 of the sizes in it: from
/// four points for each variable.
pub(super) fn jacobian<E>(
    at: &[f64],
    mut function: impl FnMut(&[f64]) -> Result<Vec<f64>, E>,
) -> Result<DMatrix<f64>, E> {
    let mut columns = Vec::with_capacity(at.len());
    let mut point = at.to_vec();
    for variable in 0..at.len() {
        let mut shifted = |steps: f64| {
            point[variable] = at[variable] + steps * STEP;
            let values = function(&point);
            point[variable] = at[variable];
            values
        };
        let [far_below, below, above, far_above] = [shifted(-2.0)?, shifted(-1.0)?, shifted(1.0)?, shifted(2.0)?];
        let slope = |i: usize| (8.0 * (above[i] - below[i]) - (far_above[i] - far_below[i])) / (12.0 * STEP);
        columns.push((0..above.len()).map(slope).collect::<Vec<f64>>());
    }
    let rows = columns.first().map_or(0, Vec::len);
    Ok(DMatrix::from_fn(rows, at.len(), |row, column| columns[column][row]))
}
