//! A matrix as generated code gives it: row by row.

use core::fmt;
use core::ops::{Deref, DerefMut};

use super::coefficients::Matrix;
use crate::number::Scalar;

/// A matrix of N x N numbers, row by row: `matrix[row][column]`, both from zero.
///
/// What generated code gives, for lanes as well, which no library of matrices knows. It is read like an array of rows, and
/// compared with one. nalgebra stores columns, and takes an array of arrays for them; this is a type of its own, so that it
/// becomes the same matrix there, and not the transposed one.
///
/// ```
/// use carvallo::{Matrix, Rows};
///
/// let rows = Rows([[1.0, 2.0], [3.0, 4.0]]);
/// assert_eq!(rows[0][1], 2.0);
///
/// let matrix: Matrix<f64, 2> = rows.into();
/// assert_eq!(matrix[(0, 1)], 2.0);
/// assert_eq!(matrix, rows.matrix());
/// ```
#[derive(Clone, Copy, PartialEq)]
pub struct Rows<T, const N: usize>(
    /// The rows.
    pub [[T; N]; N],
);

impl<T: Scalar, const N: usize> Rows<T, N> {
    /// The same matrix for nalgebra.
    #[must_use]
    pub fn matrix(&self) -> Matrix<T, N> {
        Matrix::from_fn(|row, column| self.0[row][column])
    }
}

/// The same matrix for nalgebra.
impl<T: Scalar, const N: usize> From<Rows<T, N>> for Matrix<T, N> {
    fn from(rows: Rows<T, N>) -> Self {
        rows.matrix()
    }
}

/// The rows of a matrix of nalgebra.
impl<T: Scalar, const N: usize> From<Matrix<T, N>> for Rows<T, N> {
    fn from(matrix: Matrix<T, N>) -> Self {
        Self(matrix.transpose().data.0)
    }
}

impl<T, const N: usize> Deref for Rows<T, N> {
    type Target = [[T; N]; N];

    #[inline(always)]
    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl<T, const N: usize> DerefMut for Rows<T, N> {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut Self::Target {
        &mut self.0
    }
}

impl<T, const N: usize> IntoIterator for Rows<T, N> {
    type Item = [T; N];
    type IntoIter = core::array::IntoIter<[T; N], N>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}

impl<T: PartialEq, const N: usize> PartialEq<[[T; N]; N]> for Rows<T, N> {
    fn eq(&self, rows: &[[T; N]; N]) -> bool {
        self.0 == *rows
    }
}

impl<T: PartialEq, const N: usize> PartialEq<Rows<T, N>> for [[T; N]; N] {
    fn eq(&self, rows: &Rows<T, N>) -> bool {
        *self == rows.0
    }
}

/// As an array of rows.
impl<T: fmt::Debug, const N: usize> fmt::Debug for Rows<T, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}
