//! The derivatives of critical speeds of two coordinates, by the coefficients of their quartic.

use nalgebra::Complex;

use super::Sensitivity;
use super::condition::{Answers, Condition, newton_step};
use super::critical::{CriticalDerivative, MEETING, NEAR, NEGLIGIBLE, NotDifferentiable, SMALL, STEPS};
use super::scaled::Scaled;
use crate::characteristic::units::ldexp_complex;
use crate::numeric::{ComplexDoubleDouble, DoubleDouble, ldexp};
use crate::stability::{CriticalKind, CriticalSpeed};
use crate::system::{Coefficients, SystemError};

impl Sensitivity<2> {
    /// Those of a speed at which the quartic, or its slope, is zero.
    pub(super) fn of_quartic(&self, critical: &CriticalSpeed) -> Result<CriticalDerivative, SystemError> {
        let scaled = Scaled::new(&self.coefficients, self.gravity)?;
        let (condition, speed) = match find_condition(&scaled, critical) {
            Ok(found) => found,
            Err(reason) => return Ok(CriticalDerivative::None(reason)),
        };
        let count = self.derivatives.len();
        let (mut speeds, mut eigenvalues) = (Vec::with_capacity(count), Vec::with_capacity(count));
        // Most have two numbers that are not zero, and not four.
        let is_smooth = match critical.kind {
            CriticalKind::Weave => {
                let weights = weights(&condition.answers(), &scaled, speed, |speed, value| [speed.re, value.im]);
                self.each_answer(&condition, &scaled, speed, &weights, |Answer { parts: [speed, omega], .. }| {
                    speeds.push(speed);
                    eigenvalues.push(Complex::new(0.0, omega));
                    true
                })
            }
            _ if condition.is_real() => {
                let weights = weights(&condition.answers(), &scaled, speed, |speed, value| [speed.re, value.re]);
                self.each_answer(&condition, &scaled, speed, &weights, |Answer { parts: [speed, value], .. }| {
                    speeds.push(speed);
                    eigenvalues.push(Complex::new(value, 0.0));
                    true
                })
            }
            _ => {
                let parts = |speed: Complex<f64>, value: Complex<f64>| [speed.re, value.re, value.im, speed.im];
                let weights = weights(&condition.answers(), &scaled, speed, parts);
                self.each_answer(
                    &condition,
                    &scaled,
                    speed,
                    &weights,
                    |Answer { parts: [speed, re, im, rest], size }| {
                        speeds.push(speed);
                        eigenvalues.push(Complex::new(re, im));
                        rest.abs() <= NEGLIGIBLE * size
                    },
                )
            }
        };
        if !is_smooth {
            return Ok(CriticalDerivative::None(NotDifferentiable::Coincidence));
        }
        speeds.iter_mut().for_each(|speed| *speed = ldexp(*speed, scaled.units.speed));
        eigenvalues.iter_mut().for_each(|value| *value = ldexp_complex(*value, scaled.units.time));
        let is_finite = eigenvalues.iter().fold(true, |all, value| all & value.re.is_finite() & value.im.is_finite());
        if !(is_finite && speeds.iter().all(|speed| speed.is_finite())) {
            return Err(SystemError::OutOfRange { quantity: "a derivative of a critical speed" });
        }
        Ok(CriticalDerivative::Smooth { speed: speeds, eigenvalue: eigenvalues, condition: condition.condition() })
    }

    /// The answers to a change of each parameter; false from where one is refused, or does not keep eigenvalues that are zero at all
    /// speeds.
    fn each_answer<const P: usize>(
        &self,
        condition: &Condition,
        scaled: &Scaled,
        speed: DoubleDouble,
        weights: &Weights<P>,
        mut take: impl FnMut(Answer<P>) -> bool,
    ) -> bool {
        let mut first = 0;
        self.derivatives.iter().zip(&self.ends).enumerate().all(|(parameter, (derivative, &end))| {
            let is_gravity = self.gravity_parameter == Some(parameter);
            let keeps_zeros = condition.zeros == 0 || {
                let kc = if is_gravity { derivative.kc + self.coefficients.k0 } else { derivative.kc };
                let direction = scaled.units.scale_coefficients(&Coefficients { kc, ..*derivative });
                scaled.keeps_zeros(condition.zeros, &direction, speed)
            };
            let mut answer = Answer::NONE;
            for change in &self.changes[core::mem::replace(&mut first, end)..end] {
                answer.add(change.value, &weights[change.place]);
            }
            if is_gravity {
                const KC: usize = 16;
                let entries = self.coefficients.k0.as_slice().iter();
                entries.zip(&weights[KC..]).for_each(|(&entry, weight)| answer.add(entry, weight));
            }
            keeps_zeros && take(answer)
        })
    }
}

/// What a change of one entry of a coefficient matrix is multiplied by: first by powers of two, in two steps so that each is in
/// the range of `f64`, then by the derivatives of the critical speed and of its eigenvalue: those of P real and imaginary parts that
/// are not zero.
#[derive(Clone, Copy)]
struct Weight<const P: usize> {
    scale: [f64; 2],
    parts: [f64; P],
}

/// By the [place](super::Change::place) of the entry.
type Weights<const P: usize> = [Weight<P>; 32];

fn weights<const P: usize>(
    answers: &Answers,
    scaled: &Scaled,
    speed: DoubleDouble,
    parts: impl Fn(Complex<f64>, Complex<f64>) -> [f64; P],
) -> Weights<P> {
    let (exponents, factors) = (scaled.units.exponents(), scaled.factors(speed.to_f64()));
    let mut weights = [Weight { scale: [0.0; 2], parts: [0.0; P] }; 32];
    for ((weights, exponents), (power, factor)) in weights.chunks_exact_mut(4).zip(&exponents).zip(factors) {
        for (weight, (i, j)) in weights.iter_mut().zip([(0, 0), (1, 0), (0, 1), (1, 1)]) {
            let (exponent, half) = (exponents[i][j], exponents[i][j] / 2);
            let parts = parts(answers.speed[power][i][j], answers.eigenvalue[power][i][j]);
            *weight = Weight {
                scale: [ldexp(1.0, half), ldexp(1.0, exponent - half)],
                parts: parts.map(|part| part * factor),
            };
        }
    }
    weights
}

/// The derivatives of a critical speed and of its eigenvalue in a direction: sums of derivatives by entries times changes.
struct Answer<const P: usize> {
    parts: [f64; P],
    /// The size of the terms of the speed's, the first and the last one, where it may be complex.
    size: f64,
}

impl<const P: usize> Answer<P> {
    const NONE: Self = Self { parts: [0.0; P], size: 0.0 };

    /// Adds what the change of one entry makes.
    #[inline]
    fn add(&mut self, change: f64, weight: &Weight<P>) {
        let change = change * weight.scale[0] * weight.scale[1];
        let term = weight.parts.map(|part| part * change);
        if P == 4 {
            self.size += term[0].abs() + term[P - 1].abs();
        }
        self.parts.iter_mut().zip(term).for_each(|(sum, term)| *sum += term);
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
        let [speed_step, step] = newton_step(scaled, kind, speed, s, zeros);
        let relative = speed_step.norm() / speed.to_f64();
        if relative.is_nan() || relative > NEAR {
            return Err(NotDifferentiable::Meeting);
        }
        speed = speed + speed_step.re.into();
        if !is_zero {
            s = s + ComplexDoubleDouble { re: step.re.into(), im: step.im.into() };
        }
        if relative <= SMALL && step.norm() <= SMALL * s.norm() {
            break;
        }
    }
    Ok((at(speed, s)?, speed))
}
