//! Verdicts from signs that are certain in `f64`.

use super::super::verdict::Verdict;
use super::conditions::Conditions;
use crate::numeric::rounded::Rounded;

/// The coefficients of the characteristic polynomial and the Hurwitz determinant.
pub(super) struct Signs<const P: usize, const H: usize> {
    p: [Rounded<P>; 5],
    pub(super) hurwitz: Rounded<H>,
}

impl<const P: usize, const H: usize> Signs<P, H> {
    pub(super) fn new<const D: usize>(conditions: &Conditions<P, H, D>) -> Self {
        Self { p: conditions.p.each_ref().map(Rounded::new), hurwitz: Rounded::new(&conditions.hurwitz) }
    }

    pub(super) fn capsize(&self) -> &Rounded<P> {
        &self.p[0]
    }

    /// Whether a coefficient is positive at x.
    pub(super) fn is_positive(&self, power: usize, x: f64) -> Option<bool> {
        Some(self.p.get(power)?.sign(x)? > 0)
    }

    /// The verdict at x on all eigenvalues, or at a capsize speed on those that are not zero: there p_0 is zero, and the
    /// determinant is that of the cubic that is left, times p_1.
    pub(super) fn verdict(&self, is_capsize: bool, x: f64) -> Option<Verdict> {
        for power in usize::from(is_capsize)..4 {
            if !self.is_positive(power, x)? {
                return Some(Verdict::Unstable);
            }
        }
        Some(if self.hurwitz.sign(x)? > 0 { Verdict::Stable } else { Verdict::Unstable })
    }
}
