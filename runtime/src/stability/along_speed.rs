//! The characteristic polynomial of two coordinates as a polynomial in the eigenvalue and in the speed.

use nalgebra::Complex;

use crate::characteristic::conditions::{self, QuarticConditions};
use crate::characteristic::determinant::rows;
use crate::characteristic::powers::{InSpeed, Matrices, Powers};
use crate::characteristic::units::{Units, ldexp_complex};
use crate::eigenvalues::Quartic;
use crate::numeric::{DoubleDouble, Polynomial, Tracked, ldexp};
use crate::system::{Coefficients, SystemError, require_finite};

/// `det(M s^2 + (C0 + v C1) s + Kc + g K0 + v^2 K2)`, up to a factor, as `p_0(v) + p_1(v) s + ... + p_4 s^4`.
///
/// Exact but for the rounding of double-double arithmetic. Speed and eigenvalues are measured in powers of two of m/s and
/// 1/s that bring all entries to at most one.
pub(super) struct Characteristic {
    powers: Powers<InSpeed>,
    /// From the first one that is not zero at all speeds.
    coefficients: Vec<Polynomial>,
    units: Units<2>,
}

impl Characteristic {
    pub(super) fn new(coefficients: &Coefficients<f64, 2>, gravity: f64) -> Result<Self, SystemError> {
        require_finite("gravity", gravity)?;
        coefficients.require_finite()?;
        let units = Units::of_coefficients(coefficients, gravity)?;
        let matrices = {
            let Coefficients { m, c0, c1, kc, k0, k2, .. } = units.scale_coefficients(coefficients);
            Matrices::new([m, c0, c1, kc, k0, k2].map(|matrix| rows(&matrix)), units.scale_gravity(gravity))
        };
        if matrices.mass.value.to_f64().abs() <= 8.0 * f64::EPSILON * matrices.mass.size {
            return Err(SystemError::SingularMass);
        }
        let powers = matrices.in_speed();
        let Powers { p0, p1, p2, p3, p4 } = &powers;
        let all = [&p0[..], p1, p2, p3, core::slice::from_ref(p4)].map(|p| Polynomial::new(p.iter().copied()));
        let coefficients = all.into_iter().skip_while(Polynomial::is_zero).collect();
        Ok(Self { powers, coefficients, units })
    }

    /// The coefficients of the powers of s, without those of the lowest powers that are zero at all speeds; the last one
    /// is positive. An eigenvalue is zero at all speeds for each of the up to four that are left out.
    pub(super) fn coefficients(&self) -> &[Polynomial] {
        &self.coefficients
    }

    /// All coefficients at a scaled speed.
    pub(super) fn at(&self, speed: DoubleDouble) -> [Tracked; 5] {
        self.each(|polynomial| polynomial.at(speed))
    }

    /// Their derivatives with respect to the speed.
    pub(super) fn slopes_at(&self, speed: DoubleDouble) -> [Tracked; 5] {
        self.each(|polynomial| polynomial.derivative().at(speed))
    }

    fn each(&self, value: impl Fn(&Polynomial) -> Tracked) -> [Tracked; 5] {
        let zeros = 5 - self.coefficients.len();
        core::array::from_fn(|power| match power.checked_sub(zeros) {
            Some(power) => value(&self.coefficients[power]),
            None => Tracked::ZERO,
        })
    }

    /// The scaled eigenvalues at a scaled speed, as the roots of two factors.
    pub(super) fn roots(&self, speed: DoubleDouble) -> [[Complex<f64>; 2]; 2] {
        let [d, c, b, a, leading] = self.at(speed).map(|p| p.value);
        let [a, b, c, d] = [a, b, c, d].map(|p| (p / leading).to_f64());
        Quartic { a, b, c, d }.nearest_roots().0
    }

    /// A scaled speed in m/s.
    pub(super) fn speed(&self, scaled: f64) -> f64 {
        ldexp(scaled, self.units.speed)
    }

    /// A scaled eigenvalue in 1/s.
    pub(super) fn eigenvalue(&self, scaled: Complex<f64>) -> Complex<f64> {
        ldexp_complex(scaled, self.units.time)
    }

    /// The Hurwitz determinant: zero where two eigenvalues, of those that are not zero at all speeds, sum to zero.
    pub(super) fn hurwitz(&self) -> Polynomial {
        match self.coefficients() {
            [_, _, _, _, _] => Polynomial::new(QuarticConditions::new(&self.powers).hurwitz()),
            [p0, p1, p2, p3] => conditions::hurwitz_of_cubic([p0, p1, p2, p3].map(Clone::clone)),
            [_, p1, _] => p1.clone(),
            _ => Polynomial::constant(1.0),
        }
    }

    /// The discriminant: zero where two eigenvalues, of those that are not zero at all speeds, coincide.
    pub(super) fn discriminant(&self) -> Polynomial {
        match self.coefficients() {
            [_, _, _, _, _] => Polynomial::new(QuarticConditions::new(&self.powers).discriminant()),
            [d, c, b, a] => conditions::discriminant_of_cubic([d, c, b, a]),
            [c, b, a] => conditions::discriminant_of_quadratic([c, b, a]),
            _ => Polynomial::constant(1.0),
        }
    }
}
