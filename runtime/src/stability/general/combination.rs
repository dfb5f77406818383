//! A matrix that depends on the speed.

use super::field::RealField;
use crate::numeric::Square;

/// The sum of functions of the speed, each times a matrix.
pub(super) struct Combination {
    size: usize,
    /// The place of the function, and the matrix; none that is zero.
    terms: Vec<(usize, Square<f64>)>,
}

impl Combination {
    pub(super) fn new(size: usize, terms: impl IntoIterator<Item = (usize, Square<f64>)>) -> Self {
        let is_zero = |matrix: &Square<f64>| matrix.entries().iter().all(|&entry| entry == 0.0);
        Self { size, terms: terms.into_iter().filter(|(_, matrix)| !is_zero(matrix)).collect() }
    }

    /// The matrix of a function, if it has one.
    pub(super) fn term(&self, function: usize) -> Option<&Square<f64>> {
        self.terms.iter().find(|(place, _)| *place == function).map(|(_, matrix)| matrix)
    }

    pub(super) fn has_zero_column(&self, column: usize) -> bool {
        self.terms.iter().all(|(_, matrix)| matrix.column(column).all(|entry| entry == 0.0))
    }

    /// The matrix at a speed.
    pub(super) fn at(&self, values: &[(f64, Option<f64>)]) -> Square<f64> {
        let mut sum = Square::filled(self.size, 0.0);
        for (function, matrix) in &self.terms {
            let (factor, _) = values[*function];
            sum.entries_mut().iter_mut().zip(matrix.entries()).for_each(|(sum, entry)| *sum += factor * entry);
        }
        sum
    }

    /// The sum of the magnitudes of the terms.
    pub(super) fn magnitudes(&self, values: &[(f64, Option<f64>)]) -> Square<f64> {
        let mut sum = Square::filled(self.size, 0.0);
        for (function, matrix) in &self.terms {
            let (factor, _) = values[*function];
            sum.entries_mut().iter_mut().zip(matrix.entries()).for_each(|(sum, entry)| *sum += (factor * entry).abs());
        }
        sum
    }

    /// An entry at a speed, and its derivative.
    pub(super) fn entry<R: RealField>(&self, [row, column]: [usize; 2], values: &[(R, Option<R>)]) -> [R; 2] {
        let mut sums = [R::from(0.0); 2];
        for (function, matrix) in &self.terms {
            let entry = R::from(matrix[row][column]);
            let (factor, derivative) = values[*function];
            sums[0] = sums[0] + entry * factor;
            if let Some(derivative) = derivative {
                sums[1] = sums[1] + entry * derivative;
            }
        }
        sums
    }
}
