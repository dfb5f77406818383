//! The number types that models are evaluated in.

use core::fmt::{Debug, Display};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A floating-point number that a model can be evaluated in: `f32` or `f64`.
///
/// Sine, cosine, tangent and square root come from the platform with feature `std`, and from `libm` without it.
pub trait Scalar:
    Copy
    + Debug
    + Display
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + nalgebra::Scalar
    + sealed::Sealed
{
    /// The number nearest to `value`.
    fn from_f64(value: f64) -> Self;
    /// This number, exactly.
    fn to_f64(self) -> f64;
    /// Sine and cosine of an angle in radians.
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

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

macro_rules! scalar {
    ($t:ident, $sin_cos:path, $sin:path, $cos:path, $tan:path, $sqrt:path) => {
        impl Scalar for $t {
            #[inline]
            fn from_f64(value: f64) -> Self {
                value as $t
            }
            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }
            #[inline]
            fn sin(self) -> Self {
                $sin(self)
            }
            #[inline]
            fn cos(self) -> Self {
                $cos(self)
            }
            #[inline]
            fn tan(self) -> Self {
                $tan(self)
            }
            #[inline]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }
        }
    };
}

#[cfg(feature = "std")]
scalar!(f32, f32::sin_cos, f32::sin, f32::cos, f32::tan, f32::sqrt);
#[cfg(feature = "std")]
scalar!(f64, f64::sin_cos, f64::sin, f64::cos, f64::tan, f64::sqrt);
#[cfg(not(feature = "std"))]
scalar!(f32, libm::sincosf, libm::sinf, libm::cosf, libm::tanf, libm::sqrtf);
#[cfg(not(feature = "std"))]
scalar!(f64, libm::sincos, libm::sin, libm::cos, libm::tan, libm::sqrt);
