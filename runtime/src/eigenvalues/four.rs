//! Four eigenvalues in order, in each lane.

use super::quadratic::Quadratic;
use crate::number::lane::Lane;

/// Four eigenvalues by their real and imaginary parts, sorted by real part, then by imaginary part.
#[derive(Clone, Copy)]
pub(crate) struct Four<T> {
    pub(crate) re: [T; 4],
    pub(crate) im: [T; 4],
}

impl<T: Lane> Four<T> {
    /// The roots of two quadratics.
    #[inline(always)]
    pub(super) fn new([s, t]: [Quadratic<T>; 2]) -> Self {
        let (s, t) = (s.roots(), t.roots());
        let mut four = Self { re: [s.re[0], s.re[1], t.re[0], t.re[1]], im: [s.im[0], s.im[1], t.im[0], t.im[1]] };
        // Both halves are in order already; merge them.
        four.order(0, 2);
        four.order(1, 3);
        four.order(1, 2);
        four
    }

    /// Exchanges two of them where they are not in order.
    #[inline(always)]
    fn order(&mut self, i: usize, j: usize) {
        let (re, im) = (self.re, self.im);
        let is_less = re[j].less(re[i]);
        let exchange = is_less | (re[j].less_or_equal(re[i]) & im[j].less(im[i]));
        self.re[i] = T::select(exchange, re[j], re[i]);
        self.re[j] = T::select(exchange, re[i], re[j]);
        self.im[i] = T::select(exchange, im[j], im[i]);
        self.im[j] = T::select(exchange, im[i], im[j]);
    }
}
