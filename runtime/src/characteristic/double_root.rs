//! Speeds at which two eigenvalues coincide: the characteristic polynomial p(v, s) and its slope in s are zero together.

use core::ops::{Add, Mul, Sub};

use crate::numeric::expand_taylor;

/// The characteristic polynomial and its derivatives at a speed v, or another variable in its place, and an eigenvalue s.
#[derive(Clone, Copy)]
pub(crate) struct Jet<T> {
    pub(crate) p: T,
    pub(crate) by_s: T,
    pub(crate) by_ss: T,
    pub(crate) by_v: T,
    pub(crate) by_vs: T,
}

impl<T> Jet<T> {
    /// Each of them through a function.
    #[cfg(feature = "std")]
    pub(crate) fn map<U>(self, f: impl Fn(T) -> U) -> Jet<U> {
        let Self { p, by_s, by_ss, by_v, by_vs } = self;
        Jet { p: f(p), by_s: f(by_s), by_ss: f(by_ss), by_v: f(by_v), by_vs: f(by_vs) }
    }
}

impl<T: Copy + From<f64> + Add<Output = T> + Sub<Output = T> + Mul<Output = T>> Jet<T> {
    /// From the coefficients in s and their derivatives by v.
    #[inline]
    pub(crate) fn new(p: [T; 5], by_v: [T; 5], s: T) -> Self {
        let [p, by_s, half_curvature] = expand_taylor(p.into_iter(), s);
        let [by_v, by_vs, _] = expand_taylor(by_v.into_iter(), s);
        Self { p, by_s, by_ss: half_curvature + half_curvature, by_v, by_vs }
    }

    /// What Newton's step is divided by; zero where two such speeds meet.
    #[inline]
    pub(crate) fn determinant(&self) -> T {
        self.by_v * self.by_ss - self.by_s * self.by_vs
    }

    /// The step of v and of s that changes p and its slope by the negatives of these, to first order, times the determinant.
    #[inline]
    pub(crate) fn step_against(&self, [p, slope]: [T; 2]) -> [T; 2] {
        [self.by_s * slope - self.by_ss * p, self.by_vs * p - self.by_v * slope]
    }
}

#[cfg(test)]
mod tests {
    use super::Jet;

    /// s^2 - v has a double root of zero at v = 0. It is linear in v, so that one step finds s, and the next one v.
    #[test]
    fn newton_finds_the_double_root_of_a_square() {
        let (mut v, mut s) = (0.5, 0.25);
        for _ in 0..2 {
            let jet = Jet::new([-v, 0.0, 1.0, 0.0, 0.0], [-1.0, 0.0, 0.0, 0.0, 0.0], s);
            let [v_step, s_step] = jet.step_against([jet.p, jet.by_s]).map(|step| step / jet.determinant());
            (v, s) = (v + v_step, s + s_step);
        }
        assert_eq!((v, s), (0.0, 0.0));
    }
}
