//! Monic quartics.

use super::quadratic::Quadratic;
use crate::number::lane::Lane;
use crate::number::real::Real;
use crate::numeric::{Scaled, exponent};

/// A monic quartic `x^4 + a x^3 + b x^2 + c x + d`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quartic<T = f64> {
    pub(crate) a: T,
    pub(crate) b: T,
    pub(crate) c: T,
    pub(crate) d: T,
}

impl<T: Scaled> Quartic<T> {
    /// The exponent of a power of two that is about the size of the largest root.
    pub(super) fn unit(self) -> i32 {
        // By constants, so that no division by zero is looked for.
        let a = exponent(self.a).map(|e| e + 1);
        let b = exponent(self.b).map(|e| e.div_euclid(2) + 1);
        let c = exponent(self.c).map(|e| e.div_euclid(3) + 1);
        let d = exponent(self.d).map(|e| e.div_euclid(4) + 1);
        a.max(b).max(c).max(d).unwrap_or(0)
    }
}

impl<T: Real> Quartic<T> {
    /// The coefficients of the quartic less those of the product of the factors, and the size of the terms that each of
    /// them has in the roots.
    #[inline(always)]
    pub(super) fn residual(self, [s, t]: [Quadratic<T>; 2]) -> ([T; 4], [T; 4]) {
        let residual =
            [self.a - s.p - t.p, self.b - s.q - t.q - s.p * t.p, self.c - s.p * t.q - t.p * s.q, self.d - s.q * t.q];
        // Two roots may sum to zero, but then their size is not.
        let (sq, tq) = (s.q.abs(), t.q.abs());
        let (sp, tp) = (s.p.abs() + sq.sqrt(), t.p.abs() + tq.sqrt());
        (residual, [sp + tp, sq + tq + sp * tp, sp * tq + tp * sq, sq * tq])
    }
}

impl<T: Lane> Quartic<T> {
    /// Whether no intermediate result over- or underflows.
    #[inline(always)]
    pub(super) fn is_moderate(self) -> T::Mask {
        let larger = |x: T, y: T| T::select(x.less(y), y, x);
        let largest = larger(larger(self.a.abs(), self.b.abs()), larger(self.c.abs(), self.d.abs()));
        let [small, large] = T::COEFFICIENTS;
        largest.like(small).less_or_equal(largest) & largest.less(largest.like(large))
    }
}
