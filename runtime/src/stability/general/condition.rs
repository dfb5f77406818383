//! What is zero at critical speeds, as functions of the speed that are polynomials in v/(1 + v).

use core::cell::RefCell;

use super::equations::Equations;
use super::inverse::determinant;
use super::product::Product;
use super::sums::{Sum, each_sum};
use crate::numeric::sort_by;
use crate::system::SystemError;

/// What eigenvalues err by, relative to the norm of the balanced state matrix.
pub(super) const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A function of the speed whose sign changes where something critical happens.
pub(super) trait Condition {
    fn at(&self, v: f64) -> Result<Product, SystemError>;
}

/// `det K`, without the columns that are zero: the product of all eigenvalues, up to a factor.
pub(super) struct Divergence<'a>(pub(super) &'a Equations);

impl Condition for Divergence<'_> {
    fn at(&self, v: f64) -> Result<Product, SystemError> {
        let (value, error) = determinant(self.0.pencil(0.0, v).value);
        Ok(Product::ONE.times(value, error))
    }
}

/// The determinant of what has to be regular.
pub(super) struct Regularity<'a>(pub(super) &'a Equations);

impl Condition for Regularity<'_> {
    fn at(&self, v: f64) -> Result<Product, SystemError> {
        let (value, error) = determinant(self.0.leading(v));
        Ok(Product::ONE.times(value, error))
    }
}

/// The same where `det K` is zero at all speeds: the product of the eigenvalues without so many of the smallest.
pub(super) struct Drifting<'a> {
    pub(super) equations: &'a Equations,
    pub(super) drifts: usize,
}

impl Condition for Drifting<'_> {
    fn at(&self, v: f64) -> Result<Product, SystemError> {
        let spectrum = self.equations.spectrum(v)?;
        let mut values = spectrum.values.to_vec();
        sort_by(&mut values, |x, y| x.norm().total_cmp(&y.norm()));
        let error = ROUNDING * spectrum.norm;
        Ok(values.into_iter().skip(self.drifts).fold(Product::ONE, |product, value| {
            // The product of a pair is positive.
            let factor = if value.im == 0.0 { value.re } else { value.norm() };
            product.times(factor, error / value.norm())
        }))
    }
}

/// The product of all sums of two eigenvalues: the determinant of the bialternate sum, or of Hurwitz.
///
/// Where some of the sums are zero at all speeds, so many of the smallest are left out. Without damping, where the
/// spectrum is symmetric about the imaginary axis, the others make the discriminant of the polynomial in s^2.
pub(super) struct Flutter<'a> {
    pub(super) equations: &'a Equations,
    pub(super) left_out: usize,
    /// How many eigenvalues are zero at all speeds.
    pub(super) drifts: usize,
    /// Whether the eigenvalues are computed with all digits that the coefficients give.
    pub(super) is_refined: bool,
    /// What the eigenvalues tell by the way: speeds, and how many are unstable there, where that is clear.
    pub(super) samples: RefCell<Vec<(f64, usize)>>,
}

impl Condition for Flutter<'_> {
    fn at(&self, v: f64) -> Result<Product, SystemError> {
        let spectrum = self.equations.spectrum(v)?;
        self.samples
            .borrow_mut()
            .extend(spectrum.clear_count(self.drifts, self.left_out > 0).map(|unstable| (v, unstable)));
        let times = |product: Product, sum: Sum| {
            let factor = if sum.is_negative { -sum.size } else { sum.size };
            product.times(factor, sum.error / sum.size)
        };
        let halves = if self.is_refined { self.equations.refined_halves(&spectrum, v) } else { spectrum.halves() };
        let mut product = Product::ONE;
        if self.left_out == 0 {
            each_sum(&halves, |sum| product = times(product, sum));
        } else {
            let mut sums = Vec::new();
            each_sum(&halves, |sum| sums.push(sum));
            sort_by(&mut sums, |x, y| x.size.total_cmp(&y.size));
            product = sums.into_iter().skip(self.left_out).fold(product, times);
        }
        Ok(product)
    }
}
