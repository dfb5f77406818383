//! The derivatives of critical speeds.

use core::fmt;

use nalgebra::Complex;

use super::Sensitivity;
use super::condition::Condition;
use super::scaled::Scaled;
use crate::characteristic::determinant::{ByPower, Rows};
use crate::numeric::{ComplexDoubleDouble, DoubleDouble, ldexp};
use crate::stability::{CriticalKind, CriticalSpeed};
use crate::system::SystemError;

/// How a critical speed changes with each parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum CriticalDerivative {
    /// It has derivatives, by implicit differentiation of its condition.
    Smooth {
        /// The derivatives of the speed with respect to each parameter, in m/s per unit.
        speed: Vec<f64>,
        /// The derivatives of the eigenvalue at the critical speed, which changes along with it, in 1/s per unit: zero for
        /// capsize, i times that of the frequency omega for weave.
        eigenvalue: Vec<Complex<f64>>,
        /// By how much rounding of the terms of the characteristic polynomial moves the speed, both relative: between
        /// `log10(condition)` and twice as many digits of the derivatives depend on digits that rounding of the matrices
        /// to `f64` takes.
        condition: f64,
    },
    /// It has no derivatives.
    None(NotDifferentiable),
}

/// Why a critical speed has no derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NotDifferentiable {
    /// Two critical speeds meet here, as far as digits tell (a condition of 2^24 or more): as a parameter changes they part
    /// like a square root, or vanish. So it is where an eigenvalue touches the imaginary axis without crossing it.
    Meeting,
    /// It takes a coincidence that a changed parameter removes: a conjugate pair of double eigenvalues that no real speed
    /// keeps together, or a critical eigenvalue of zero beside another one that is zero at all speeds, but for this
    /// parameter.
    Coincidence,
}

/// Reads as the end of a sentence: `because …`.
impl fmt::Display for NotDifferentiable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Meeting => "two critical speeds meet here",
            Self::Coincidence => "it takes a coincidence that any change removes",
        })
    }
}

/// From this condition on two critical speeds cannot be told from one.
const MEETING: f64 = (1u64 << 24) as f64;
/// What is smaller than this, relative to the terms that it was computed from, counts as zero.
const NEGLIGIBLE: f64 = 1.0 / (1u64 << 40) as f64;

impl Sensitivity<2> {
    /// The derivatives of a critical speed of the same coefficients at the same gravity, as
    /// [`Stability`](crate::Stability) finds it.
    ///
    /// They are those of the coefficients as given: speed and eigenvalue are first polished in double-double arithmetic.
    ///
    /// # Errors
    /// If a derivative leaves the range of `f64`.
    pub fn critical_speed(&self, critical: &CriticalSpeed) -> Result<CriticalDerivative, SystemError> {
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
        let answers = condition.answers(&scaled, speed);
        let (mut speeds, mut eigenvalues) = (Vec::new(), Vec::new());
        for (parameter, derivative) in self.derivatives.iter().enumerate() {
            let mut direction = *derivative;
            if self.gravity_parameter == Some(parameter) {
                direction.kc += self.coefficients.k0;
            }
            let direction = scaled.units.scale_coefficients(&direction);
            let keeps_zeros = scaled.keeps_zeros(condition.zeros, &direction, speed);
            let direction = scaled.direction(&direction, speed.to_f64());
            let (by_speed, size) = dot(&answers.speed, &direction);
            if !keeps_zeros || by_speed.im.abs() > NEGLIGIBLE * size {
                return Ok(CriticalDerivative::None(NotDifferentiable::Coincidence));
            }
            speeds.push(finite(by_speed.re, scaled.units.speed)?);
            let (eigenvalue, _) = dot(&answers.eigenvalue, &direction);
            let part = |part: f64| finite(part, scaled.units.time);
            eigenvalues.push(Complex::new(part(eigenvalue.re)?, part(eigenvalue.im)?));
        }
        Ok(CriticalDerivative::Smooth { speed: speeds, eigenvalue: eigenvalues, condition: condition.condition() })
    }
}

/// The sum of derivatives times changes, and the size of its terms.
fn dot(derivatives: &ByPower<Rows<Complex<f64>>>, changes: &ByPower<Rows>) -> (Complex<f64>, f64) {
    let pairs = derivatives.as_flattened().as_flattened().iter().zip(changes.as_flattened().as_flattened());
    pairs.fold((Complex::new(0.0, 0.0), 0.0), |(sum, size), (derivative, change)| {
        let term = derivative * *change;
        (sum + term, size + term.l1_norm())
    })
}

/// The condition of a critical speed at the speed itself, which is polished, in the units of the condition.
fn find_condition(scaled: &Scaled, critical: &CriticalSpeed) -> Result<(Condition, DoubleDouble), NotDifferentiable> {
    /// Newton's iteration doubles the digits: it starts with those of `f64`, or half of them where rounding was large.
    const STEPS: usize = 2;
    /// After a step as small as this, relative, all digits of `f64` are right.
    const SMALL: f64 = 1e-12;
    /// What moves farther than this, relative, is not converging.
    const NEAR: f64 = 1e-6;
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
