//! The derivatives of critical speeds of two coordinates, by the coefficients of their quartic.

use nalgebra::Complex;

use super::Sensitivity;
use super::condition::Condition;
use super::critical::{CriticalDerivative, MEETING, NEAR, NEGLIGIBLE, NotDifferentiable, SMALL, STEPS};
use super::scaled::Scaled;
use crate::characteristic::determinant::{ByPower, Rows};
use crate::numeric::{ComplexDoubleDouble, DoubleDouble, ldexp};
use crate::stability::{CriticalKind, CriticalSpeed};
use crate::system::SystemError;

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
