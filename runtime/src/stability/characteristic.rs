//! The characteristic polynomial of two coordinates as a polynomial in the eigenvalue and in the speed.

use nalgebra::Complex;

use crate::eigenvalues::Quartic;
use crate::number::Scalar;
use crate::numeric::{DoubleDouble, Polynomial, Tracked, equilibrate, exponent, ldexp};
use crate::system::require_finite;
use crate::system::{Coefficients, Matrix, SystemError};

/// `det(M s^2 + (C0 + v C1) s + Kc + g K0 + v^2 K2)`, up to a factor, as `p_0(v) + p_1(v) s + ... + p_4 s^4`.
///
/// Exact but for the rounding of double-double arithmetic. Speed and eigenvalues are measured in powers of two of m/s and
/// 1/s that bring all entries to at most one.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Characteristic {
    /// From the first one that is not zero at all speeds.
    coefficients: Vec<Polynomial>,
    speed_unit: i32,
    eigenvalue_unit: i32,
}

impl Characteristic {
    pub(super) fn new<T: Scalar>(coefficients: &Coefficients<T, 2>, gravity: f64) -> Result<Self, SystemError> {
        require_finite("gravity", gravity)?;
        let Coefficients { m, c0, c1, kc, k0, k2 } = coefficients.finite()?;
        let (row, column) = equilibrate([[m.m11, m.m12], [m.m21, m.m22]]).ok_or(SystemError::SingularMass)?;
        let largest = |matrix: &Matrix<f64, 2>| {
            let entries = (0..4).map(|i| (i / 2, i % 2));
            entries.filter_map(|(i, j)| Some(exponent(matrix[(i, j)])? + row[i] + column[j])).max()
        };
        // g K0 may leave the range of f64 where the scaled product does not.
        let gravity_exponent = exponent(gravity).unwrap_or(0);
        let gravity_fraction = ldexp(gravity, -gravity_exponent);
        let weight = if gravity == 0.0 { None } else { largest(&k0).map(|e| e + gravity_exponent) };
        let half = |e: i32| (e + 1).div_euclid(2);
        let eigenvalue_unit = largest(&c0).max(largest(&kc).max(weight).map(half)).unwrap_or(0);
        let speed_unit = eigenvalue_unit - largest(&c1).max(largest(&k2).map(half)).unwrap_or(eigenvalue_unit);
        let scaled =
            |matrix: &Matrix<f64, 2>, i: usize, j: usize, power: i32| ldexp(matrix[(i, j)], row[i] + column[j] + power);
        let entry = |i: usize, j: usize| {
            let weight = scaled(&k0, i, j, gravity_exponent - 2 * eigenvalue_unit);
            let at_rest = Tracked::from(scaled(&kc, i, j, -2 * eigenvalue_unit))
                + DoubleDouble::product(gravity_fraction, weight).into();
            let linear = scaled(&c1, i, j, speed_unit - eigenvalue_unit);
            let square = scaled(&k2, i, j, 2 * (speed_unit - eigenvalue_unit));
            [
                Polynomial::new([at_rest, Tracked::ZERO, square.into()]),
                Polynomial::new([scaled(&c0, i, j, -eigenvalue_unit).into(), linear.into()]),
                Polynomial::constant(scaled(&m, i, j, 0)),
            ]
        };
        let determinant = determinant([[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]);
        let Some(&mass) = determinant[4].coefficients().first() else { return Err(SystemError::SingularMass) };
        if mass.value.to_f64().abs() <= 8.0 * f64::EPSILON * mass.size {
            return Err(SystemError::SingularMass);
        }
        let sign = f64::from(mass.sign());
        let coefficients = determinant.iter().map(|p| p * sign).skip_while(Polynomial::is_zero).collect();
        Ok(Self { coefficients, speed_unit, eigenvalue_unit })
    }

    /// The coefficients of the powers of s, without those of the lowest powers that are zero at all speeds; the last one
    /// is positive. An eigenvalue is zero at all speeds for each of the up to four that are left out.
    pub(super) fn coefficients(&self) -> &[Polynomial] {
        &self.coefficients
    }

    /// All coefficients at a scaled speed.
    pub(super) fn at(&self, speed: DoubleDouble) -> [Tracked; 5] {
        let zeros = 5 - self.coefficients.len();
        core::array::from_fn(
            |power| if power < zeros { Tracked::ZERO } else { self.coefficients[power - zeros].at(speed) },
        )
    }

    /// The scaled eigenvalues at a scaled speed, as the roots of two factors.
    pub(super) fn roots(&self, speed: DoubleDouble) -> [[Complex<f64>; 2]; 2] {
        let [d, c, b, a, leading] = self.at(speed).map(|p| p.value);
        let [a, b, c, d] = [a, b, c, d].map(|p| (p / leading).to_f64());
        Quartic { a, b, c, d }.roots()
    }

    /// The derivative with respect to the speed.
    pub(super) fn speed_derivative(&self) -> Self {
        let coefficients = self.coefficients.iter().map(Polynomial::derivative).collect();
        Self { coefficients, ..*self }
    }

    /// A scaled speed in m/s.
    pub(super) fn speed(&self, scaled: f64) -> f64 {
        ldexp(scaled, self.speed_unit)
    }

    /// A part of a scaled eigenvalue in 1/s.
    pub(super) fn eigenvalue(&self, scaled: f64) -> f64 {
        ldexp(scaled, self.eigenvalue_unit)
    }

    /// The Hurwitz determinant: zero where two eigenvalues, of those that are not zero at all speeds, sum to zero.
    pub(super) fn hurwitz(&self) -> Polynomial {
        match self.coefficients() {
            [p0, p1, p2, p3, p4] => &(p1 * &(&(p2 * p3) - &(p1 * p4))) - &(p0 * &(p3 * p3)),
            [p0, p1, p2, p3] => &(p1 * p2) - &(p0 * p3),
            [_, p1, _] => p1.clone(),
            _ => Polynomial::constant(1.0),
        }
    }

    /// The discriminant: zero where two eigenvalues, of those that are not zero at all speeds, coincide.
    pub(super) fn discriminant(&self) -> Polynomial {
        match self.coefficients() {
            // (4 I^3 - J^2) / 27 with the invariants I and J of the quartic; the factor does not matter.
            [e, d, c, b, a] => {
                let i = &(&(&(a * e) * 12.0) - &(&(b * d) * 3.0)) + &(c * c);
                let mixed = &(&(&(a * c) * e) * 72.0) + &(&(&(b * c) * d) * 9.0);
                let squares = &(&(&(d * d) * a) + &(&(b * b) * e)) * 27.0;
                let j = &(&mixed - &squares) - &(&(&(c * c) * c) * 2.0);
                &(&(&(&i * &i) * &i) * 4.0) - &(&j * &j)
            }
            [d, c, b, a] => {
                let (bc, ad) = (&(b * c), &(a * d));
                let cubes = &(&(&(b * b) * b) * d) + &(&(&(c * c) * c) * a);
                let products = &(&(bc * bc) + &(&(bc * ad) * 18.0)) - &(&(ad * ad) * 27.0);
                &products - &(&cubes * 4.0)
            }
            [c, b, a] => &(b * b) - &(&(a * c) * 4.0),
            _ => Polynomial::constant(1.0),
        }
    }
}

/// The coefficients in s of the determinant of a matrix of polynomials `K + C s + M s^2`, given as `[K, C, M]`.
fn determinant([[a, b], [c, d]]: [[[Polynomial; 3]; 2]; 2]) -> [Polynomial; 5] {
    core::array::from_fn(|power| {
        let pairs = (0..=2).flat_map(|i| (0..=2).map(move |j| (i, j))).filter(|(i, j)| i + j == power);
        pairs.fold(Polynomial::new([]), |sum, (i, j)| &sum + &(&(&a[i] * &d[j]) - &(&b[i] * &c[j])))
    })
}
