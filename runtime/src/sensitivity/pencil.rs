//! The matrix polynomial `Q(s) = M s^2 + C s + K` at any scale of its matrices.

use nalgebra::Complex;
use nalgebra::SMatrix;

use crate::numeric::{exponent, ldexp};
use crate::system::{Matrix, System, SystemError};

pub(super) type ComplexMatrix<const N: usize> = SMatrix<Complex<f64>, N, N>;

/// A direction in which the matrices of a system change: their derivatives with respect to something.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Direction<const N: usize> {
    pub(super) m: Matrix<f64, N>,
    pub(super) c: Matrix<f64, N>,
    pub(super) k: Matrix<f64, N>,
}

impl<const N: usize> Direction<N> {
    /// # Errors
    /// If an entry is not finite.
    pub(super) fn finite(self) -> Result<Self, SystemError> {
        let is_finite = [&self.m, &self.c, &self.k].iter().all(|matrix| matrix.iter().all(|entry| entry.is_finite()));
        if is_finite { Ok(self) } else { Err(SystemError::OutOfRange { quantity: "a derivative of M, C or K" }) }
    }
}

/// What the entries of a direction are multiplied with to give the derivative of something.
pub(super) struct Weights<const N: usize> {
    m: ComplexMatrix<N>,
    c: ComplexMatrix<N>,
    k: ComplexMatrix<N>,
}

impl<const N: usize> Weights<N> {
    pub(super) fn zero() -> Self {
        let zero = ComplexMatrix::zeros();
        Self { m: zero, c: zero, k: zero }
    }

    /// Those of a weighted sum of the entries of `s^2 dM + s dC + dK`.
    pub(super) fn at(s: Complex<f64>, weights: &ComplexMatrix<N>) -> Self {
        Self { m: weights * (s * s), c: weights * s, k: *weights }
    }

    pub(super) fn add(&mut self, other: &Self) {
        self.m += other.m;
        self.c += other.c;
        self.k += other.k;
    }

    /// Without their imaginary parts, where those are rounding.
    pub(super) fn real(self) -> Self {
        let real = |matrix: ComplexMatrix<N>| matrix.map(|weight| Complex::new(weight.re, 0.0));
        Self { m: real(self.m), c: real(self.c), k: real(self.k) }
    }

    /// The weighted sum of the entries of a direction.
    pub(super) fn dot(&self, direction: &Direction<N>) -> Complex<f64> {
        let pairs = [(&self.m, &direction.m), (&self.c, &direction.c), (&self.k, &direction.k)];
        let terms = pairs.into_iter().flat_map(|(weights, entries)| weights.iter().zip(entries));
        terms.map(|(weight, entry)| weight * *entry).sum()
    }
}

/// The polynomial with rows, columns and time measured in powers of two that bring all entries to at most one.
pub(super) struct Pencil<const N: usize> {
    m: Matrix<f64, N>,
    c: Matrix<f64, N>,
    k: Matrix<f64, N>,
    rows: [i32; N],
    columns: [i32; N],
    /// The exponent of the power of two in 1/s that eigenvalues are measured in.
    unit: i32,
}

impl<const N: usize> Pencil<N> {
    pub(super) fn new(system: &System<N>) -> Self {
        let (rows, columns) = equilibrate(&system.m);
        let largest = |matrix: &Matrix<f64, N>| {
            let places = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
            places.filter_map(|(i, j)| Some(exponent(matrix[(i, j)])? + rows[i] + columns[j])).max()
        };
        let unit = largest(&system.c).max(largest(&system.k).map(|e| (e + 1).div_euclid(2))).unwrap_or(0);
        let mut pencil = Self { m: system.m, c: system.c, k: system.k, rows, columns, unit };
        let Direction { m, c, k } = pencil.scaled(&Direction { m: system.m, c: system.c, k: system.k });
        (pencil.m, pencil.c, pencil.k) = (m, c, k);
        pencil
    }

    /// A direction in the units of the polynomial.
    pub(super) fn scaled(&self, direction: &Direction<N>) -> Direction<N> {
        let scaled = |matrix: &Matrix<f64, N>, power: i32| {
            Matrix::from_fn(|i, j| ldexp(matrix[(i, j)], self.rows[i] + self.columns[j] - power * self.unit))
        };
        Direction { m: scaled(&direction.m, 0), c: scaled(&direction.c, 1), k: scaled(&direction.k, 2) }
    }

    /// An eigenvalue in 1/s in the unit of the polynomial.
    pub(super) fn to_unit(&self, eigenvalue: Complex<f64>) -> Complex<f64> {
        Complex::new(ldexp(eigenvalue.re, -self.unit), ldexp(eigenvalue.im, -self.unit))
    }

    /// From the unit of the polynomial, to a power, back to 1/s.
    ///
    /// # Errors
    /// If it leaves the range of `f64`.
    pub(super) fn per_second(&self, value: Complex<f64>, power: i32) -> Result<Complex<f64>, SystemError> {
        let value = Complex::new(ldexp(value.re, power * self.unit), ldexp(value.im, power * self.unit));
        if value.re.is_finite() && value.im.is_finite() {
            Ok(value)
        } else {
            Err(SystemError::OutOfRange { quantity: "a derivative of an eigenvalue" })
        }
    }

    /// Q(s).
    pub(super) fn at(&self, s: Complex<f64>) -> ComplexMatrix<N> {
        Matrix::from_fn(|i, j| (s * self.m[(i, j)] + self.c[(i, j)]) * s + self.k[(i, j)])
    }

    /// Q'(s) = 2 s M + C.
    pub(super) fn slope(&self, s: Complex<f64>) -> ComplexMatrix<N> {
        Matrix::from_fn(|i, j| s * 2.0 * self.m[(i, j)] + self.c[(i, j)])
    }

    /// The sizes of the terms that the entries of Q(s) are summed from.
    pub(super) fn size(&self, s: Complex<f64>) -> Matrix<f64, N> {
        let s = s.norm();
        Matrix::from_fn(|i, j| (s * self.m[(i, j)].abs() + self.c[(i, j)].abs()) * s + self.k[(i, j)].abs())
    }
}

/// Exponents r and c that bring the largest entry of each row and column of `2^(r_i + c_j) m_ij` into [1/2, 1).
pub(super) fn equilibrate<const N: usize>(m: &Matrix<f64, N>) -> ([i32; N], [i32; N]) {
    let rows: [i32; N] = core::array::from_fn(|i| -(0..N).filter_map(|j| exponent(m[(i, j)])).max().unwrap_or(0));
    let column = |j: usize| (0..N).filter_map(|i| Some(exponent(m[(i, j)])? + rows[i])).max();
    (rows, core::array::from_fn(|j| -column(j).unwrap_or(0)))
}
