//! The sums of two eigenvalues.

use nalgebra::Complex;

use super::condition::ROUNDING;
use super::equations::Equations;
use crate::eigenvalues::Spectrum;
use crate::system::SystemError;

/// A real eigenvalue, or that of a pair with the positive imaginary part.
#[derive(Clone, Copy, Debug)]
pub(super) struct Half {
    pub(super) value: Complex<f64>,
    pub(super) error: f64,
}

/// A sum of two eigenvalues, or one of two sums that are conjugate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sum {
    pub(super) size: f64,
    pub(super) error: f64,
    /// Of two conjugate sums that both have this size the product is positive.
    pub(super) is_negative: bool,
}

/// What vanishes is less than so much of the norm: two eigenvalues that nearly coincide come out with half of the digits.
const VANISHING: f64 = 1e-7;

/// What vanishes in spite of all digits is less than so many times its error.
const CERTAIN: f64 = 8.0;

impl Spectrum {
    pub(super) fn halves(&self) -> Vec<Half> {
        let error = 0.5 * ROUNDING * self.norm;
        self.values.iter().filter(|value| value.im >= 0.0).map(|&value| Half { value, error }).collect()
    }
}

impl Equations {
    /// The halves with all digits that the coefficients give; where eigenvalues coincide, as they are.
    pub(super) fn refined_halves(&self, spectrum: &Spectrum, v: f64) -> Vec<Half> {
        let refine = |half: Half| match self.refine(half.value, v) {
            // Real ones stay so.
            Some((value, error)) if (value.im == 0.0) == (half.value.im == 0.0) => Half { value, error },
            _ => half,
        };
        spectrum.halves().into_iter().map(refine).collect()
    }

    /// How many eigenvalues vanish in rounding at a speed.
    pub(super) fn count_zeros(&self, v: f64) -> Result<usize, SystemError> {
        let spectrum = self.spectrum(v)?;
        Ok(spectrum.values.iter().filter(|value| value.norm() <= VANISHING * spectrum.norm).count())
    }

    /// How many sums of two eigenvalues are zero at a speed, as far as can be told, where so many eigenvalues are.
    pub(super) fn count_zero_sums(&self, v: f64, drifts: usize) -> Result<usize, SystemError> {
        let spectrum = self.spectrum(v)?;
        let (mut coarse, mut fine) = (0, 0);
        each_sum(&spectrum.halves(), |sum| coarse += usize::from(sum.size <= VANISHING * spectrum.norm));
        // Those that are zero coincide, and have no more digits.
        if coarse == 0 || drifts > 0 {
            return Ok(coarse);
        }
        // Small beside the largest eigenvalues, they need not be small themselves.
        each_sum(&self.refined_halves(&spectrum, v), |sum| fine += usize::from(sum.size <= CERTAIN * sum.error));
        Ok(fine)
    }
}

/// All sums of two eigenvalues.
pub(super) fn each_sum(halves: &[Half], mut with: impl FnMut(Sum)) {
    for (i, &Half { value: s, error: s_error }) in halves.iter().enumerate() {
        if s.im > 0.0 {
            with(Sum { size: 2.0 * s.re.abs(), error: 2.0 * s_error, is_negative: s.re < 0.0 });
        }
        for &Half { value: t, error: t_error } in &halves[..i] {
            let (re, error) = (s.re + t.re, s_error + t_error);
            if s.im == 0.0 && t.im == 0.0 {
                with(Sum { size: re.abs(), error, is_negative: re < 0.0 });
                continue;
            }
            let distances: &[f64] =
                if s.im == 0.0 || t.im == 0.0 { &[s.im + t.im] } else { &[s.im + t.im, s.im - t.im] };
            for im in distances {
                let size = re.hypot(*im);
                with(Sum { size, error, is_negative: false });
                with(Sum { size, error, is_negative: false });
            }
        }
    }
}
