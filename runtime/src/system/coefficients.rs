//! The coefficient matrices of the linearized equations of motion.

use core::fmt;

use nalgebra::SMatrix;

use super::rows::Rows;
use crate::number::Scalar;

/// A matrix of N x N numbers.
pub type Matrix<T, const N: usize> = SMatrix<T, N, N>;

/// The coefficient matrices of
/// `M q'' + (C0 + v C1) q' + (Kc + g K0 + v^2 K2) q = f`, each N x N.
///
/// Rows and columns follow the coordinates of the model. For coordinates that are angles in rad, M is in kg m^2, C0 in
/// N m s, C1 in kg m, Kc in N m, K0 in kg m and K2 in kg.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coefficients<T: Scalar, const N: usize> {
    /// Mass matrix M.
    pub m: Matrix<T, N>,
    /// Damping C0 that does not depend on the speed.
    pub c0: Matrix<T, N>,
    /// Damping C1, to be multiplied by v.
    pub c1: Matrix<T, N>,
    /// Stiffness Kc that depends on neither gravity nor speed.
    pub kc: Matrix<T, N>,
    /// Stiffness K0, to be multiplied by g.
    pub k0: Matrix<T, N>,
    /// Stiffness K2, to be multiplied by v^2.
    pub k2: Matrix<T, N>,
}

impl<T: Scalar, const N: usize> Coefficients<T, N> {
    /// From the rows of each matrix, in the order M, C0, C1, Kc, K0, K2.
    pub fn from_rows([m, c0, c1, kc, k0, k2]: [[[T; N]; N]; 6]) -> Self {
        let matrix = |rows: [[T; N]; N]| SMatrix::from_fn(|row, column| rows[row][column]);
        Self { m: matrix(m), c0: matrix(c0), c1: matrix(c1), kc: matrix(kc), k0: matrix(k0), k2: matrix(k2) }
    }

    /// The same numbers as `f64`, exactly.
    pub(crate) fn widen(&self) -> Coefficients<f64, N> {
        let wide = |matrix: &Matrix<T, N>| matrix.map(Scalar::to_f64);
        let Self { m, c0, c1, kc, k0, k2 } = self;
        Coefficients { m: wide(m), c0: wide(c0), c1: wide(c1), kc: wide(kc), k0: wide(k0), k2: wide(k2) }
    }

    /// One of the matrices.
    pub fn matrix(&self, name: MatrixName) -> &Matrix<T, N> {
        let Self { m, c0, c1, kc, k0, k2 } = self;
        match name {
            MatrixName::M => m,
            MatrixName::C0 => c0,
            MatrixName::C1 => c1,
            MatrixName::Kc => kc,
            MatrixName::K0 => k0,
            MatrixName::K2 => k2,
        }
    }

    /// One of the matrices, to be changed.
    pub fn matrix_mut(&mut self, name: MatrixName) -> &mut Matrix<T, N> {
        let Self { m, c0, c1, kc, k0, k2 } = self;
        match name {
            MatrixName::M => m,
            MatrixName::C0 => c0,
            MatrixName::C1 => c1,
            MatrixName::Kc => kc,
            MatrixName::K0 => k0,
            MatrixName::K2 => k2,
        }
    }
}

/// The rows of a matrix, from an array that holds the entries of several of them row by row: its own begin at `first`.
///
/// Compiled models make their matrices by it. Rows of two `f32` that are written where they are used, or taken from an
/// array at places known there, are for LLVM one whole number of 64 bits each, and then it puts no loop over designs into
/// lanes; so the rows are taken by a function that learns the place. It counts, since what iterates would be a call for
/// each entry wherever a profile has `lto = "off"`.
///
/// # Panics
/// If the array ends before the matrix.
#[inline(always)]
pub fn rows<T: Copy, const N: usize, const ENTRIES: usize>(entries: &[T; ENTRIES], first: usize) -> Rows<T, N> {
    let mut rows = [[entries[first]; N]; N];
    for index in 0..N * N {
        rows[index / N][index % N] = entries[first + index];
    }
    Rows(rows)
}

/// One of the coefficient matrices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MatrixName {
    /// Mass matrix M.
    M,
    /// Damping C0.
    C0,
    /// Damping C1, a coefficient of v.
    C1,
    /// Stiffness Kc.
    Kc,
    /// Stiffness K0, a coefficient of g.
    K0,
    /// Stiffness K2, a coefficient of v^2.
    K2,
}

impl MatrixName {
    /// All of them, in the order in which a model lists them.
    pub const ALL: [Self; 6] = [Self::M, Self::C0, Self::C1, Self::Kc, Self::K0, Self::K2];

    /// The name as declarations write it, such as `C1`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::M => "M",
            Self::C0 => "C0",
            Self::C1 => "C1",
            Self::Kc => "Kc",
            Self::K0 => "K0",
            Self::K2 => "K2",
        }
    }
}

/// Reads `M`, `C0`, `C1`, `Kc`, `K0`, `K2`.
impl fmt::Display for MatrixName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}
