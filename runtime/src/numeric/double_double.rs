//! Numbers with twice the precision of `f64`, or of `f32`.
//!
//! Where there are batches, all of it is inlined always, and what is made of it for lanes: a function that is called knows nothing of the
//! instructions of the processor that its caller was compiled for, and would call another one for every addition. In debug builds
//! that would take more stack than a thread has.

use core::ops::{Add, Div, Mul, Neg, Sub};

#[cfg(feature = "std")]
use super::scale::ldexp;
use crate::number::Scalar;
use crate::number::real::Real;

/// The unevaluated sum of two `f64` that do not overlap: about 32 digits in the range of `f64`.
///
/// Operations err by a few units of 2^-104 relative to their result (Dekker 1971; Hida, Li & Bailey 2001). Products are
/// split by Veltkamp's method: a fused multiply-add is a slow library call on targets without the instruction.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub(crate) struct DoubleDouble<T = f64> {
    hi: T,
    lo: T,
}

/// What pairs are made of: `f64`, as many of them as a register holds, or `f32` where there is no `f64`.
pub(crate) trait Part: Real {
    /// Times this and less what was added, a number is rounded to the first half of its bits.
    const SPLITTER: f64;
}

impl Part for f64 {
    const SPLITTER: f64 = 134_217_729.0;
}

impl Part for f32 {
    const SPLITTER: f64 = 4097.0;
}

impl<T: Part> DoubleDouble<T> {
    /// `a b`, exactly.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn product(a: T, b: T) -> Self {
        let hi = a * b;
        let (a_hi, a_lo) = split(a);
        let (b_hi, b_lo) = split(b);
        Self { hi, lo: ((a_hi * b_hi - hi) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo }
    }

    /// Rounded.
    pub(crate) fn high(self) -> T {
        self.hi
    }
}

impl DoubleDouble {
    pub(crate) const ZERO: Self = Self { hi: 0.0, lo: 0.0 };

    pub(crate) fn to_f64(self) -> f64 {
        self.hi
    }

    /// Times a power of two, exactly.
    #[cfg(feature = "std")]
    pub(crate) fn ldexp(self, e: i32) -> Self {
        Self { hi: ldexp(self.hi, e), lo: ldexp(self.lo, e) }
    }
}

/// Operations of polynomials.
impl<T: Part> DoubleDouble<T> {
    /// The product with one number of half the precision.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn times(self, factor: T) -> Self {
        let product = Self::product(self.hi, factor);
        quick_sum(product.hi, product.lo + self.lo * factor)
    }

    /// Twice the number, exactly.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn doubled(self) -> Self {
        Self { hi: self.hi + self.hi, lo: self.lo + self.lo }
    }

    /// Each part of one of two numbers.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn choose(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self { hi: T::select(mask, yes.hi, no.hi), lo: T::select(mask, yes.lo, no.lo) }
    }

    /// The numbers that each part has in a lane.
    #[cfg(feature = "batch")]
    pub(crate) fn map<U>(self, part: impl Fn(T) -> U) -> DoubleDouble<U> {
        DoubleDouble { hi: part(self.hi), lo: part(self.lo) }
    }

    /// The sum, to within 2^-104 of the magnitudes of both: not of the sum itself, and so with less work.
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    pub(crate) fn add_roughly(self, other: Self) -> Self {
        let hi = sum(self.hi, other.hi);
        quick_sum(hi.hi, hi.lo + (self.lo + other.lo))
    }
}

impl<T: Part> From<T> for DoubleDouble<T> {
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    fn from(value: T) -> Self {
        Self { hi: value, lo: value.like(0.0) }
    }
}

impl<T: Part> Neg for DoubleDouble<T> {
    type Output = Self;
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn neg(self) -> Self {
        Self { hi: -self.hi, lo: -self.lo }
    }
}

impl<T: Part> Add for DoubleDouble<T> {
    type Output = Self;
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn add(self, other: Self) -> Self {
        let hi = sum(self.hi, other.hi);
        let lo = sum(self.lo, other.lo);
        let partial = quick_sum(hi.hi, hi.lo + lo.hi);
        quick_sum(partial.hi, partial.lo + lo.lo)
    }
}

impl<T: Part> Sub for DoubleDouble<T> {
    type Output = Self;
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl<T: Part> Mul for DoubleDouble<T> {
    type Output = Self;
    #[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
    #[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.hi, other.hi);
        quick_sum(product.hi, product.lo + (self.hi * other.lo + self.lo * other.hi))
    }
}

impl<T: Part> Div for DoubleDouble<T> {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let first = self.hi / other.hi;
        let rest = self - other * first.into();
        let second = rest.hi / other.hi;
        let rest = rest - other * second.into();
        quick_sum(first, second) + (rest.hi / other.hi).into()
    }
}

impl<T: Part + Scalar> Real for DoubleDouble<T> {
    type Mask = bool;

    fn like(self, value: f64) -> Self {
        T::from_f64(value).into()
    }
    fn abs(self) -> Self {
        if self < Real::like(self, 0.0) { -self } else { self }
    }
    fn sqrt(self) -> Self {
        let root = Real::sqrt(self.hi);
        if root == T::from_f64(0.0) {
            return root.into();
        }
        // One step of Newton's iteration doubles the digits (Karp & Markstein 1997).
        let rest = self - Self::product(root, root);
        Self::from(root) + (rest.hi / (root + root)).into()
    }
    fn less(self, other: Self) -> bool {
        self < other
    }
    fn less_or_equal(self, other: Self) -> bool {
        self <= other
    }
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    fn all(mask: bool) -> bool {
        mask
    }
}

/// `a + b`, exactly.
#[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
#[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
fn sum<T: Part>(a: T, b: T) -> DoubleDouble<T> {
    let hi = a + b;
    let b_part = hi - a;
    DoubleDouble { hi, lo: (a - (hi - b_part)) + (b - b_part) }
}

/// `a + b`, exactly, where |a| >= |b|.
#[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
#[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
fn quick_sum<T: Part>(a: T, b: T) -> DoubleDouble<T> {
    let hi = a + b;
    DoubleDouble { hi, lo: b - (hi - a) }
}

/// Two parts of half of the bits each that sum to `a`.
#[cfg_attr(all(feature = "batch", not(any(debug_assertions, target_family = "wasm"))), inline(always))]
#[cfg_attr(not(all(feature = "batch", not(any(debug_assertions, target_family = "wasm")))), inline)]
fn split<T: Part>(a: T) -> (T, T) {
    let t = a.like(T::SPLITTER) * a;
    let hi = t - (t - a);
    (hi, a - hi)
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::DoubleDouble;
    use crate::number::real::Real;

    /// One third of 2^-53 is far below `f64` at 1; Dekker's pair must keep it.
    #[test]
    fn keeps_what_f64_rounds_away() {
        let small = DoubleDouble::from(2f64.powi(-53)) / 3.0.into();
        let one = DoubleDouble::from(1.0);
        let sum = one + small;
        assert_eq!(sum.to_f64(), 1.0);
        assert!(((sum - one) - small).abs().to_f64() < 2f64.powi(-105));
    }

    #[test]
    fn inverts_its_own_operations() {
        let two = DoubleDouble::from(2.0);
        let error = two.sqrt() * two.sqrt() - two;
        assert!(error.abs().to_f64() < 2f64.powi(-102));
        let third = DoubleDouble::from(1.0) / 3.0.into();
        assert!((third * 3.0.into() - 1.0.into()).abs().to_f64() < 2f64.powi(-104));
    }
}
