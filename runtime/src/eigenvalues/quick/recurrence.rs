//! The characteristic polynomial of a Hessenberg matrix.

use arrayvec::ArrayVec;

use super::{first_meant, pairs, pairs_mut};
use crate::number::lane::Lane;

/// Of a matrix in Hessenberg form, scaled so that the entries below the diagonal are one, the entries on and above it; what is
/// below is not meant. The
/// polynomials of its leading blocks follow from each other: `p_(k+1) = s p_k - sum h_ik p_i`. At a number that gives the value
/// of the last one for a matrix that differs from this one by rounding of its entries (Hyman; Wilkinson 1963).
pub(super) struct Recurrence<'a, T, const C: usize> {
    pub(super) size: usize,
    pub(super) rows: &'a [[T; C]; C],
}

impl<'a, T: Lane, const C: usize> Recurrence<'a, T, C> {
    #[inline(always)]
    pub(super) fn new(size: usize, rows: &'a mut [[T; C]; C]) -> Self {
        assert!(size <= C);
        let mut below = [rows[0][0]; C];
        for k in 1..size {
            below[k] = rows[k][k - 1];
        }
        for i in 0..size {
            let mut product = below[i].like(1.0);
            for k in i + 1..size {
                product = product * below[k];
                rows[i][k] = rows[i][k] * product;
            }
        }
        Self { size, rows }
    }

    /// The coefficients, ascending, without the last one, which is one.
    #[inline(always)]
    pub(super) fn coefficients(&self) -> [T; C] {
        let Self { size, rows } = self;
        assert!(*size <= C);
        let (zero, one) = (rows[0][0].like(0.0), rows[0][0].like(1.0));
        // All of one degree more than there are coefficients: those of p_k are one at k and zero beyond.
        let mut leading = ArrayVec::<[T; C], C>::new();
        let mut last = [zero; C];
        last[0] = one;
        for k in 0..*size {
            let mut next = [zero; C];
            next[1..=k].copy_from_slice(&last[..k]);
            leading.push(last);
            for (i, leading) in leading.iter().enumerate() {
                let (factor, even) = (rows[i][k], i / 2 * 2 + 2);
                for (next, leading) in pairs_mut(&mut next[..even]).iter_mut().zip(pairs(&leading[..even])) {
                    *next = [next[0] - factor * leading[0], next[1] - factor * leading[1]];
                }
            }
            if k + 1 < *size {
                next[k + 1] = one;
            }
            last = next;
        }
        last
    }

    /// The value at a complex number.
    #[inline(always)]
    pub(super) fn at(&self, re: T, im: T) -> [T; 2] {
        let Self { size, rows } = self;
        assert!(*size <= C);
        let zero = re.like(0.0);
        let (mut sums_re, mut sums_im) = (rows[0], [zero; C]);
        let (mut value_re, mut value_im) = (re.like(1.0), zero);
        for k in 0..*size {
            (value_re, value_im) =
                (re * value_re - im * value_im - sums_re[k], re * value_im + im * value_re - sums_im[k]);
            if k + 1 < *size {
                let even = first_meant::<C>(k);
                let row = pairs(&rows[k + 1][even..*size]);
                let sums = pairs_mut(&mut sums_re[even..*size]).iter_mut().zip(pairs_mut(&mut sums_im[even..*size]));
                for ((re, im), entry) in sums.zip(row) {
                    *re = [re[0] + entry[0] * value_re, re[1] + entry[1] * value_re];
                    *im = [im[0] + entry[0] * value_im, im[1] + entry[1] * value_im];
                }
            }
        }
        [value_re, value_im]
    }

    /// The same at a real number.
    #[inline(always)]
    pub(super) fn at_real(&self, re: T) -> T {
        let Self { size, rows } = self;
        assert!(*size <= C);
        let mut sums = rows[0];
        let mut value = re.like(1.0);
        for k in 0..*size {
            value = re * value - sums[k];
            if k + 1 < *size {
                let even = first_meant::<C>(k);
                for (sum, entry) in pairs_mut(&mut sums[even..*size]).iter_mut().zip(pairs(&rows[k + 1][even..*size])) {
                    *sum = [sum[0] + entry[0] * value, sum[1] + entry[1] * value];
                }
            }
        }
        value
    }
}
