//! The matrix polynomial `Q(s) = M s^2 + C s + K` at any scale of its matrices.

use nalgebra::Complex;
use nalgebra::SMatrix;

use crate::characteristic::units::{Units, ldexp_complex};
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
    system: System<N>,
    units: Units<N>,
}

impl<const N: usize> Pencil<N> {
    /// # Errors
    /// If a row or a column of M is zero.
    pub(super) fn new(system: &System<N>) -> Result<Self, SystemError> {
        let units = Units::of_system(system)?;
        Ok(Self { system: units.scale_system(system), units })
    }

    /// A direction in the units of the polynomial.
    pub(super) fn scale(&self, &Direction { m, c, k }: &Direction<N>) -> Direction<N> {
        let System { m, c, k, .. } = self.units.scale_system(&System::new(m, c, k));
        Direction { m, c, k }
    }

    /// An eigenvalue in 1/s in the unit of the polynomial.
    pub(super) fn to_unit(&self, eigenvalue: Complex<f64>) -> Complex<f64> {
        ldexp_complex(eigenvalue, -self.units.time)
    }

    /// From the unit of the polynomial, to a power, back to 1/s.
    ///
    /// # Errors
    /// If it leaves the range of `f64`.
    pub(super) fn per_second(&self, value: Complex<f64>, power: i32) -> Result<Complex<f64>, SystemError> {
        let value = ldexp_complex(value, power * self.units.time);
        if value.re.is_finite() && value.im.is_finite() {
            Ok(value)
        } else {
            Err(SystemError::OutOfRange { quantity: "a derivative of an eigenvalue" })
        }
    }

    /// Q(s).
    pub(super) fn at(&self, s: Complex<f64>) -> ComplexMatrix<N> {
        Matrix::from_fn(|i, j| (s * self.system.m[(i, j)] + self.system.c[(i, j)]) * s + self.system.k[(i, j)])
    }

    /// Q'(s) = 2 s M + C.
    pub(super) fn slope(&self, s: Complex<f64>) -> ComplexMatrix<N> {
        Matrix::from_fn(|i, j| s * 2.0 * self.system.m[(i, j)] + self.system.c[(i, j)])
    }

    /// The sizes of the terms that the entries of Q(s) are summed from.
    pub(super) fn size(&self, s: Complex<f64>) -> Matrix<f64, N> {
        let s = s.norm();
        Matrix::from_fn(|i, j| {
            (s * self.system.m[(i, j)].abs() + self.system.c[(i, j)].abs()) * s + self.system.k[(i, j)].abs()
        })
    }
}
