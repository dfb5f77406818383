//! What the formulas of the factors need of a number, in `f64`, in lanes of it, and in twice its precision.

use core::ops::{Add, BitAnd, Div, Mul, Neg, Not, Sub};

use crate::lane::Lane;
use crate::numeric::{DoubleDouble, Real};

/// A real number, or several side by side.
pub(super) trait Field:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// A truth value for each lane.
    type Mask: Copy + BitAnd<Output = Self::Mask> + Not<Output = Self::Mask>;

    fn constant(self, value: f64) -> Self;
    fn magnitude(self) -> Self;
    /// The square root; zero for negative numbers.
    fn root(self) -> Self;
    fn at_most(self, other: Self) -> Self::Mask;
    fn choose(mask: Self::Mask, yes: Self, no: Self) -> Self;
}

impl<T: Lane> Field for T {
    type Mask = T::Mask;

    #[inline(always)]
    fn constant(self, value: f64) -> Self {
        self.like(value)
    }
    #[inline(always)]
    fn magnitude(self) -> Self {
        Lane::abs(self)
    }
    #[inline(always)]
    fn root(self) -> Self {
        let zero = self.like(0.0);
        T::select(zero.less(self), self, zero).sqrt()
    }
    #[inline(always)]
    fn at_most(self, other: Self) -> Self::Mask {
        self.less_or_equal(other)
    }
    #[inline(always)]
    fn choose(mask: Self::Mask, yes: Self, no: Self) -> Self {
        T::select(mask, yes, no)
    }
}

impl Field for DoubleDouble {
    type Mask = bool;

    fn constant(self, value: f64) -> Self {
        value.into()
    }
    fn magnitude(self) -> Self {
        self.abs()
    }
    fn root(self) -> Self {
        self.sqrt()
    }
    fn at_most(self, other: Self) -> bool {
        self <= other
    }
    fn choose(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }
}

/// A number whose lanes have cube roots.
pub(crate) trait CubeRoot: Lane {
    /// `x^(-1/3)` to 4 %, for positive normal numbers.
    ///
    /// The upper half of the representation is, as an integer, about the logarithm: it is divided by three as a number.
    fn inverse_cube_root_estimate(self) -> Self;
}

/// The upper half of the estimate for a number whose upper half would be zero.
pub(crate) const UPPER_HALF: f64 = 0x553e_f0ff as f64;

impl CubeRoot for f64 {
    #[inline(always)]
    fn inverse_cube_root_estimate(self) -> Self {
        let upper = (self.to_bits() >> 32) as f64;
        f64::from_bits(((UPPER_HALF - upper * (1.0 / 3.0)) as u64) << 32)
    }
}
