//! What straight-line code needs to decide lane by lane: it computes both sides and selects.

use core::ops::{BitAnd, BitOr, BitXor, Not};

use crate::Number;

/// A number whose lanes, of which `f64` has one, are compared and selected one by one.
pub(crate) trait Lane: Number {
    /// A truth value for each lane.
    type Mask: Copy
        + BitAnd<Output = Self::Mask>
        + BitOr<Output = Self::Mask>
        + BitXor<Output = Self::Mask>
        + Not<Output = Self::Mask>;

    fn less(self, other: Self) -> Self::Mask;
    fn less_or_equal(self, other: Self) -> Self::Mask;
    /// Whether a bit of the representation is set.
    fn bit(self, index: u32) -> Self::Mask;
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    fn all(mask: Self::Mask) -> bool;
    fn abs(self) -> Self;
    /// The magnitude of this number with the sign of another one.
    fn copysign(self, sign: Self) -> Self;
    /// Each lane through a function of one number, where no lane may be computed in another way.
    fn map(self, f: impl Fn(f64) -> f64) -> Self;
}

impl Lane for f64 {
    type Mask = bool;

    #[inline(always)]
    fn less(self, other: Self) -> bool {
        self < other
    }
    #[inline(always)]
    fn less_or_equal(self, other: Self) -> bool {
        self <= other
    }
    #[inline(always)]
    fn bit(self, index: u32) -> bool {
        self.to_bits() >> index & 1 != 0
    }
    #[inline(always)]
    fn select(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
    #[inline(always)]
    fn all(mask: bool) -> bool {
        mask
    }
    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        f64::copysign(self, sign)
    }
    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        f(self)
    }
}
