//! What models are evaluated in: numbers, one at a time or in lanes.

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// What a model can be evaluated in: a floating-point number, or as many of them side by side as a register of the
/// processor holds.
///
/// The arithmetic of every lane is that of the number alone, to the last bit.
pub trait Number:
    Copy
    + Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + sealed::Sealed
{
    /// The number nearest to `value`, in as many lanes as this one has.
    fn like(self, value: f64) -> Self;
    /// Sine and cosine of an angle in radians, each to within one unit in the last place.
    fn sin_cos(self) -> (Self, Self);
    /// Sine of an angle in radians.
    fn sin(self) -> Self;
    /// Cosine of an angle in radians.
    fn cos(self) -> Self;
    /// Tangent of an angle in radians.
    fn tan(self) -> Self;
    /// The non-negative square root.
    fn sqrt(self) -> Self;
}

pub(crate) mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}
