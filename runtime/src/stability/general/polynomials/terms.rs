//! Polynomials with bounds on what rounding did to their coefficients.

use crate::numeric::rounded::{CERTAIN, Rounded};

/// `sum value_i x^(from + i)` with room for R coefficients, each with what it errs by at most.
#[derive(Clone, Copy)]
pub(super) struct Terms<const R: usize> {
    from: usize,
    count: usize,
    value: [f64; R],
    error: [f64; R],
}

/// A product, or its opposite, that is added to others.
pub(super) type Product<'a, const A: usize, const B: usize> = (f64, &'a Terms<A>, &'a Terms<B>);

impl<const R: usize> Terms<R> {
    pub(super) const ZERO: Self = Self { from: 0, count: 0, value: [0.0; R], error: [0.0; R] };

    /// From coefficients and their errors.
    pub(super) fn new(coefficients: &[(f64, f64)]) -> Self {
        let mut new = Self { count: coefficients.len(), ..Self::ZERO };
        for (i, coefficient) in coefficients.iter().enumerate() {
            (new.value[i], new.error[i]) = *coefficient;
        }
        new.forget_zeros();
        new
    }

    /// A sum of products; `None` if there is no room for it.
    pub(super) fn sum<'a, const A: usize, const B: usize>(
        products: impl Iterator<Item = Product<'a, A, B>> + Clone,
    ) -> Option<Self> {
        let mut sum = Self::ZERO;
        let (mut from, mut to, mut most) = (usize::MAX, 0, 0);
        for (_, a, b) in products.clone().filter(|(_, a, b)| a.count > 0 && b.count > 0) {
            from = from.min(a.from + b.from);
            to = to.max(a.from + b.from + a.count + b.count - 1);
            most += a.count.min(b.count);
        }
        if to == 0 {
            return Some(sum);
        }
        (sum.from, sum.count) = (from, to - from);
        if sum.count > R {
            return None;
        }
        for (sign, a, b) in products.filter(|(_, a, b)| a.count > 0 && b.count > 0) {
            let (values, errors) = (&b.value[..b.count], &b.error[..b.count]);
            for i in 0..a.count {
                let (factor, place) = (sign * a.value[i], a.from + b.from - from + i);
                // Half a unit for each of so many terms that are added, and one for the product.
                let of_value = a.error[i] + 0.5 * f64::EPSILON * (most + 1) as f64 * factor.abs();
                let of_error = factor.abs() + of_value;
                let sums = sum.value[place..].iter_mut().zip(&mut sum.error[place..]);
                for ((sum, error), (value, own)) in sums.zip(values.iter().zip(errors)) {
                    *sum += factor * value;
                    *error += of_value * value.abs() + of_error * own;
                }
            }
        }
        sum.forget_zeros();
        Some(sum)
    }

    /// What is zero after all is taken for that: so terms cancel that the symmetry of the matrices makes equal.
    fn forget_zeros(&mut self) {
        for (value, error) in self.value.iter().zip(&mut self.error) {
            if *value == 0.0 {
                *error = 0.0;
            }
        }
        let is_zero = |value: &&f64| **value == 0.0;
        let first = self.value[..self.count].iter().take_while(is_zero).count();
        let last = self.value[first..self.count].iter().rev().take_while(is_zero).count();
        if first > 0 {
            self.value.copy_within(first..self.count, 0);
            self.error.copy_within(first..self.count, 0);
        }
        (self.from, self.count) = (self.from + first, self.count - first - last);
    }

    /// The same in the square of x, of a polynomial that is even, but for rounding.
    pub(super) fn in_square(&self) -> Self {
        let mut even = Self::ZERO;
        let odd = self.from % 2;
        (even.from, even.count) = (self.from.div_ceil(2), self.count.saturating_sub(odd).div_ceil(2));
        for i in 0..even.count {
            (even.value[i], even.error[i]) = (self.value[2 * i + odd], self.error[2 * i + odd]);
        }
        even.forget_zeros();
        even
    }

    /// How many coefficients there are.
    pub(super) fn count(&self) -> usize {
        self.count
    }

    pub(super) fn times(mut self, factor: f64) -> Self {
        self.value.iter_mut().for_each(|value| *value *= factor);
        self.error.iter_mut().for_each(|error| *error *= factor.abs());
        self
    }

    /// The value at a positive x.
    pub(super) fn at(&self, x: f64) -> f64 {
        let power = x.powi(i32::try_from(self.from).unwrap_or(i32::MAX));
        power * self.value[..self.count].iter().rev().fold(0.0, |value, coefficient| value * x + coefficient)
    }

    /// Without the power of x that all terms have, and with as many coefficients as are asked for; `None` if it is zero, or
    /// has more. Missing ones come with factors `x + 1`, which have no positive root.
    pub(super) fn rounded<const N: usize>(&self) -> Option<Rounded<N>> {
        if self.count == 0 || self.count > N {
            return None;
        }
        let (mut value, mut size) = ([0.0; N], [0.0; N]);
        for i in 0..self.count {
            // Of the coefficients of parts of the range, of which each is a mean of means.
            (value[i], size[i]) = (self.value[i], 2.0 * self.value[i].abs() + 2.0 * self.error[i] / CERTAIN);
        }
        for last in self.count..N {
            for i in (1..=last).rev() {
                value[i] += value[i - 1];
                size[i] += size[i - 1];
            }
        }
        Some(Rounded::of_sizes(value, size))
    }
}

#[cfg(test)]
mod tests {
    use super::Terms;
    use crate::numeric::isolation::Brackets;

    /// (x^2 - 3 x) 2 x - (x + 1) x^3 = 2 x^3 - 6 x^2 - x^4 - x^3 = -x^2 (x^2 - x + 6), and the same with + 6 x^2 (x - 2).
    #[test]
    fn sums_of_products_are_multiplied_out() {
        let terms = |values: &[f64]| Terms::<4>::new(&values.iter().map(|&x| (x, 0.0)).collect::<Vec<_>>());
        let [a, b, c, d] = [&[0.0, -3.0, 1.0][..], &[0.0, 2.0], &[1.0, 1.0], &[0.0, 0.0, 0.0, 1.0]].map(terms);
        let sum = Terms::<3>::sum([(1.0, &a, &b), (-1.0, &c, &d)].into_iter()).expect("room for three");
        assert_eq!((sum.from, sum.count, sum.value), (2, 3, [-6.0, 1.0, -1.0]));
        // Half a unit for each of two sums of at most one term in a place, and for a product.
        assert_eq!(sum.error, [6.0, 3.0, 1.0].map(|size| 1.5 * f64::EPSILON * size));
        assert_eq!(sum.at(2.0), -4.0 * 8.0);
        assert!(Terms::<2>::sum([(1.0, &a, &b), (-1.0, &c, &d)].into_iter()).is_none());
        let mut brackets = Brackets::new();
        sum.rounded::<9>().expect("three of nine").isolate(&mut brackets).expect("certain signs");
        assert!(brackets.is_empty());
    }

    /// x (x - 2.1) (x - 3.3).
    #[test]
    fn more_coefficients_leave_the_positive_roots() {
        let cubic = Terms::<4>::new(&[0.0, 6.93, -5.4, 1.0].map(|x| (x, 0.0)));
        let mut brackets = Brackets::new();
        let rounded = cubic.rounded::<9>().expect("three of nine");
        rounded.isolate(&mut brackets).expect("distinct roots");
        let roots: Vec<f64> = brackets.iter().filter_map(|bracket| rounded.refine(bracket, 1e-6)).collect();
        assert!(roots.len() == 2 && (roots[0] - 2.1).abs() < 1e-12 && (roots[1] - 3.3).abs() < 1e-12, "{roots:?}");
    }
}
