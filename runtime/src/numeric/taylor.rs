//! A polynomial and its derivatives at a point.

use core::ops::{Add, Mul};

/// The value at x, the first derivative, and half of the second one, of a polynomial given by its ascending coefficients:
/// Horner's rule three times over.
#[inline]
pub(crate) fn expand_taylor<T>(coefficients: impl DoubleEndedIterator<Item = T>, x: T) -> [T; 3]
where
    T: Copy + From<f64> + Add<Output = T> + Mul<Output = T>,
{
    let mut descending = coefficients.rev();
    // No product with zero: the others would wait for it.
    let [mut value, mut slope, mut half_curvature] = [T::from(0.0); 3];
    if let Some(coefficient) = descending.next() {
        value = coefficient;
    }
    if let Some(coefficient) = descending.next() {
        slope = value;
        value = value * x + coefficient;
    }
    if let Some(coefficient) = descending.next() {
        half_curvature = slope;
        slope = slope * x + value;
        value = value * x + coefficient;
    }
    for coefficient in descending {
        half_curvature = half_curvature * x + slope;
        slope = slope * x + value;
        value = value * x + coefficient;
    }
    [value, slope, half_curvature]
}

#[cfg(test)]
mod tests {
    use super::expand_taylor;

    /// 5 + 3 x + 7 x^2 + 2 x^3, and what is left of it without the highest powers, at 2.
    #[test]
    fn derivatives_are_those_of_the_polynomial() {
        let up_to = |count: usize| expand_taylor([5.0, 3.0, 7.0, 2.0].into_iter().take(count), 2.0);
        assert_eq!(up_to(4), [5.0 + 6.0 + 28.0 + 16.0, 3.0 + 28.0 + 24.0, 7.0 + 12.0]);
        assert_eq!(up_to(3), [5.0 + 6.0 + 28.0, 3.0 + 28.0, 7.0]);
        assert_eq!(up_to(2), [5.0 + 6.0, 3.0, 0.0]);
        assert_eq!(up_to(1), [5.0, 0.0, 0.0]);
        assert_eq!(up_to(0), [0.0; 3]);
    }
}
