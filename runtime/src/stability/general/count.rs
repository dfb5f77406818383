//! How many eigenvalues are on which side of the imaginary axis at a speed.

use nalgebra::Complex;

use super::equations::Equations;
use crate::eigenvalues::Spectrum;
use crate::stability::verdict::Verdict;
use crate::system::SystemError;

/// The eigenvalues at a speed, by the sign of the real part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Count {
    pub(super) unstable: usize,
    /// On the axis as far as the digits of the coefficients tell, those that are zero at all speeds among them.
    pub(super) marginal: usize,
}

/// A real part that is larger than so much of the norm has a certain sign as it comes.
const CLEAR: f64 = 1e-6;

/// Where eigenvalues on the axis nearly coincide, rounding moves them off it by less than so much of the norm.
const COARSE: f64 = 1e-4;

impl Equations {
    /// Counts the eigenvalues at a scaled speed; real parts that rounding may have made are found with more digits.
    pub(super) fn count(&self, v: f64) -> Result<Count, SystemError> {
        let spectrum = self.spectrum(v)?;
        let mut count = Count { unstable: 0, marginal: self.zeros };
        // One of each pair for both.
        for &s in spectrum.values.iter().filter(|value| value.im >= 0.0) {
            let multiplicity = if s.im > 0.0 { 2 } else { 1 };
            let (re, error) = if s.re.abs() > CLEAR * spectrum.norm {
                (s.re, 0.0)
            } else {
                // Where Newton's iteration finds no end, eigenvalues coincide, and come out with half of the digits.
                self.refine(s, v).map_or((s.re, CLEAR * spectrum.norm), |(s, error)| (s.re, error))
            };
            if re.abs() <= error {
                count.marginal += multiplicity;
            } else if re > 0.0 {
                count.unstable += multiplicity;
            }
        }
        Ok(count)
    }
}

impl Count {
    pub(super) fn verdict(self) -> Verdict {
        match self {
            Self { unstable: 0, marginal: 0 } => Verdict::Stable,
            Self { unstable: 0, .. } => Verdict::Marginal,
            _ => Verdict::Unstable,
        }
    }
}

impl Spectrum {
    /// How many eigenvalues are unstable, if no real part is so small that rounding may have made its sign; where
    /// eigenvalues are symmetric about the imaginary axis, if those that are not on it are clearly off it.
    pub(super) fn clear_count(&self, drifts: usize, is_symmetric: bool) -> Option<usize> {
        let near = if is_symmetric { CLEAR..=COARSE } else { 0.0..=CLEAR };
        let is_unclear = |value: &&Complex<f64>| near.contains(&(value.re.abs() / self.norm));
        let is_unstable = |value: &&Complex<f64>| value.re > CLEAR * self.norm;
        // Those that are zero at all speeds are on the axis.
        let unclear = self.values.iter().filter(is_unclear).count();
        (unclear <= if is_symmetric { 0 } else { drifts }).then(|| self.values.iter().filter(is_unstable).count())
    }
}
