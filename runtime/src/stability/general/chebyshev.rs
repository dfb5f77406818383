//! Matrices over a range of a parameter, by Chebyshev's polynomials.

use core::f64::consts::PI;

use crate::numeric::Square;

/// The degrees that are tried.
const DEGREES: [usize; 4] = [3, 7, 14, 24];

/// Where in the range, from -1 to 1, the polynomials are held against the matrices: at no point that they are made from.
const HELD: [f64; 5] = [-1.0, -0.613, 0.137, 0.731, 1.0];

/// What the polynomials may be off by: relative to an entry in the range, or to the largest of its matrix times `SMALL`.
const ACCURACY: f64 = 1e-13;
const SMALL: f64 = 1e-2;

/// M, C and K.
pub(super) type Triple = [Square<f64>; 3];

/// The coefficients of Chebyshev's polynomials for each of three matrices over a range, ascending; `None` if they are no
/// polynomials of a degree that is tried.
pub(super) fn interpolate<E>(
    [from, to]: [f64; 2],
    at: &mut dyn FnMut(f64) -> Result<Triple, E>,
) -> Result<Option<[Vec<Square<f64>>; 3]>, E> {
    let value = |t: f64| if t == 1.0 { to } else { from + 0.5 * (t + 1.0) * (to - from) };
    let held = HELD.iter().map(|&t| Ok((t, at(value(t))?))).collect::<Result<Vec<_>, E>>()?;
    for degree in DEGREES {
        let count = degree + 1;
        let angle = |k: usize| PI * (2 * k + 1) as f64 / (2 * count) as f64;
        let samples = (0..count).map(|k| at(value(angle(k).cos()))).collect::<Result<Vec<_>, E>>()?;
        let coefficients = [0, 1, 2].map(|which| -> Vec<Square<f64>> {
            let coefficient = |order: usize| {
                let factor = if order == 0 { 1.0 } else { 2.0 } / count as f64;
                let size = samples[0][which].size();
                Square::from_fn(size, |i, j| {
                    let terms = samples.iter().enumerate();
                    factor * terms.map(|(k, sample)| sample[which][i][j] * (order as f64 * angle(k)).cos()).sum::<f64>()
                })
            };
            (0..count).map(coefficient).collect()
        });
        let agrees = |which: usize| {
            let all = || samples.iter().chain(held.iter().map(|(_, triple)| triple)).map(|triple| &triple[which]);
            let largest = |i: usize, j: usize| all().fold(0.0, |largest: f64, matrix| largest.max(matrix[i][j].abs()));
            let sizes = Square::from_fn(samples[0][which].size(), largest);
            let most = sizes.entries().iter().fold(0.0, |most: f64, size| most.max(*size));
            held.iter().all(|(t, triple)| {
                let is_held = |(place, size): (usize, &f64)| {
                    let sum = clenshaw(coefficients[which].iter().map(|matrix| matrix.entries()[place]), *t);
                    (sum - triple[which].entries()[place]).abs() <= ACCURACY * size.max(SMALL * most)
                };
                sizes.entries().iter().enumerate().all(is_held)
            })
        };
        if [0, 1, 2].into_iter().all(agrees) {
            return Ok(Some(coefficients.map(without_rounding)));
        }
    }
    Ok(None)
}

/// Without coefficients that are rounding: so what does not depend on the parameter is constant.
fn without_rounding(mut coefficients: Vec<Square<f64>>) -> Vec<Square<f64>> {
    const ROUNDING: f64 = 8.0 * f64::EPSILON;
    let sizes: Vec<f64> = (0..coefficients[0].entries().len())
        .map(|place| coefficients.iter().fold(0.0, |size: f64, matrix| size.max(matrix.entries()[place].abs())))
        .collect();
    for matrix in &mut coefficients {
        for (entry, size) in matrix.entries_mut().iter_mut().zip(&sizes) {
            if entry.abs() <= ROUNDING * size {
                *entry = 0.0;
            }
        }
    }
    coefficients
}

/// A sum of Chebyshev's polynomials from their coefficients, ascending (Clenshaw 1955).
fn clenshaw(coefficients: impl DoubleEndedIterator<Item = f64> + ExactSizeIterator, t: f64) -> f64 {
    let (mut last, mut before) = (0.0, 0.0);
    for (order, coefficient) in coefficients.enumerate().rev() {
        let factor = if order == 0 { t } else { 2.0 * t };
        (last, before) = (coefficient + factor * last - before, last);
    }
    last
}
