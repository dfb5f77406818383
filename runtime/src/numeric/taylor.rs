//! A polynomial and its derivatives at a point.

use core::ops::{Add, Mul};

/// The value at x, the first derivative, and half of the second one, of a polynomial given by its ascending coefficients:
/// Horner's rule three times over.
#[inline]
pub(crate) fn expand_taylor<T>(coefficients: impl DoubleEndedIterator<Item = T>, x: T) -> [T; 3]
where
    T: Copy + From<f64> + Add<Output = T> + Mul<Output = T>,
{
    let [mut value, mut slope, mut half_curvature] = [T::from(0.0); 3];
    for coefficient in coefficients.rev() {
        half_curvature = half_curvature * x + slope;
        slope = slope * x + value;
        value = value * x + coefficient;
    }
    [value, slope, half_curvature]
}
