//! The derivatives of critical speeds.

use core::any::Any;
use core::fmt;

use nalgebra::Complex;

use super::{Sensitivity, implicit};
use crate::pencil::Equations;
use crate::stability::CriticalSpeed;
use crate::system::{Coefficients, States, SystemError};

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
        /// By how much rounding of the terms that the condition is summed from moves the speed, both relative: between
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
pub(super) const MEETING: f64 = (1u64 << 24) as f64;
/// What is smaller than this, relative to the terms that it was computed from, counts as zero.
pub(super) const NEGLIGIBLE: f64 = 1.0 / (1u64 << 40) as f64;

/// Newton's iteration doubles the digits of a critical speed: it starts with those of `f64`, or half of them where rounding
/// was large.
pub(super) const STEPS: usize = 2;
/// After a step as small as this, relative, all digits of `f64` are right.
pub(super) const SMALL: f64 = 1e-12;
/// What moves farther than this, relative, is not converging.
pub(super) const NEAR: f64 = 1e-6;

impl<const N: usize> Sensitivity<N> {
    /// The derivatives of a critical speed of the same coefficients at the same gravity, as
    /// [`Stability`](crate::Stability) finds it.
    ///
    /// They are those of the coefficients as given: speed and eigenvalue are first polished in double-double arithmetic. Of
    /// two coordinates with the quartic they follow from its coefficients, of all others from the left and right null vectors
    /// of Q(s) at the critical eigenvalue.
    ///
    /// # Errors
    /// If a derivative leaves the range of `f64`.
    pub fn critical_speed(&self, critical: &CriticalSpeed) -> Result<CriticalDerivative, SystemError> {
        let Coefficients { kc, k0, k2, states, .. } = &self.coefficients;
        // Without the position of a coordinate, one of the four eigenvalues is zero, and nothing else is different.
        let is_there = |column: usize| match states[column] {
            States::Both => true,
            States::Rate => [kc, k0, k2].iter().all(|stiffness| stiffness.column(column).iter().all(|&k| k == 0.0)),
            States::Position => false,
        };
        let has_quartic = !self.coefficients.has_odd_powers() && (0..N).all(is_there);
        match (self as &dyn Any).downcast_ref::<Sensitivity<2>>() {
            Some(two) if has_quartic => two.of_quartic(critical),
            _ => self.implicit(critical),
        }
    }

    /// What [`critical_speed`](Self::critical_speed) gives for other than two coordinates.
    #[doc(hidden)]
    pub fn implicit(&self, critical: &CriticalSpeed) -> Result<CriticalDerivative, SystemError> {
        let equations = Equations::new(&self.coefficients, self.gravity);
        let direction = |parameter: usize| {
            let mut direction = self.derivatives[parameter];
            if self.gravity_parameter == Some(parameter) {
                direction.kc += self.coefficients.k0;
            }
            Equations::new(&direction, self.gravity)
        };
        implicit::differentiate(&equations, critical, self.derivatives.len(), &direction)
    }
}
