//! Real numbers in code without branches, in any precision.

use core::ops::{Add, BitAnd, BitOr, BitXor, Div, Mul, Neg, Not, Sub};

/// A real number, or several side by side, of which straight-line code computes both sides and selects.
pub(crate) trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// A truth value for each of the numbers.
    type Mask: Copy
        + BitAnd<Output = Self::Mask>
        + BitOr<Output = Self::Mask>
        + BitXor<Output = Self::Mask>
        + Not<Output = Self::Mask>;

    /// The number nearest to `value`, as many times as there are numbers.
    fn like(self, value: f64) -> Self;
    fn abs(self) -> Self;
    /// The square root of numbers that are not negative.
    fn sqrt(self) -> Self;
    fn less(self, other: Self) -> Self::Mask;
    fn less_or_equal(self, other: Self) -> Self::Mask;
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// Whether a mask is true for all of the numbers.
    fn all(mask: Self::Mask) -> bool;

    /// The square root; zero for negative numbers.
    #[inline(always)]
    fn sqrt_or_zero(self) -> Self {
        let zero = self.like(0.0);
        Self::select(zero.less(self), self, zero).sqrt()
    }
}

macro_rules! real {
    ($t:ident) => {
        impl Real for $t {
            type Mask = bool;

            #[inline(always)]
            fn like(self, value: f64) -> Self {
                value as $t
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $t::abs(self)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                crate::number::Number::sqrt(self)
            }
            #[inline(always)]
            fn less(self, other: Self) -> bool {
                self < other
            }
            #[inline(always)]
            fn less_or_equal(self, other: Self) -> bool {
                self <= other
            }
            #[inline(always)]
            fn select(mask: bool, yes: Self, no: Self) -> Self {
                if mask { yes } else { no }
            }
            #[inline(always)]
            fn all(mask: bool) -> bool {
                mask
            }
        }
    };
}

real!(f32);
real!(f64);
