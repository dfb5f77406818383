//! Numbers side by side, with their bits.

use super::real::Real;

/// A number of the precision of `f64`, or as many of them as a register holds.
pub(crate) trait Lane: Real {
    /// Whether a bit of the representation is set.
    fn bit(self, index: u32) -> Self::Mask;
    /// The magnitude of this number with the sign of another one.
    fn copysign(self, sign: Self) -> Self;
    /// Each number through a function, where none may be computed in another way.
    fn map(self, f: impl Fn(f64) -> f64) -> Self;
    /// `x^(-1/3)` to 4 %, for positive normal numbers.
    ///
    /// The upper half of the representation is, as an integer, about the logarithm: it is divided by three as a number.
    fn estimate_inverse_cube_root(self) -> Self;
}

/// The upper half of the estimate of `x^(-1/3)` for a number whose upper half would be zero.
pub(crate) const UPPER_HALF: f64 = 0x553e_f0ff as f64;

impl Lane for f64 {
    #[inline(always)]
    fn bit(self, index: u32) -> bool {
        self.to_bits() >> index & 1 != 0
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        f64::copysign(self, sign)
    }
    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        f(self)
    }
    #[inline(always)]
    fn estimate_inverse_cube_root(self) -> Self {
        let upper = (self.to_bits() >> 32) as f64;
        f64::from_bits(((UPPER_HALF - upper * (1.0 / 3.0)) as u64) << 32)
    }
}
