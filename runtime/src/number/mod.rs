//! What is computed with: numbers, one at a time or in the lanes of a register.
//!
//! Four traits, each for what the one before cannot say:
//!
//! - [`Number`], public: what a model is evaluated in. `f32`, `f64`, lanes of `f64`, and what others implement it for; its
//!   functions are those of formulas. Generated code is written over it, so nothing but what formulas need belongs here.
//! - [`Scalar`], public: one number, `f32` or `f64`, with conversions to and from `f64`. The fields of a model have it.
//! - [`Real`](real::Real): what straight-line code needs that decides: constants, comparisons and selection. It is no
//!   `Number`, since twice the precision of `f64` has no sine; `f64`, lanes and double-double have it.
//! - [`Lane`](lane::Lane): a `Real` whose bits can be had, one number or several: `f64` and lanes.
//!
//! Words are the same in all of them: `like` makes a constant, `less` and `less_or_equal` compare, `select` chooses.

// Without batches only part of it has a use.
#[cfg_attr(not(feature = "batch"), allow(dead_code))]
pub(crate) mod lane;
pub(crate) mod real;
mod scalar;
pub(crate) mod trigonometry;

use core::fmt::Debug;
use core::ops::{Add, Div, Mul, Neg, Sub};

pub use scalar::{Scalar, to_f32};

/// What a model can be evaluated in: a floating-point number, as many of them side by side as a register of the processor
/// holds, or a number of your own.
///
/// The arithmetic of every lane is that of the number alone, to the last bit. Numbers of your own may carry an interval, a
/// derivative or more digits; those of the crate `carvallo-compare` count operations, and have hundreds of bits.
///
/// ```
/// use carvallo::Number;
///
/// /// What you have by hand counts as well as what is generated if it takes any number.
/// fn mass<T: Number>(m: T, l: T) -> T {
///     m.like(0.5) * m * l * l
/// }
/// assert_eq!(mass(3.0, 2.0), 6.0);
/// ```
pub trait Number:
    Copy + Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
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

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}
