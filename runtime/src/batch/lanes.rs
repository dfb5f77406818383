//! As many numbers side by side as a register holds.

use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};

use fearless_simd::prelude::*;

use crate::number::Number;
use crate::number::lane::{Lane, UPPER_HALF};
use crate::number::real::Real;
use crate::number::trigonometry::double::sin_cos_of_lanes;

/// A register of `f64` at the level `S` of the processor's instructions.
#[derive(Clone, Copy)]
pub struct Lanes<S: Simd>(pub(crate) S::f64s);

impl<S: Simd> Lanes<S> {
    /// How many numbers there are side by side.
    pub(crate) const COUNT: usize = S::f64s::LEN;

    /// A number for each lane.
    #[inline(always)]
    pub(crate) fn from_fn(simd: S, number: impl FnMut(usize) -> f64) -> Self {
        Self(S::f64s::from_fn(simd, number))
    }

    /// As many numbers as there are lanes.
    #[inline(always)]
    pub(crate) fn load(simd: S, numbers: &[f64]) -> Self {
        Self(S::f64s::from_slice(simd, numbers))
    }

    /// Into as many numbers as there are lanes.
    #[inline(always)]
    pub(crate) fn store(self, numbers: &mut [f64]) {
        self.0.store_slice(numbers);
    }

    /// The number in a lane.
    #[inline(always)]
    pub(crate) fn lane(&self, index: usize) -> f64 {
        self.0.as_slice()[index]
    }
}

impl<S: Simd> fmt::Debug for Lanes<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.as_slice().fmt(f)
    }
}

macro_rules! operator {
    ($($operator:ident $method:ident $sign:tt)*) => {
        $(impl<S: Simd> $operator for Lanes<S> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0 $sign other.0)
            }
        })*
    };
}

operator!(Add add + Sub sub - Mul mul * Div div /);

impl<S: Simd> Neg for Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<S: Simd> Number for Lanes<S> {
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        Self(S::f64s::simd_from(self.0.token(), value))
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        sin_cos_of_lanes(self)
    }
    #[inline(always)]
    fn sin(self) -> Self {
        self.sin_cos().0
    }
    #[inline(always)]
    fn cos(self) -> Self {
        self.sin_cos().1
    }
    #[inline(always)]
    fn tan(self) -> Self {
        self.map(Number::tan)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
}

impl<S: Simd> Real for Lanes<S> {
    type Mask = S::mask64s;

    #[inline(always)]
    fn like(self, value: f64) -> Self {
        Number::like(self, value)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Number::sqrt(self)
    }
    #[inline(always)]
    fn less(self, other: Self) -> Self::Mask {
        self.0.simd_lt(other.0)
    }
    #[inline(always)]
    fn less_or_equal(self, other: Self) -> Self::Mask {
        self.0.simd_le(other.0)
    }
    #[inline(always)]
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self {
        Self(mask.select(yes.0, no.0))
    }
    #[inline(always)]
    fn all(mask: Self::Mask) -> bool {
        mask.all_true()
    }
}

impl<S: Simd> Lane for Lanes<S> {
    const EPSILON: f64 = f64::EPSILON;
    const ENTRIES: [f64; 2] = f64::ENTRIES;
    const COEFFICIENTS: [f64; 2] = f64::COEFFICIENTS;

    #[inline(always)]
    fn bit(self, index: u32) -> Self::Mask {
        // The bit becomes the sign, which decides.
        let bits: S::u64s = self.0.bitcast();
        let sign: S::i64s = (bits << (63 - index)).bitcast();
        sign.simd_lt(0)
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        Self(self.0.copysign(sign.0))
    }
    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self::from_fn(self.0.token(), |lane| f(self.lane(lane)))
    }
    #[inline(always)]
    fn estimate_inverse_cube_root(self) -> Self {
        // An integer below 2^52 is the mantissa of itself added to 2^52.
        let integers: S::f64s = S::f64s::simd_from(self.0.token(), 4_503_599_627_370_496.0);
        let offset: S::u64s = integers.bitcast();
        let bits: S::u64s = self.0.bitcast();
        let upper: S::f64s = ((bits >> 32) | offset).bitcast();
        let third = (upper - integers) * (1.0 / 3.0);
        // The sum would round to the nearest integer; the scalar function leaves the fraction out.
        let estimate: S::u64s = ((S::f64s::simd_from(self.0.token(), UPPER_HALF) - third).floor() + integers).bitcast();
        let estimate: S::f64s = (estimate << 32).bitcast();
        Self(estimate)
    }
}
