//! Roots of polynomials along speed in about twice the precision of `f64`.

use super::conditions::Variable;
use crate::number::Number;
use crate::numeric::fixed::evaluate;
use crate::numeric::isolation::Bracket;
use crate::numeric::rounded::Rounded;
use crate::numeric::{DoubleDouble, Tracked};

/// A root, as the sum of two parts.
#[derive(Clone, Copy, Debug)]
pub(super) struct Root {
    /// Rounded.
    pub(super) x: f64,
    /// What it lacks.
    pub(super) rest: f64,
    /// How far the root may move if the terms of the polynomial are rounded to `f64`.
    pub(super) error: f64,
}

/// The last step of a root in `f64`, relative to it.
const CLOSE: f64 = 1.0 / (1u64 << 14) as f64;

/// The largest step that polishes a root, relative to it.
const STEP: f64 = 1.0 / (1u64 << 32) as f64;

/// What may be lacking of a root, relative to it.
const NEGLIGIBLE: f64 = f64::EPSILON / (1u64 << 16) as f64;

impl Root {
    #[inline]
    pub(super) fn new(x: f64, rest: f64, error: f64) -> Self {
        let (x, rest) = normal(x, rest);
        Self { x, rest, error }
    }

    /// The simple root in an interval: the one in `f64`, and a step of Newton's iteration in double-double.
    #[inline]
    pub(super) fn simple<const N: usize>(
        polynomial: &[Tracked; N],
        rounded: &Rounded<N>,
        bracket: &Bracket,
    ) -> Option<Self> {
        let x = rounded.refine(bracket, CLOSE)?;
        let value = evaluate(polynomial, x);
        let [_, slope, half_curvature] = rounded.taylor(x);
        let rest = -value.value.to_f64() / slope;
        let error = f64::EPSILON * value.size / slope.abs();
        // The next step would be about this.
        let left = (half_curvature / slope).abs() * rest * rest;
        (rest.abs() <= STEP * x && left <= NEGLIGIBLE * x).then(|| Self::new(x, rest, error))
    }

    /// The square root in the same form, without its error.
    #[inline]
    pub(super) fn sqrt(x: f64, rest: f64) -> (f64, f64) {
        let root = Number::sqrt(x);
        let left = DoubleDouble::from(x) - DoubleDouble::product(root, root);
        normal(root, (left.to_f64() + rest) / (2.0 * root))
    }

    /// The speed in m/s, rounded once, and what it lacks.
    #[inline]
    pub(super) fn speed(&self, variable: Variable) -> (f64, f64) {
        match variable {
            Variable::Speed => (self.x, self.rest),
            Variable::Square => Self::sqrt(self.x, self.rest),
        }
    }
}

/// The sum, rounded, and what it lacks.
#[inline]
fn normal(x: f64, rest: f64) -> (f64, f64) {
    let sum = x + rest;
    (sum, rest - (sum - x))
}
