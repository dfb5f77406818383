//! The characteristic polynomial of two coordinates and its derivatives, at any scale of the matrices.

use crate::characteristic::determinant::{self, ByPower, Rows, mixed};
use crate::characteristic::units::Units;
use crate::numeric::{DoubleDouble, Exact, Tracked};
use crate::system::{Coefficients, Matrix, SystemError};

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

    /// K, C and M at a scaled speed.
    pub(super) fn matrices(&self, speed: DoubleDouble) -> ByPower<Rows<Tracked>> {
        self.matrices_of(&self.coefficients, speed)
    }

    /// The derivative of the characteristic polynomial with respect to the speed, which M does not depend on.
    pub(super) fn by_speed(&self, [k, c, m]: ByPower<Rows<Tracked>>, speed: DoubleDouble) -> Quartic {
        let Coefficients { cm1, c1, k1, k2, .. } = &self.coefficients;
        let twice = Tracked::from(speed + speed);
        let over_square = inverse(cm1, speed * speed);
        let dk = each(|at| Tracked::from(k1[at]) + Exact(k2[at]) * twice);
        let dc = each(|at| Tracked::from(c1[at]) + Exact(-cm1[at]) * over_square);
        let inner = mixed(c, dc) + mixed(m, dk);
        [mixed(k, dk), mixed(k, dc) + mixed(c, dk), inner, mixed(m, dc), Tracked::ZERO]
    }

    /// The same in `f64`.
    pub(super) fn rounded_by_speed(&self, matrices: ByPower<Rows<Tracked>>, speed: f64) -> [f64; 5] {
        let Coefficients { cm1, c1, k1, k2, .. } = &self.coefficients;
        let [k, c, m] = matrices.map(|rows| rows.map(|row| row.map(|entry| entry.value.to_f64())));
        let over_square = inverse(cm1, DoubleDouble::from(speed * speed)).value.to_f64();
        let entries = |entry: &dyn Fn((usize, usize)) -> f64| -> Rows {
            [[entry((0, 0)), entry((0, 1))], [entry((1, 0)), entry((1, 1))]]
        };
        let dk = entries(&|at| k1[at] + k2[at] * (2.0 * speed));
        let dc = entries(&|at| c1[at] - cm1[at] * over_square);
        let no = [[0.0; 2]; 2];
        determinant::derivatives([k, c, m], [dk, dc, no])
    }

    /// The derivative of the characteristic polynomial in the direction of scaled derivatives of the coefficients.
    fn by(&self, direction: &Coefficients<f64, 2>, speed: DoubleDouble) -> Quartic {
        determinant::derivatives(self.matrices(speed), self.matrices_of(direction, speed))
    }

    fn matrices_of(&self, coefficients: &Coefficients<f64, 2>, speed: DoubleDouble) -> ByPower<Rows<Tracked>> {
        let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, states: _ } = coefficients;
        let over_speed = inverse(cm1, speed);
        let speed = Tracked::from(speed);
        let square = speed * speed;
        let stiffness = each(|at| {
            let standing = Tracked::from(kc[at]) + Exact(self.gravity) * Exact(k0[at]);
            standing + Exact(k1[at]) * speed + Exact(k2[at]) * square
        });
        let damping = each(|at| Exact(cm1[at]) * over_speed + Tracked::from(c0[at]) + Exact(c1[at]) * speed);
        [stiffness, damping, each(|at| m[at].into())]
    }

    /// What each of the coefficient matrices is a coefficient of at a scaled speed: the power of s, and the factor that is
    /// not s; by the place in [`MatrixName::ALL`](crate::system::MatrixName::ALL).
    pub(super) fn factors(&self, speed: f64) -> [(usize, f64); 8] {
        let square = speed * speed;
        [(2, 1.0), (1, 1.0 / speed), (1, 1.0), (1, speed), (0, 1.0), (0, self.gravity), (0, speed), (0, square)]
    }

    /// How many of the lowest coefficients are zero at all speeds.
    pub(super) fn zeros(&self, speed: DoubleDouble) -> usize {
        let is_zero = |power: usize| {
            samples(speed).iter().all(|&v| determinant::coefficients(self.matrices(v))[power].sign() == 0)
        };
        (0..4).take_while(|&power| is_zero(power)).count()
    }

    /// Whether so many of the lowest coefficients stay zero at all speeds in a direction.
    pub(super) fn keeps_zeros(&self, zeros: usize, direction: &Coefficients<f64, 2>, speed: DoubleDouble) -> bool {
        zeros == 0 || samples(speed).iter().all(|&v| self.by(direction, v)[..zeros].iter().all(|p| p.sign() == 0))
    }
}

fn each(entry: impl Fn((usize, usize)) -> Tracked) -> Rows<Tracked> {
    [[entry((0, 0)), entry((0, 1))], [entry((1, 0)), entry((1, 1))]]
}

/// What entries of C-1 are multiplied by, one over a power of the speed: zero where there is none, so that nothing is
/// divided by a speed of zero.
fn inverse(cm1: &Matrix<f64, 2>, power: DoubleDouble) -> Tracked {
    let is_there = cm1.iter().any(|&entry| entry != 0.0);
    if is_there { Tracked::from(DoubleDouble::from(1.0) / power) } else { Tracked::ZERO }
}

/// Different speeds, more than the degree of the coefficients, which are polynomials in the speed; the first one tells most.
fn samples(speed: DoubleDouble) -> [DoubleDouble; 5] {
    [2.0, 3.0, 4.0, 5.0, 1.0].map(|factor: f64| speed * factor.into())
}
