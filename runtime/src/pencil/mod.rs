//! The pencil `Q(s) = M s^2 + C s + K` of any number of coordinates, where it is singular: eigenvectors, and how the
//! condition of being singular changes.
//!
//! The number of coordinates is not in the types, and everything is in twice the precision: what is compiled once is fast
//! enough for vectors and derivatives, of which there are few.

mod elimination;
mod equations;
mod matrices;

pub(crate) use elimination::Elimination;
pub(crate) use equations::Equations;
pub(crate) use matrices::Matrices;

use crate::numeric::ComplexDoubleDouble;

/// A square matrix, row by row.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Square {
    pub(crate) size: usize,
    pub(crate) entries: Vec<ComplexDoubleDouble>,
}

impl Square {
    /// The product with a column.
    pub(crate) fn times(&self, column: &[ComplexDoubleDouble]) -> Vec<ComplexDoubleDouble> {
        self.entries.chunks(self.size).map(|row| dot(row, column)).collect()
    }
}

/// The sum of the products, without conjugation.
pub(crate) fn dot(x: &[ComplexDoubleDouble], y: &[ComplexDoubleDouble]) -> ComplexDoubleDouble {
    x.iter().zip(y).fold(ComplexDoubleDouble::ZERO, |sum, (&x, &y)| sum + x * y)
}
