//! As many numbers side by side as a register holds.

use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};

use fearless_simd::SimdFloatElement;
use fearless_simd::prelude::*;

use super::transpose;
use crate::number::lane::{Lane, UPPER_HALF};
use crate::number::real::Real;
use crate::number::trigonometry::{double, single};
use crate::number::{Number, Scalar};
use crate::numeric::Part;

/// `f32` or `f64`: numbers of which a register holds several.
pub trait InLanes: Scalar + SimdFloatElement + Send + Sync {
    /// A register of them at the level `S` of the processor's instructions.
    #[doc(hidden)]
    type Register<S: Simd>: SimdFloat<S, Element = Self>;

    /// Sine and cosine, in each lane those of the number alone.
    #[doc(hidden)]
    fn sin_cos_of_lanes<S: Simd>(angle: Lanes<S, Self>) -> (Lanes<S, Self>, Lanes<S, Self>);

    /// The first to the eighth of eight numbers of designs, each of as many designs as there are lanes.
    #[doc(hidden)]
    fn side_by_side<S: Simd>(simd: S, four: impl Fn(usize, usize) -> [Self; 4] + Copy) -> [Lanes<S, Self>; 8];

    /// Rows to columns, within each four lanes of four registers.
    #[doc(hidden)]
    fn transpose_fours<S: Simd>(registers: [Lanes<S, Self>; 4]) -> [Lanes<S, Self>; 4];
}

impl InLanes for f64 {
    type Register<S: Simd> = S::f64s;

    #[inline(always)]
    fn sin_cos_of_lanes<S: Simd>(angle: Lanes<S>) -> (Lanes<S>, Lanes<S>) {
        double::sin_cos_of_lanes(angle)
    }

    #[inline(always)]
    fn side_by_side<S: Simd>(simd: S, four: impl Fn(usize, usize) -> [f64; 4] + Copy) -> [Lanes<S>; 8] {
        transpose::side_by_side_f64(simd, four)
    }

    #[inline(always)]
    fn transpose_fours<S: Simd>(registers: [Lanes<S>; 4]) -> [Lanes<S>; 4] {
        transpose::transpose_f64(registers)
    }
}

impl InLanes for f32 {
    type Register<S: Simd> = S::f32s;

    #[inline(always)]
    fn sin_cos_of_lanes<S: Simd>(angle: Lanes<S, f32>) -> (Lanes<S, f32>, Lanes<S, f32>) {
        single::sin_cos_of_lanes(angle)
    }

    #[inline(always)]
    fn side_by_side<S: Simd>(simd: S, four: impl Fn(usize, usize) -> [f32; 4] + Copy) -> [Lanes<S, f32>; 8] {
        transpose::side_by_side_f32(simd, four)
    }

    #[inline(always)]
    fn transpose_fours<S: Simd>(registers: [Lanes<S, f32>; 4]) -> [Lanes<S, f32>; 4] {
        transpose::transpose_f32(registers)
    }
}

/// A register of `f64` or `f32` at the level `S` of the processor's instructions.
#[derive(Clone, Copy)]
pub struct Lanes<S: Simd, T: InLanes = f64>(pub(crate) T::Register<S>);

impl<S: Simd, T: InLanes> Lanes<S, T> {
    /// How many numbers there are side by side.
    pub(crate) const COUNT: usize = T::Register::<S>::LEN;

    /// A number for each lane.
    #[inline(always)]
    pub(crate) fn from_fn(simd: S, number: impl FnMut(usize) -> T) -> Self {
        Self(T::Register::<S>::from_fn(simd, number))
    }

    /// The same number in all lanes.
    #[inline(always)]
    pub(crate) fn splat(simd: S, number: T) -> Self {
        Self(T::Register::<S>::splat(simd, number))
    }

    /// As many numbers as there are lanes.
    #[inline(always)]
    pub(crate) fn load(simd: S, numbers: &[T]) -> Self {
        Self(T::Register::<S>::from_slice(simd, numbers))
    }

    /// Into as many numbers as there are lanes.
    #[inline(always)]
    pub(crate) fn store(self, numbers: &mut [T]) {
        self.0.store_slice(numbers);
    }

    /// The numbers side by side.
    #[inline(always)]
    pub(crate) fn numbers(&self) -> &[T] {
        self.0.as_slice()
    }

    /// Replaces the number in a lane.
    #[cfg(feature = "std")]
    #[inline(always)]
    pub(crate) fn set_lane(&mut self, index: usize, number: T) {
        self.0.as_mut_slice()[index] = number;
    }

    /// The number in a lane.
    #[inline(always)]
    pub(crate) fn lane(&self, index: usize) -> T {
        self.0.as_slice()[index]
    }
}

impl<S: Simd, T: InLanes> fmt::Debug for Lanes<S, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.as_slice().fmt(f)
    }
}

macro_rules! operator {
    ($($operator:ident $method:ident $sign:tt)*) => {
        $(impl<S: Simd, T: InLanes> $operator for Lanes<S, T> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0 $sign other.0)
            }
        })*
    };
}

operator!(Add add + Sub sub - Mul mul * Div div /);

impl<S: Simd, T: InLanes> Neg for Lanes<S, T> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<S: Simd, T: InLanes> Number for Lanes<S, T> {
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        Self::splat(self.0.token(), T::from_f64(value))
    }
    #[inline(always)]
    fn sin_cos(self) -> (Self, Self) {
        T::sin_cos_of_lanes(self)
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
        Self::from_fn(self.0.token(), |lane| self.lane(lane).tan())
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
}

impl<S: Simd, T: InLanes> Real for Lanes<S, T> {
    type Mask = <T::Register<S> as SimdBase<S>>::Mask;

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

impl<S: Simd> Part for Lanes<S> {
    const SPLITTER: f64 = <f64 as Part>::SPLITTER;
}

impl<S: Simd> Lane for Lanes<S> {
    const EPSILON: f64 = <f64 as Lane>::EPSILON;
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
    #[inline(always)]
    fn power_of_two(self) -> Self {
        let bits: S::u64s = self.0.bitcast();
        Self(((bits >> 52) << 52).bitcast())
    }
}

impl<S: Simd> Lane for Lanes<S, f32> {
    const EPSILON: f64 = <f32 as Lane>::EPSILON;
    const ENTRIES: [f64; 2] = f32::ENTRIES;
    const COEFFICIENTS: [f64; 2] = f32::COEFFICIENTS;

    #[inline(always)]
    fn bit(self, index: u32) -> Self::Mask {
        let bits: S::u32s = self.0.bitcast();
        let sign: S::i32s = (bits << (31 - index)).bitcast();
        sign.simd_lt(0)
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        Self(self.0.copysign(sign.0))
    }
    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        Self::from_fn(self.0.token(), |lane| f(self.lane(lane).into()) as f32)
    }
    #[inline(always)]
    fn estimate_inverse_cube_root(self) -> Self {
        // A whole number of 32 bits is not divided in lanes.
        Self::from_fn(self.0.token(), |lane| self.lane(lane).estimate_inverse_cube_root())
    }
    #[inline(always)]
    fn power_of_two(self) -> Self {
        let bits: S::u32s = self.0.bitcast();
        Self(((bits >> 23) << 23).bitcast())
    }
}
