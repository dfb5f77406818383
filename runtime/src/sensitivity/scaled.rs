//! The characteristic polynomial of two coordinates and its derivatives, at any scale of the matrices.

use crate::characteristic::determinant::{self, ByPower, Rows, rows};
use crate::characteristic::units::Units;
use crate::numeric::{DoubleDouble, Exact, Tracked};
use crate::system::{Coefficients, SystemError};

/// The coefficients of `det(M s^2 + C s + K)` in s, ascending, or their derivatives.
pub(super) type Quartic = [Tracked; 5];

/// The matrices of two coordinates, with rows, columns, time and speed measured in powers of two that bring all entries to
/// at most about one.
pub(super) struct Scaled {
    coefficients: Coefficients<f64, 2>,
    gravity: f64,
    pub(super) units: Units<2>,
}

impl Scaled {
    pub(super) fn new(coefficients: &Coefficients<f64, 2>, gravity: f64) -> Result<Self, SystemError> {
        let units = Units::of_coefficients(coefficients, gravity)?;
        let coefficients = units.scale_coefficients(coefficients);
        Ok(Self { coefficients, gravity: units.scale_gravity(gravity), units })
    }

    /// The characteristic polynomial at a scaled speed.
    pub(super) fn characteristic(&self, speed: DoubleDouble) -> Quartic {
        determinant::coefficients(self.matrices(speed))
    }

    /// K, C and M at a scaled speed.
    pub(super) fn matrices(&self, speed: DoubleDouble) -> ByPower<Rows<Tracked>> {
        self.matrices_of(&self.coefficients, speed)
    }

    /// The derivative of the characteristic polynomial with respect to the speed.
    pub(super) fn by_speed(&self, speed: DoubleDouble) -> Quartic {
        let Coefficients { c1, k2, .. } = &self.coefficients;
        let twice = Tracked::from(speed + speed);
        let stiffness = rows(k2).map(|row| row.map(|entry| Exact(entry) * twice));
        let damping = rows(c1).map(|row| row.map(Tracked::from));
        determinant::derivatives(self.matrices(speed), [stiffness, damping, [[Tracked::ZERO; 2]; 2]])
    }

    /// Its derivative in the direction of scaled derivatives of the coefficients.
    fn by(&self, direction: &Coefficients<f64, 2>, speed: DoubleDouble) -> Quartic {
        determinant::derivatives(self.matrices(speed), self.matrices_of(direction, speed))
    }

    fn matrices_of(&self, coefficients: &Coefficients<f64, 2>, speed: DoubleDouble) -> ByPower<Rows<Tracked>> {
        let Coefficients { m, c0, c1, kc, k0, k2 } = coefficients;
        let speed = Tracked::from(speed);
        let square = speed * speed;
        let each = |entry: &dyn Fn((usize, usize)) -> Tracked| {
            [[entry((0, 0)), entry((0, 1))], [entry((1, 0)), entry((1, 1))]]
        };
        let stiffness =
            each(&|at| Tracked::from(kc[at]) + Exact(self.gravity) * Exact(k0[at]) + Exact(k2[at]) * square);
        [stiffness, each(&|at| Tracked::from(c0[at]) + Exact(c1[at]) * speed), each(&|at| m[at].into())]
    }

    /// The derivatives of K, C and M at a scaled speed in the direction of scaled derivatives of the coefficients.
    pub(super) fn direction(&self, direction: &Coefficients<f64, 2>, speed: f64) -> ByPower<Rows> {
        let Coefficients { m, c0, c1, kc, k0, k2 } = direction;
        [rows(&(kc + k0 * self.gravity + k2 * speed * speed)), rows(&(c0 + c1 * speed)), rows(m)]
    }

    /// How many of the lowest coefficients are zero at all speeds.
    pub(super) fn zeros(&self, speed: DoubleDouble) -> usize {
        let is_zero = |power: usize| samples(speed).iter().all(|&v| self.characteristic(v)[power].sign() == 0);
        (0..4).take_while(|&power| is_zero(power)).count()
    }

    /// Whether so many of the lowest coefficients stay zero at all speeds in a direction.
    pub(super) fn keeps_zeros(&self, zeros: usize, direction: &Coefficients<f64, 2>, speed: DoubleDouble) -> bool {
        zeros == 0 || samples(speed).iter().all(|&v| self.by(direction, v)[..zeros].iter().all(|p| p.sign() == 0))
    }
}

/// Different speeds, more than the degree of the coefficients, which are polynomials in the speed; the first one tells most.
fn samples(speed: DoubleDouble) -> [DoubleDouble; 5] {
    [2.0, 3.0, 4.0, 5.0, 1.0].map(|factor: f64| speed * factor.into())
}
