//! The derivatives of critical speeds of any number of coordinates, by null vectors.
//!
//! With x and y fixed in one entry each, `Q x = g e` and `y^T Q = g e'^T` define a scalar g(v, s) that is zero where Q is
//! singular, and whose derivatives are those of an eigenvalue problem: `g_s = y^T Q_s x`, and in a direction `y^T dQ x`
//! (Govaerts 2000, Numerical Methods for Bifurcations of Dynamical Equilibria, chapter 3). The conditions are g(v, 0) = 0
//! for capsize, g(v, i omega) = 0 for weave, and g = g_s = 0 for a double root.

use nalgebra::Complex;

use super::critical::{CriticalDerivative, MEETING, NEAR, NEGLIGIBLE, NotDifferentiable, SMALL, STEPS};
use crate::numeric::{ComplexDoubleDouble, DoubleDouble};
use crate::pencil::{Elimination, Equations, Matrices, dot};
use crate::stability::{CriticalKind, CriticalSpeed};
use crate::system::{States, SystemError};

type Vector = Vec<ComplexDoubleDouble>;

/// A critical speed with its null vectors.
struct Condition {
    kind: CriticalKind,
    s: ComplexDoubleDouble,
    right: Vector,
    left: Vector,
    /// The derivative of the right null vector by s.
    right_by_s: Vector,
    elimination: Elimination,
    matrices: Matrices,
    g: ComplexDoubleDouble,
    by_s: ComplexDoubleDouble,
    by_v: ComplexDoubleDouble,
    by_ss: ComplexDoubleDouble,
    by_sv: ComplexDoubleDouble,
    /// By how much rounding of the terms of Q moves the speed, both relative.
    rounding: f64,
}

/// How a critical speed and its eigenvalue answer to a change.
#[derive(Clone, Copy)]
struct Response {
    /// Complex where no real speed answers.
    speed: ComplexDoubleDouble,
    eigenvalue: ComplexDoubleDouble,
}

/// The derivatives of a critical speed in so many directions.
pub(super) fn differentiate(
    equations: &Equations,
    critical: &CriticalSpeed,
    directions: usize,
    direction: &dyn Fn(usize) -> Equations,
) -> Result<CriticalDerivative, SystemError> {
    let lowered = lowered(equations, critical);
    let (condition, speed) = match find_condition(equations, critical, &lowered) {
        Ok(found) => found,
        Err(reason) => return Ok(CriticalDerivative::None(reason)),
    };
    let finite = |value: DoubleDouble| {
        let value = value.to_f64();
        let error = SystemError::OutOfRange { quantity: "a derivative of a critical speed" };
        // Adding zero turns -0 into 0.
        if value.is_finite() { Ok(value + 0.0) } else { Err(error) }
    };
    let (mut speeds, mut eigenvalues) = (Vec::new(), Vec::new());
    for index in 0..directions {
        let direction = direction(index);
        let keeps_zeros = equations.states().iter().zip(&lowered).enumerate().all(|(column, (states, &lowered))| {
            lowered == usize::from(*states == States::Rate) || direction.is_loose(column)
        });
        let direction = direction.at(speed).lowered(&lowered);
        let (Response { speed, eigenvalue }, size) = condition.along(&direction);
        if !keeps_zeros || speed.im.to_f64().abs() > NEGLIGIBLE * size {
            return Ok(CriticalDerivative::None(NotDifferentiable::Coincidence));
        }
        // The derivatives are given to the digits of doubles: what is less than these leave of the terms is zero.
        let is_rounding = speed.norm() <= f64::EPSILON * size;
        speeds.push(if is_rounding { 0.0 } else { finite(speed.re)? });
        eigenvalues.push(Complex::new(finite(eigenvalue.re)?, finite(eigenvalue.im)?));
    }
    Ok(CriticalDerivative::Smooth { speed: speeds, eigenvalue: eigenvalues, condition: condition.rounding })
}

/// By column the power of s that it is divided by. Where an eigenvalue is zero at all speeds since nothing holds a coordinate,
/// that zero is divided out of the condition that another one is zero.
fn lowered(equations: &Equations, critical: &CriticalSpeed) -> Vec<usize> {
    let of = |(column, states): (usize, &States)| match states {
        States::Rate => 1,
        States::Both => usize::from(critical.kind == CriticalKind::Capsize && equations.is_loose(column)),
        States::Position => 0,
    };
    equations.states().iter().enumerate().map(of).collect()
}

/// The condition at the speed itself, which is polished.
fn find_condition(
    equations: &Equations,
    critical: &CriticalSpeed,
    lowered: &[usize],
) -> Result<(Condition, DoubleDouble), NotDifferentiable> {
    let mut speed = DoubleDouble::from(critical.speed);
    let mut s = match critical.kind {
        CriticalKind::Capsize => ComplexDoubleDouble::ZERO,
        _ => ComplexDoubleDouble { re: critical.eigenvalue.re.into(), im: critical.eigenvalue.im.into() },
    };
    let at = |speed: DoubleDouble, s: ComplexDoubleDouble| Condition::new(equations, critical.kind, speed, s, lowered);
    for _ in 0..STEPS {
        let condition = at(speed, s)?;
        let step = condition.answer([condition.g, condition.by_s]);
        let relative = step.speed.norm() / speed.to_f64();
        if relative.is_nan() || relative > NEAR {
            return Err(NotDifferentiable::Meeting);
        }
        speed = speed + step.speed.re;
        s = s + step.eigenvalue;
        if relative <= SMALL && step.eigenvalue.norm() <= SMALL * s.norm() {
            break;
        }
    }
    Ok((at(speed, s)?, speed))
}

fn is_large(condition: f64) -> bool {
    condition.is_nan() || condition >= MEETING
}

impl Condition {
    fn new(
        equations: &Equations,
        kind: CriticalKind,
        speed: DoubleDouble,
        s: ComplexDoubleDouble,
        lowered: &[usize],
    ) -> Result<Self, NotDifferentiable> {
        let matrices = equations.at(speed).lowered(lowered);
        let by_speed = equations.by_speed(speed).lowered(lowered);
        let value = matrices.at(s, 0);
        let elimination = Elimination::new(&value, &matrices.sizes(s.norm(), 0));
        let (right, left) = (elimination.right(0), elimination.left(0));
        // A second null vector: two eigenvalues are there at once, and not as at a double root, where there is one vector.
        if is_large(1.0 / elimination.pivot(1)) {
            return Err(NotDifferentiable::Coincidence);
        }
        let slope = matrices.at(s, 1);
        let (along_s, along_v) = (slope.times(&right), by_speed.at(s, 0).times(&right));
        let opposite = |along: &Vector| elimination.solve(&along.iter().map(|&entry| -entry).collect::<Vector>());
        let (right_by_s, right_by_v) = (opposite(&along_s), opposite(&along_v));
        let twice = |value: ComplexDoubleDouble| value + value;
        let (by_s, by_v) = (dot(&left, &along_s), dot(&left, &along_v));
        let by_ss = matrices.form([&left, &right], s, 2) + twice(dot(&left, &slope.times(&right_by_s)));
        let by_sv = by_speed.form([&left, &right], s, 1)
            + dot(&left, &slope.times(&right_by_v))
            + by_speed.form([&left, &right_by_s], s, 0);
        let g = dot(&left, &value.times(&right));
        let size = matrices.form_of_sizes([&left, &right], s, 0);
        let leverage = match kind {
            CriticalKind::Weave => 1.0 / (by_s.norm() * (by_v / by_s).re.to_f64().abs()),
            _ => 1.0 / by_v.norm(),
        };
        let mut rounding = size * leverage / speed.to_f64();
        if kind == CriticalKind::DoubleRoot {
            let curvature = matrices.form_of_sizes([&left, &right], s, 2)
                + 2.0 * matrices.form_of_sizes([&left, &right_by_s], s, 1);
            rounding = rounding.max(curvature / by_ss.norm());
        }
        if is_large(rounding) {
            return Err(NotDifferentiable::Meeting);
        }
        Ok(Self { kind, s, right, left, right_by_s, elimination, matrices, g, by_s, by_v, by_ss, by_sv, rounding })
    }

    /// The response to a change of the matrices, and the size of the terms of the speed's.
    fn along(&self, direction: &Matrices) -> (Response, f64) {
        let change = direction.form([&self.left, &self.right], self.s, 0);
        let slope = match self.kind {
            CriticalKind::DoubleRoot => {
                let along = direction.at(self.s, 0).times(&self.right);
                let right = self.elimination.solve(&along.into_iter().map(|entry| -entry).collect::<Vector>());
                direction.form([&self.left, &self.right], self.s, 1)
                    + self.matrices.form([&self.left, &right], self.s, 1)
                    + direction.form([&self.left, &self.right_by_s], self.s, 0)
            }
            _ => ComplexDoubleDouble::ZERO,
        };
        let size = direction.form_of_sizes([&self.left, &self.right], self.s, 0) / self.by_v.norm();
        (self.answer([change, slope]), size)
    }

    /// The answer to a change of g and of its slope in s.
    fn answer(&self, [value, slope]: [ComplexDoubleDouble; 2]) -> Response {
        match self.kind {
            CriticalKind::Capsize => Response { speed: -(value / self.by_v), eigenvalue: ComplexDoubleDouble::ZERO },
            CriticalKind::Weave => {
                // g_v dv + i g_s d(omega) = -change, two real equations.
                let by_omega = ComplexDoubleDouble { re: -self.by_s.im, im: self.by_s.re };
                let cross = |x: ComplexDoubleDouble, y: ComplexDoubleDouble| x.re * y.im - x.im * y.re;
                let determinant = cross(self.by_v, by_omega);
                let omega = -cross(self.by_v, value) / determinant;
                let speed = -cross(value, by_omega) / determinant;
                let eigenvalue = ComplexDoubleDouble { re: DoubleDouble::ZERO, im: omega };
                Response { speed: ComplexDoubleDouble::real(speed), eigenvalue }
            }
            CriticalKind::DoubleRoot => {
                let determinant = self.by_v * self.by_ss - self.by_s * self.by_sv;
                let speed = (self.by_s * slope - self.by_ss * value) / determinant;
                let eigenvalue = (self.by_sv * value - self.by_v * slope) / determinant;
                Response { speed, eigenvalue }
            }
        }
    }
}
