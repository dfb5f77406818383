//! Numbers side by side, with their bits and their limits.

use super::real::Real;

/// A number, or as many of one precision as a register holds.
pub(crate) trait Lane: Real {
    /// The distance from 1 to the next larger number.
    const EPSILON: f64;
    /// The least and the largest magnitude of entries of matrices for which products and quotients of them, as they occur in
    /// eigenvalues, stay in the range of numbers.
    const ENTRIES: [f64; 2];
    /// The same of the largest coefficient of a quartic.
    const COEFFICIENTS: [f64; 2];

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
    /// The largest power of two that is not larger than a positive normal number.
    fn power_of_two(self) -> Self;
}

/// The upper half of the estimate of `x^(-1/3)` for a number whose upper half would be zero.
pub(crate) const UPPER_HALF: f64 = 0x553e_f0ff as f64;

impl Lane for f64 {
    const EPSILON: f64 = f64::EPSILON;
    const ENTRIES: [f64; 2] = [1e-30, 1e30];
    const COEFFICIENTS: [f64; 2] = [1e-12, 1e12];

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
    #[inline(always)]
    fn power_of_two(self) -> Self {
        f64::from_bits(self.to_bits() >> 52 << 52)
    }
}

impl Lane for f32 {
    const EPSILON: f64 = f32::EPSILON as f64;
    const ENTRIES: [f64; 2] = [1e-8, 1e8];
    const COEFFICIENTS: [f64; 2] = [1e-6, 1e6];

    #[inline(always)]
    fn bit(self, index: u32) -> bool {
        self.to_bits() >> index & 1 != 0
    }
    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        f32::copysign(self, sign)
    }
    #[inline(always)]
    fn map(self, f: impl Fn(f64) -> f64) -> Self {
        f(self.into()) as f32
    }
    #[inline(always)]
    fn estimate_inverse_cube_root(self) -> Self {
        // The same, of all of the bits.
        f32::from_bits(0x54a2_1d2a - self.to_bits() / 3)
    }
    #[inline(always)]
    fn power_of_two(self) -> Self {
        f32::from_bits(self.to_bits() >> 23 << 23)
    }
}
