//! What formulas need of a number when they are evaluated in more than one precision.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::DoubleDouble;
use crate::Number;

/// A real number: `f64` or [`DoubleDouble`].
pub(crate) trait Real:
    Copy
    + PartialOrd
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    fn abs(self) -> Self;
    /// The square root; zero for negative numbers.
    fn sqrt(self) -> Self;
}

impl Real for f64 {
    #[inline]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline]
    fn sqrt(self) -> Self {
        Number::sqrt(self.max(0.0))
    }
}

impl Real for DoubleDouble {
    fn abs(self) -> Self {
        if self < Self::ZERO { -self } else { self }
    }

    fn sqrt(self) -> Self {
        let root = Number::sqrt(self.to_f64().max(0.0));
        if root == 0.0 {
            return Self::ZERO;
        }
        // One step of Newton's iteration doubles the digits (Karp & Markstein 1997).
        let rest = self - Self::product(root, root);
        Self::from(root) + (rest.to_f64() / (2.0 * root)).into()
    }
}
