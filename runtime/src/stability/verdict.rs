//! Whether motion is stable: by its eigenvalues, or by the criteria of Hurwitz.

use core::fmt;

use nalgebra::Complex;
// The norm of complex numbers without `std`.
#[cfg(not(feature = "std"))]
use nalgebra::Normed;

use crate::characteristic::conditions::{QuarticConditions, hurwitz_of_cubic};
use crate::characteristic::powers::Powers;
use crate::numeric::Tracked;

/// Whether the motion is stable at one speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Verdict {
    /// Every eigenvalue has a negative real part.
    Stable,
    /// No eigenvalue has a positive real part, and at least one has a zero real part. Motions may still grow, though
    /// slower than exponentially, where such an eigenvalue is multiple.
    Marginal,
    /// An eigenvalue has a positive real part.
    Unstable,
}

/// Reads `stable`, `marginal`, `unstable`.
impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Stable => "stable",
            Self::Marginal => "marginal",
            Self::Unstable => "unstable",
        })
    }
}

/// A real part that is so much smaller than the largest eigenvalue may be zero: two eigenvalues that are equal come out
/// with half of the digits.
const NEGLIGIBLE: f64 = 1e-7;

impl Verdict {
    /// Whether motion with these eigenvalues is stable, for any number of coordinates, as far as their digits tell.
    ///
    /// Marginal is a largest real part of at most 1e-7 times the largest eigenvalue: that much rounding may leave of a zero
    /// that two eigenvalues share. [`Stability::verdict`](crate::Stability::verdict) needs no such
    /// tolerance.
    ///
    /// ```
    /// use carvallo::{Matrix, System, Verdict};
    ///
    /// // Three coordinates, each a damped oscillator: q'' + q' + 4 q = 0.
    /// let one = Matrix::<f64, 3>::identity();
    /// let system = System::new(one, one, one * 4.0);
    /// assert_eq!(Verdict::of(&system.eigenvalues()?), Verdict::Stable);
    /// # Ok::<(), carvallo::SystemError>(())
    /// ```
    #[must_use]
    pub fn of(eigenvalues: &[Complex<f64>]) -> Self {
        let rightmost = eigenvalues.iter().map(|value| value.re).fold(f64::NEG_INFINITY, f64::max);
        let largest = eigenvalues.iter().map(|value| value.norm()).fold(0.0, f64::max);
        if rightmost.abs() <= NEGLIGIBLE * largest {
            Self::Marginal
        } else if rightmost < 0.0 {
            Self::Stable
        } else {
            Self::Unstable
        }
    }

    /// The verdict on a polynomial of degree up to four, by its coefficients, ascending, the last one positive.
    pub(super) fn of_polynomial(coefficients: &[Tracked]) -> Self {
        let zeros = coefficients.iter().take_while(|p| p.sign() == 0).count();
        let without_zeros = coefficients.get(zeros..).unwrap_or_default();
        if without_zeros.iter().any(|p| p.sign() < 0) {
            return Self::Unstable;
        }
        // Zero if a pair is on the imaginary axis, given that no coefficient is negative and the first one is positive.
        let axis = match *without_zeros {
            [_, p1, _] => p1.sign(),
            [p0, p1, p2, p3] => hurwitz_of_cubic([p0, p1, p2, p3]).sign(),
            [p0, p1, p2, p3, p4] if p1.sign() == 0 && p3.sign() == 0 => {
                // A quadratic in s^2, whose roots must be real.
                if p2.sign() > 0 && (p2 * p2 - p0 * p4 * 4.0.into()).sign() >= 0 { 0 } else { -1 }
            }
            [p0, p1, p2, p3, p4] => {
                let [hurwitz] = QuarticConditions::new(&Powers::of_numbers([p0, p1, p2, p3, p4])).hurwitz();
                hurwitz.sign()
            }
            _ => 1,
        };
        match axis {
            1 if zeros == 0 => Self::Stable,
            0 | 1 => Self::Marginal,
            _ => Self::Unstable,
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::Verdict;
    use crate::numeric::Tracked;

    /// Ascending coefficients of the product of factors.
    fn of(factors: &[&[f64]]) -> Verdict {
        let mut product = vec![1.0];
        for factor in factors {
            let mut next = vec![0.0; product.len() + factor.len() - 1];
            for (i, x) in product.iter().enumerate() {
                for (j, y) in factor.iter().enumerate() {
                    next[i + j] += x * y;
                }
            }
            product = next;
        }
        Verdict::of_polynomial(&product.into_iter().map(Tracked::from).collect::<Vec<_>>())
    }

    #[test]
    fn reads_the_half_plane_from_the_coefficients() {
        let (damped, undamped, growing) = (&[5.0, 2.0, 1.0], &[4.0, 0.0, 1.0], &[5.0, -2.0, 1.0]);
        let (left, zero, right) = (&[3.0, 1.0], &[0.0, 1.0], &[-3.0, 1.0]);
        assert_eq!(of(&[damped, damped]), Verdict::Stable);
        assert_eq!(of(&[damped, left, left]), Verdict::Stable);
        assert_eq!(of(&[left, left, left, left]), Verdict::Stable);
        assert_eq!(of(&[damped, undamped]), Verdict::Marginal);
        assert_eq!(of(&[undamped, undamped]), Verdict::Marginal);
        assert_eq!(of(&[damped, left, zero]), Verdict::Marginal);
        assert_eq!(of(&[undamped, left, zero]), Verdict::Marginal);
        assert_eq!(of(&[undamped, zero, zero]), Verdict::Marginal);
        assert_eq!(of(&[left, zero, zero, zero]), Verdict::Marginal);
        assert_eq!(of(&[zero, zero, zero, zero]), Verdict::Marginal);
        assert_eq!(of(&[damped, growing]), Verdict::Unstable);
        assert_eq!(of(&[undamped, left, right]), Verdict::Unstable);
        assert_eq!(of(&[undamped, right, zero]), Verdict::Unstable);
        assert_eq!(of(&[left, right, left, right]), Verdict::Unstable);
    }

    #[test]
    fn rounding_of_zero_is_marginal() {
        let of =
            |parts: &[(f64, f64)]| Verdict::of(&parts.iter().map(|&(re, im)| Complex::new(re, im)).collect::<Vec<_>>());
        assert_eq!(of(&[(-2.0, -3.0), (-2.0, 3.0)]), Verdict::Stable);
        assert_eq!(of(&[(-1e-14, -3.0), (-1e-14, 3.0), (-1.0, 0.0)]), Verdict::Marginal);
        assert_eq!(of(&[(-1.4e-8, 0.0), (1.4e-8, 0.0), (-2.0, 0.0)]), Verdict::Marginal);
        assert_eq!(of(&[(-5.0, 0.0), (1e-3, 0.0)]), Verdict::Unstable);
        assert_eq!(of(&[(0.0, 0.0), (0.0, 0.0)]), Verdict::Marginal);
    }
}
