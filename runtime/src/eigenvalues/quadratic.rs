//! Monic quadratics and their roots.

use nalgebra::Complex;

use crate::number::lane::Lane;

/// A monic quadratic `x^2 + p x + q`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quadratic<T = f64> {
    pub(crate) p: T,
    pub(crate) q: T,
}

/// Two roots, by their real and imaginary parts: two real ones, ascending, or a conjugate pair, the negative imaginary
/// part first.
#[derive(Clone, Copy)]
pub(super) struct Pair<T> {
    pub(super) re: [T; 2],
    pub(super) im: [T; 2],
}

impl<T: Lane> Quadratic<T> {
    #[inline(always)]
    pub(super) fn select(mask: T::Mask, yes: Self, no: Self) -> Self {
        Self { p: T::select(mask, yes.p, no.p), q: T::select(mask, yes.q, no.q) }
    }

    /// Both roots.
    #[inline(always)]
    pub(super) fn roots(self) -> Pair<T> {
        let zero = self.p.like(0.0);
        let half = self.p.like(0.5) * self.p;
        let discriminant = half * half - self.q;
        let is_pair = discriminant.less(zero);
        let root = discriminant.abs().sqrt();
        if T::all(is_pair) {
            return Pair { re: [zero - half; 2], im: [-root, root] };
        }
        let large = zero - (half + root.copysign(half));
        // Both are zero if the larger one is; and zero is positive.
        let small = T::select(large.abs().less_or_equal(zero), zero, self.q / large + zero);
        let is_ascending = large.less(small);
        let real = [T::select(is_ascending, large, small), T::select(is_ascending, small, large)];
        let im = T::select(is_pair, root, zero);
        let mean = zero - half;
        Pair { re: [T::select(is_pair, mean, real[0]), T::select(is_pair, mean, real[1])], im: [zero - im, im] }
    }
}

impl<T: Lane> Quadratic<T> {
    /// Both roots as complex numbers.
    #[inline]
    pub(super) fn complex_roots(self) -> [Complex<T>; 2] {
        let Pair { re, im } = self.roots();
        [Complex::new(re[0], im[0]), Complex::new(re[1], im[1])]
    }
}
