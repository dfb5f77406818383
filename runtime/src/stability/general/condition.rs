//! What is zero at critical speeds, as functions of the speed that are polynomials in v/(1 + v).

use core::cell::RefCell;

use super::equations::Equations;
use super::inverse::determinant;
use super::product::Product;
use crate::eigenvalues::Spectrum;
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

/// The same where `det K` is zero at all speeds: the product of the eigenvalues without so many of the smallest.
pub(super) struct Drifting<'a> {
    pub(super) equations: &'a Equations,
    pub(super) drifts: usize,
}

impl Condition for Drifting<'_> {
    fn at(&self, v: f64) -> Result<Product, SystemError> {
        let spectrum = self.equations.spectrum(v)?;
        let mut values = spectrum.values.to_vec();
        values.sort_by(|x, y| x.norm().total_cmp(&y.norm()));
        let error = ROUNDING * spectrum.norm;
        Ok(values.into_iter().skip(self.drifts).fold(Product::ONE, |product, value| {
            // The product of a pair is positive.
            let factor = if value.im == 0.0 { value.re } else { value.norm() };
            product.times(factor, error / value.norm())
        }))
    }
}

/// How many eigenvalues vanish in rounding.
pub(super) fn count_zeros(spectrum: &Spectrum) -> usize {
    spectrum.values.iter().filter(|value| value.norm() <= VANISHING * spectrum.norm).count()
}

/// Two eigenvalues that nearly coincide come out with half of the digits.
const VANISHING: f64 = 1e-7;

/// The product of all sums of two eigenvalues: the determinant of the bialternate sum, or of Hurwitz.
///
/// Where some of the sums are zero at all speeds, so many of the smallest are left out. Without damping, where the
/// spectrum is symmetric about the imaginary axis, the others make the discriminant of the polynomial in s^2.
pub(super) struct Flutter<'a> {
    pub(super) equations: &'a Equations,
    pub(super) left_out: usize,
    /// How many eigenvalues are zero at all speeds.
    pub(super) drifts: usize,
    /// What the eigenvalues tell by the way: speeds, and how many are unstable there, where that is clear.
    pub(super) samples: RefCell<Vec<(f64, usize)>>,
}

/// A sum of two eigenvalues, or one of two sums that are conjugate.
#[derive(Clone, Copy)]
pub(super) struct Sum {
    pub(super) size: f64,
    /// Of two conjugate sums that both have this size the product is positive.
    pub(super) is_negative: bool,
}

impl Condition for Flutter<'_> {
    fn at(&self, v: f64) -> Result<Product, SystemError> {
        let spectrum = self.equations.spectrum(v)?;
        self.samples
            .borrow_mut()
            .extend(spectrum.clear_count(self.drifts, self.left_out > 0).map(|unstable| (v, unstable)));
        let error = ROUNDING * spectrum.norm;
        let times = |product: Product, sum: Sum| {
            let factor = if sum.is_negative { -sum.size } else { sum.size };
            product.times(factor, error / sum.size)
        };
        let mut product = Product::ONE;
        if self.left_out == 0 {
            each_sum(&spectrum, |sum| product = times(product, sum));
        } else {
            let mut sums = Vec::new();
            each_sum(&spectrum, |sum| sums.push(sum));
            sums.sort_by(|x, y| x.size.total_cmp(&y.size));
            product = sums.into_iter().skip(self.left_out).fold(product, times);
        }
        Ok(product)
    }
}

/// All sums of two eigenvalues.
pub(super) fn each_sum(spectrum: &Spectrum, mut with: impl FnMut(Sum)) {
    // Of a pair only the half with the positive imaginary part.
    let halves = || spectrum.values.iter().filter(|value| value.im >= 0.0).enumerate();
    for (i, s) in halves() {
        if s.im > 0.0 {
            with(Sum { size: 2.0 * s.re.abs(), is_negative: s.re < 0.0 });
        }
        for (_, t) in halves().take(i) {
            let re = s.re + t.re;
            if s.im == 0.0 && t.im == 0.0 {
                with(Sum { size: re.abs(), is_negative: re < 0.0 });
                continue;
            }
            let distances: &[f64] =
                if s.im == 0.0 || t.im == 0.0 { &[s.im + t.im] } else { &[s.im + t.im, s.im - t.im] };
            for im in distances {
                let size = re.hypot(*im);
                with(Sum { size, is_negative: false });
                with(Sum { size, is_negative: false });
            }
        }
    }
}

/// How many sums of two eigenvalues vanish in rounding.
pub(super) fn count_zero_sums(spectrum: &Spectrum) -> usize {
    let mut count = 0;
    each_sum(spectrum, |sum| count += usize::from(sum.size <= VANISHING * spectrum.norm));
    count
}
