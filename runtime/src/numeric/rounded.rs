//! Polynomials in plain `f64`, with bounds on what rounding may do to them.

use super::taylor::expand_taylor;
use super::tracked::{NOISE, Tracked};

/// A polynomial with coefficients in `f64`, ascending, with a size for each: coefficients err by a rounding of their size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rounded<const N: usize> {
    pub(super) value: [f64; N],
    pub(super) size: [f64; N],
}

/// How much less than its terms a value may be, for its sign to be certain: 2^8 roundings of up to half a unit.
pub(crate) const CERTAIN: f64 = 128.0 * f64::EPSILON;

impl<const N: usize> Rounded<N> {
    #[inline]
    pub(crate) fn new(coefficients: &[Tracked; N]) -> Self {
        let value = coefficients.map(|c| c.value.to_f64());
        // What is left of cancelled terms errs by the rounding of these in double-double.
        let size = coefficients.map(|c| c.value.to_f64().abs() + c.size * (NOISE / f64::EPSILON));
        Self { value, size }
    }

    /// From coefficients with the sizes of which they err by a rounding each.
    #[cfg(feature = "std")]
    pub(crate) fn of_sizes(value: [f64; N], size: [f64; N]) -> Self {
        Self { value, size }
    }

    /// The sign at x >= 0; `None` where it is not certain.
    #[inline]
    pub(crate) fn sign(&self, x: f64) -> Option<i8> {
        let (mut value, mut size) = (0.0, 0.0);
        for i in (0..N).rev() {
            value = value * x + self.value[i];
            size = size * x + self.size[i];
        }
        if value > CERTAIN * size {
            Some(1)
        } else if value < -CERTAIN * size {
            Some(-1)
        } else {
            None
        }
    }

    /// The value at x, the first derivative, and half of the second one.
    #[inline]
    pub(crate) fn taylor(&self, x: f64) -> [f64; 3] {
        expand_taylor(self.value.into_iter(), x)
    }
}
