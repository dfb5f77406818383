//! The number types of parameters and results.

use core::fmt::Display;
use core::ops::{AddAssign, DivAssign, MulAssign, SubAssign};

use super::trigonometry::{double, single};
use super::{Number, sealed};

/// A floating-point number: `f32` or `f64`.
///
/// Sine, cosine and tangent of `f32` are the same to the last bit on every platform, with and without feature `std`. They are
/// computed without an operation in `f64`: to within 0.85 units in the last place, and the tangent to within 1.2, up to
/// 1e5 rad. Beyond, they are those of an angle that differs by less than one unit in its last place; and beyond 2^22 rad, where these units are half a radian and more, those of zero.
///
/// So are sine and cosine of `f64`, to within one unit in the last place, up to 1e5 rad. Beyond, they and the tangent come from
/// the platform with feature `std`, and from `libm` without it. Square roots are rounded correctly everywhere.
///
/// Matrices of them can be added, subtracted and multiplied, which nalgebra does for what has the assigning operators.
pub trait Scalar:
    Number + Display + PartialOrd + AddAssign + SubAssign + MulAssign + DivAssign + nalgebra::Scalar + sealed::Sealed
{
    /// The distance from 1 to the next larger number.
    const EPSILON: Self;
    /// The number nearest to `value`.
    fn from_f64(value: f64) -> Self;
    /// This number, exactly.
    fn to_f64(self) -> f64;
    /// The magnitude.
    fn abs(self) -> Self;
    /// Whether it is neither infinite nor not a number.
    fn is_finite(self) -> bool;
}

/// The nearest `f32` to each of the values. Generated code makes constants by it, where no method of a trait can be called.
#[doc(hidden)]
#[must_use]
pub const fn to_f32<const P: usize>(values: [f64; P]) -> [f32; P] {
    let mut nearest = [0.0; P];
    let mut position = 0;
    while position < P {
        nearest[position] = values[position] as f32;
        position += 1;
    }
    nearest
}

macro_rules! scalar {
    ($t:ident, $sin_cos:path, $tan:path, $sqrt:path) => {
        impl Scalar for $t {
            const EPSILON: Self = $t::EPSILON;

            #[inline]
            fn from_f64(value: f64) -> Self {
                value as $t
            }
            #[inline]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $t::abs(self)
            }
            #[inline(always)]
            fn is_finite(self) -> bool {
                $t::is_finite(self)
            }
        }

        impl Number for $t {
            #[inline(always)]
            fn like(self, value: f64) -> Self {
                value as $t
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                $sin_cos(self)
            }
            #[inline(always)]
            fn sin(self) -> Self {
                $sin_cos(self).0
            }
            #[inline(always)]
            fn cos(self) -> Self {
                $sin_cos(self).1
            }
            #[inline(always)]
            fn tan(self) -> Self {
                $tan(self)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                $sqrt(self)
            }
        }
    };
}

#[cfg(feature = "std")]
scalar!(f32, single::sin_cos, single::tan, f32::sqrt);
#[cfg(feature = "std")]
scalar!(f64, double::sin_cos, f64::tan, f64::sqrt);
#[cfg(not(feature = "std"))]
scalar!(f32, single::sin_cos, single::tan, libm::sqrtf);
#[cfg(not(feature = "std"))]
scalar!(f64, double::sin_cos, libm::tan, libm::sqrt);
