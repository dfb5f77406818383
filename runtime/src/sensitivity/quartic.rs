//! The derivatives of critical speeds of two coordinates, by the coefficients of their quartic.

use nalgebra::Complex;

use super::Sensitivity;
use super::condition::{Answers, Condition};
use super::critical::{CriticalDerivative, MEETING, NEAR, NEGLIGIBLE, NotDifferentiable, SMALL, STEPS};
use super::scaled::Scaled;
use crate::numeric::{ComplexDoubleDouble, DoubleDouble, ldexp};
use crate::stability::{CriticalKind, CriticalSpeed};
use crate::system::{Coefficients, Matrix, SystemError};

impl Sensitivity<2> {
    /// Those of a speed at which the quartic, or its slope, is zero.
    pub(super) fn of_quartic(&self, critical: &CriticalSpeed) -> Result<CriticalDerivative, SystemError> {
        let scaled = Scaled::new(&self.coefficients, self.gravity)?;
        let (condition, speed) = match find_condition(&scaled, critical) {
            Ok(found) => found,
            Err(reason) => return Ok(CriticalDerivative::None(reason)),
        };
        let finite = |value: f64, unit: i32| {
            let value = ldexp(value, unit);
            let error = SystemError::OutOfRange { quantity: "a derivative of a critical speed" };
            if value.is_finite() { Ok(value) } else { Err(error) }
        };
        let weights = weights(&condition.answers(), &scaled, speed.to_f64());
        let count = self.derivatives.len();
        let (mut speeds, mut eigenvalues) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for (parameter, derivative) in self.derivatives.iter().enumerate() {
            let is_gravity = self.gravity_parameter == Some(parameter);
            let keeps_zeros = condition.zeros == 0 || {
                let kc = if is_gravity { derivative.kc + self.coefficients.k0 } else { derivative.kc };
                let direction = scaled.units.scale_coefficients(&Coefficients { kc, ..*derivative });
                scaled.keeps_zeros(condition.zeros, &direction, speed)
            };
            let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, states: _ } = derivative;
            let mut answer = Answer::NONE;
            for (matrix, weights) in [m, cm1, c0, c1, kc, k0, k1, k2].into_iter().zip(&weights) {
                answer.add(matrix, weights);
            }
            if is_gravity {
                let [.., of_kc, _, _, _] = &weights;
                answer.add(&self.coefficients.k0, of_kc);
            }
            if !keeps_zeros || answer.speed.im.abs() > NEGLIGIBLE * answer.size {
                return Ok(CriticalDerivative::None(NotDifferentiable::Coincidence));
            }
            speeds.push(finite(answer.speed.re, scaled.units.speed)?);
            let part = |part: f64| finite(part, scaled.units.time);
            eigenvalues.push(Complex::new(part(answer.eigenvalue.re)?, part(answer.eigenvalue.im)?));
        }
        Ok(CriticalDerivative::Smooth { speed: speeds, eigenvalue: eigenvalues, condition: condition.condition() })
    }
}

/// What a change of one entry of a coefficient matrix is multiplied by: first by powers of two, in two steps so that each is in
/// the range of `f64`, then by the derivatives of the critical speed and of its eigenvalue.
#[derive(Clone, Copy)]
struct Weight {
    scale: [f64; 2],
    speed: Complex<f64>,
    eigenvalue: Complex<f64>,
}

/// By the place of the matrix in [`MatrixName::ALL`](crate::system::MatrixName::ALL), column by column.
fn weights(answers: &Answers, scaled: &Scaled, speed: f64) -> [[Weight; 4]; 8] {
    let (exponents, factors) = (scaled.units.exponents(), scaled.factors(speed));
    core::array::from_fn(|which| {
        let (power, factor) = factors[which];
        [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(i, j)| {
            let (exponent, half) = (exponents[which][i][j], exponents[which][i][j] / 2);
            Weight {
                scale: [half, exponent - half].map(|exponent| ldexp(1.0, exponent)),
                speed: answers.speed[power][i][j] * factor,
                eigenvalue: answers.eigenvalue[power][i][j] * factor,
            }
        })
    })
}

/// The derivatives of a critical speed and of its eigenvalue in a direction: sums of derivatives by entries times changes.
struct Answer {
    speed: Complex<f64>,
    eigenvalue: Complex<f64>,
    /// The size of the terms of the speed's.
    size: f64,
}

impl Answer {
    const NONE: Self = Self { speed: Complex::new(0.0, 0.0), eigenvalue: Complex::new(0.0, 0.0), size: 0.0 };

    /// Adds what the change of one coefficient matrix makes.
    #[inline]
    fn add(&mut self, change: &Matrix<f64, 2>, weights: &[Weight; 4]) {
        // One question for most of the matrices, and not one for each entry.
        if change.as_slice().iter().fold(true, |is_zero, &change| is_zero & (change == 0.0)) {
            return;
        }
        for (&change, weight) in change.as_slice().iter().zip(weights) {
            // Most entries do not depend on a parameter.
            if change == 0.0 {
                continue;
            }
            let change = change * weight.scale[0] * weight.scale[1];
            let term = weight.speed * change;
            self.speed += term;
            self.size += term.l1_norm();
            self.eigenvalue += weight.eigenvalue * change;
        }
    }
}

/// The condition of a critical speed at the speed itself, which is polished, in the units of the condition.
fn find_condition(scaled: &Scaled, critical: &CriticalSpeed) -> Result<(Condition, DoubleDouble), NotDifferentiable> {
    let kind = critical.kind;
    let mut speed = DoubleDouble::from(ldexp(critical.speed, -scaled.units.speed));
    let part = |part: f64| DoubleDouble::from(ldexp(part, -scaled.units.time));
    let mut s = match kind {
        CriticalKind::Capsize => ComplexDoubleDouble::ZERO,
        _ => ComplexDoubleDouble { re: part(critical.eigenvalue.re), im: part(critical.eigenvalue.im) },
    };
    // Eigenvalues are measured in a unit of which the largest terms are about one.
    if s.norm() < NEGLIGIBLE {
        s = ComplexDoubleDouble::ZERO;
    }
    let is_zero = s == ComplexDoubleDouble::ZERO;
    let zeros = if is_zero { scaled.zeros(speed) } else { 0 };
    let at = |speed: DoubleDouble, s: ComplexDoubleDouble| {
        let condition = Condition::new(scaled, kind, speed, s, zeros);
        if condition.condition() < MEETING { Ok(condition) } else { Err(NotDifferentiable::Meeting) }
    };
    for _ in 0..STEPS {
        let step = at(speed, s)?.residual();
        let relative = step.speed.norm() / speed.to_f64();
        if relative > NEAR {
            return Err(NotDifferentiable::Meeting);
        }
        speed = speed + step.speed.re;
        if !is_zero {
            s = s + step.eigenvalue;
        }
        if relative <= SMALL && step.eigenvalue.norm() <= SMALL * s.norm() {
            break;
        }
    }
    Ok((at(speed, s)?, speed))
}
