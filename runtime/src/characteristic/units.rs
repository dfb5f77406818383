//! Units of rows, columns, time and speed in which matrices of any scale have entries of about one at most.
//!
//! All of them are powers of two, so that scaling rounds nothing.

use nalgebra::Complex;

use crate::number::Scalar;
use crate::numeric::{Scaled, exponent, ldexp};
#[cfg(feature = "std")]
use crate::system::Coefficients;
use crate::system::{Matrix, System, SystemError};

/// The exponents of the units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Units<const N: usize> {
    rows: [i32; N],
    columns: [i32; N],
    /// Eigenvalues are measured in this power of two of 1/s.
    pub(crate) time: i32,
    /// Speeds are measured in this power of two of m/s.
    #[cfg_attr(not(feature = "std"), allow(dead_code))]
    pub(crate) speed: i32,
    /// The gravitational field strength is measured in this power of two of N/kg.
    #[cfg_attr(not(feature = "std"), allow(dead_code))]
    gravity: i32,
}

impl<const N: usize> Units<N> {
    /// For equations of motion at one speed.
    ///
    /// # Errors
    /// If a row or a column of M is zero.
    pub(crate) fn of_system<T: Scalar + Scaled>(system: &System<N, T>) -> Result<Self, SystemError> {
        let System { c, k, .. } = system;
        let sides = Self::of_mass(&system.leading())?;
        Ok(Self { time: time_unit(sides.largest(c), sides.largest(k)), ..sides })
    }

    /// For the coefficients of equations of motion at all speeds.
    ///
    /// # Errors
    /// If a row or a column of M is zero.
    #[cfg(feature = "std")]
    pub(crate) fn of_coefficients(coefficients: &Coefficients<f64, N>, gravity: f64) -> Result<Self, SystemError> {
        let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, states: _ } = coefficients;
        let sides = Self::of_mass(m)?;
        // g K0 may leave the range of f64 where the scaled product does not.
        let unit = exponent(gravity).unwrap_or(0);
        let weight = if gravity == 0.0 { None } else { sides.largest(k0).map(|e| e + unit) };
        let time = time_unit(sides.largest(c0), sides.largest(kc).max(weight));
        let per_speed = sides.largest(c1).max(sides.largest(k1).map(|e| e - time)).max(sides.largest(k2).map(half));
        let per_speed = per_speed.or_else(|| sides.largest(cm1).map(|e| 2 * time - e));
        let speed = time - per_speed.unwrap_or(time);
        Ok(Self { time, speed, gravity: unit, ..sides })
    }

    /// Rows and columns that bring the largest entry of each row and column of M into [1/2, 1).
    fn of_mass<T: Scaled>(m: &Matrix<T, N>) -> Result<Self, SystemError> {
        let (mut rows, mut columns) = ([0; N], [0; N]);
        for (i, row) in rows.iter_mut().enumerate() {
            *row = -(0..N).filter_map(|j| exponent(entry(m, i, j)?)).max().ok_or(SystemError::SingularMass)?;
        }
        for (j, column) in columns.iter_mut().enumerate() {
            let largest = (0..N).filter_map(|i| Some(exponent(entry(m, i, j)?)? + rows[i])).max();
            *column = -largest.ok_or(SystemError::SingularMass)?;
        }
        Ok(Self { rows, columns, time: 0, speed: 0, gravity: 0 })
    }

    /// The exponent of the largest entry of a matrix in the units of rows and columns; `None` if all are zero.
    fn largest<T: Scaled>(&self, matrix: &Matrix<T, N>) -> Option<i32> {
        let places = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
        places.filter_map(|(i, j)| Some(exponent(entry(matrix, i, j)?)? + self.rows[i] + self.columns[j])).max()
    }

    /// A matrix that is multiplied by powers of s and of v, and by `2^rest`.
    fn scale<T: Scalar + Scaled>(&self, matrix: &Matrix<T, N>, [s, v]: [i32; 2], rest: i32) -> Matrix<T, N> {
        let power = self.power([s, v]) + rest;
        Matrix::from_fn(|i, j| {
            let entry = entry(matrix, i, j).unwrap_or(T::from_f64(0.0));
            ldexp(entry, self.rows[i] + self.columns[j] + power)
        })
    }

    /// The exponent of what is multiplied by powers of s and of v, beside those of rows and columns.
    fn power(&self, [s, v]: [i32; 2]) -> i32 {
        v * self.speed - (2 - s) * self.time
    }

    /// The matrices at one speed, or derivatives of them, in these units.
    pub(crate) fn scale_system<T: Scalar + Scaled>(&self, System { m, c, k, states }: &System<N, T>) -> System<N, T> {
        let [m, c, k] = [self.scale(m, [2, 0], 0), self.scale(c, [1, 0], 0), self.scale(k, [0, 0], 0)];
        System { m, c, k, states: *states }
    }

    /// Coefficients, or derivatives of them, in these units.
    #[cfg(feature = "std")]
    pub(crate) fn scale_coefficients(&self, coefficients: &Coefficients<f64, N>) -> Coefficients<f64, N> {
        let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, states } = coefficients;
        Coefficients {
            m: self.scale(m, [2, 0], 0),
            cm1: self.scale(cm1, [1, -1], 0),
            c0: self.scale(c0, [1, 0], 0),
            c1: self.scale(c1, [1, 1], 0),
            kc: self.scale(kc, [0, 0], 0),
            k0: self.scale(k0, [0, 0], self.gravity),
            k1: self.scale(k1, [0, 1], 0),
            k2: self.scale(k2, [0, 2], 0),
            states: *states,
        }
    }

    /// By what exponents [`scale_coefficients`](Self::scale_coefficients) scales the entries of each matrix, by the place in
    /// [`MatrixName::ALL`](crate::system::MatrixName::ALL).
    #[cfg(feature = "std")]
    pub(crate) fn exponents(&self) -> [[[i32; N]; N]; 8] {
        let powers = [[2, 0], [1, -1], [1, 0], [1, 1], [0, 0], [0, 0], [0, 1], [0, 2]].map(|powers| self.power(powers));
        let rests = [0, 0, 0, 0, 0, self.gravity, 0, 0];
        core::array::from_fn(|which| {
            self.rows.map(|row| self.columns.map(|column| row + column + powers[which] + rests[which]))
        })
    }

    /// A gravitational field strength in these units.
    #[cfg(feature = "std")]
    pub(crate) fn scale_gravity(&self, gravity: f64) -> f64 {
        ldexp(gravity, -self.gravity)
    }
}

/// An entry, which is always inside. Indexing would link a panic into the programs of microcontrollers, which this does not.
#[inline(always)]
fn entry<T: Scaled, const N: usize>(matrix: &Matrix<T, N>, row: usize, column: usize) -> Option<T> {
    matrix.get((row, column)).copied()
}

/// The unit of time, from the exponents of the largest damping and the largest stiffness.
pub(crate) fn time_unit(damping: Option<i32>, stiffness: Option<i32>) -> i32 {
    damping.max(stiffness.map(half)).unwrap_or(0)
}

/// Of an exponent, rounded up: stiffness is measured in the square of the unit.
fn half(exponent: i32) -> i32 {
    (exponent + 1).div_euclid(2)
}

/// Eigenvalues in a unit, back in 1/s.
///
/// # Errors
/// If one leaves the range of `T`.
#[inline]
pub(crate) fn to_per_second<T: Scalar + Scaled>(eigenvalues: &mut [Complex<T>], unit: i32) -> Result<(), SystemError> {
    eigenvalues.iter_mut().for_each(|value| *value = ldexp_complex(*value, unit));
    if eigenvalues.iter().all(|value| value.re.is_finite() && value.im.is_finite()) {
        Ok(())
    } else {
        Err(SystemError::OutOfRange { quantity: "an eigenvalue" })
    }
}

/// A complex number in another unit: times a power of two.
pub(crate) fn ldexp_complex<T: Scaled>(x: Complex<T>, e: i32) -> Complex<T> {
    Complex::new(ldexp(x.re, e), ldexp(x.im, e))
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::Units;
    use crate::system::{Coefficients, MatrixName};

    /// Entries whose products leave the range of `f64` come to between an eighth and one, but for those that are small
    /// beside the others; nothing is rounded.
    #[test]
    fn bring_every_matrix_to_about_one() {
        let (mass, time, length) = (2f64.powi(500), 2f64.powi(-200), 2f64.powi(300));
        let rows = |unit: f64| [[3.0 * unit, unit], [unit, 5.0 * unit]];
        let rate = mass / time;
        let per_speed = time / length;
        let coefficients = [
            mass,
            0.0,
            rate,
            rate * per_speed,
            rate / time,
            mass / length,
            rate / time * per_speed,
            rate / time * per_speed * per_speed,
        ];
        let coefficients = Coefficients::<f64, 2>::from_rows(coefficients.map(rows));
        let gravity = length / time / time;
        let units = Units::of_coefficients(&coefficients, gravity).expect("a mass matrix without a row of zeros");
        let scaled = units.scale_coefficients(&coefficients);
        // The unit of speed is chosen for the matrices that are multiplied by it, and C-1 leaves the range of f64 here.
        for name in MatrixName::ALL.into_iter().filter(|name| *name != MatrixName::Cm1) {
            let (before, after) = (coefficients.matrix(name), scaled.matrix(name));
            assert!(after.iter().all(|&entry| entry > 0.03 && entry <= 1.0), "{name}: {after}");
            assert!(after.iter().zip(before).all(|(after, before)| (after.to_bits() ^ before.to_bits()) << 12 == 0));
        }
        assert!((0.5..1.0).contains(&units.scale_gravity(gravity)));
    }
}
