//! Whether a polynomial is stable, by the criteria of Hurwitz.

use core::fmt;

use crate::numeric::Tracked;

/// Whether the motion is stable at one speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
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

/// The verdict on a polynomial of degree up to four, by its coefficients, ascending, the last one positive.
pub(super) fn verdict(coefficients: &[Tracked]) -> Verdict {
    let zeros = coefficients.iter().take_while(|p| p.sign() == 0).count();
    let without_zeros = &coefficients[zeros..];
    if without_zeros.iter().any(|p| p.sign() < 0) {
        return Verdict::Unstable;
    }
    // Zero if a pair is on the imaginary axis, given that no coefficient is negative and the first one is positive.
    let axis = match *without_zeros {
        [_, p1, _] => p1.sign(),
        [p0, p1, p2, p3] => (p1 * p2 - p0 * p3).sign(),
        [p0, p1, p2, p3, p4] if p1.sign() == 0 && p3.sign() == 0 => {
            // A quadratic in s^2, whose roots must be real.
            if p2.sign() > 0 && (p2 * p2 - p0 * p4 * 4.0.into()).sign() >= 0 { 0 } else { -1 }
        }
        [p0, p1, p2, p3, p4] => (p1 * p2 * p3 - p1 * p1 * p4 - p0 * p3 * p3).sign(),
        _ => 1,
    };
    match axis {
        1 if zeros == 0 => Verdict::Stable,
        0 | 1 => Verdict::Marginal,
        _ => Verdict::Unstable,
    }
}

#[cfg(test)]
mod tests {
    use super::{Verdict, verdict};
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
        verdict(&product.into_iter().map(Tracked::from).collect::<Vec<_>>())
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
}
