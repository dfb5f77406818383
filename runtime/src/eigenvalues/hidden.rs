//! Eigenvalues that are so much smaller than others that rounding of these hides them.

use nalgebra::Complex;

use super::general::Spectrum;
use crate::number::Number;
use crate::numeric::sort_by;
use crate::system::SystemError;

/// Eigenvalues in any unit and order, and up to what size they are those of the matrices.
pub(super) struct Found {
    pub(super) values: Vec<Complex<f64>>,
    /// Those that are smaller are nothing but rounding.
    pub(super) hidden: f64,
    /// Those that are larger have half of their digits at least.
    pub(super) clear: f64,
}

impl Found {
    /// Eigenvalues with all of their digits.
    pub(super) fn exactly(values: Vec<Complex<f64>>) -> Self {
        Self { values, hidden: 0.0, clear: 0.0 }
    }

    /// Those of a matrix, which are wrong by its rounding.
    pub(super) fn of_spectrum(Spectrum { values, norm }: Spectrum) -> Self {
        const HIDDEN: f64 = 16.0 * f64::EPSILON;
        const CLEAR: f64 = 1.0 / (1u64 << 26) as f64;
        Self { values, hidden: HIDDEN * norm, clear: CLEAR * norm }
    }

    /// Both square roots of each.
    pub(super) fn square_roots(self, of: impl Fn(Complex<f64>) -> [Complex<f64>; 2]) -> Self {
        let values = self.values.into_iter().flat_map(of).collect();
        Self { values, hidden: Number::sqrt(self.hidden), clear: Number::sqrt(self.clear) }
    }

    /// The eigenvalues of `M s^2 + C s + K`, the hidden ones as the reciprocals of the largest of `K s^2 + C s + M`.
    ///
    /// # Errors
    /// If there are three sizes or more, so that some are hidden both ways.
    pub(super) fn uncovered(
        self,
        reversed: impl FnOnce() -> Result<Self, SystemError>,
    ) -> Result<Vec<Complex<f64>>, SystemError> {
        let Self { mut values, hidden, clear } = self;
        let smaller = |values: &[Complex<f64>], size: f64| values.iter().filter(|value| value.norm() < size).count();
        let needed = smaller(&values, hidden);
        if needed == 0 {
            return Ok(values);
        }
        let reversed = match reversed() {
            // Of a singular K eigenvalues are zero, and come out so.
            Err(SystemError::SingularMass) => return Ok(values),
            reversed => reversed?,
        };
        let largest = reversed.values.iter().filter(|value| value.norm() >= reversed.clear);
        let mut smallest: Vec<Complex<f64>> = largest.map(|value| Complex::new(1.0, 0.0) / value).collect();
        sort_by_size(&mut values);
        sort_by_size(&mut smallest);
        // No half of a pair alone.
        let is_whole = |values: &[Complex<f64>]| values.iter().map(|value| value.im).sum::<f64>() == 0.0;
        let most = smallest.len().min(smaller(&values, clear));
        let count = (needed..=most).rfind(|&count| is_whole(&values[..count]) && is_whole(&smallest[..count]));
        let Some(count) = count else {
            return Err(SystemError::OutOfRange { quantity: "an eigenvalue beside far larger ones" });
        };
        values[..count].copy_from_slice(&smallest[..count]);
        Ok(values)
    }
}

/// With the halves of pairs next to each other.
fn sort_by_size(values: &mut [Complex<f64>]) {
    let key = |x: &Complex<f64>| [x.norm(), x.re, x.im.abs(), x.im];
    sort_by(values, |x, y| key(x).partial_cmp(&key(y)).unwrap_or(core::cmp::Ordering::Equal));
}
