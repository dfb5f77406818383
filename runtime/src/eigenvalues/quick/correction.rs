//! Roots as good as the matrix, all together, and whether each of them is one and none is missing.

use super::recurrence::Recurrence;
use crate::number::lane::Lane;

/// The bound on corrections; one or two are usual.
const ROUNDS: usize = 4;

/// What is left, relative to the norm.
const LEFT: f64 = 1.0 / (1u64 << 55) as f64;

/// Moves all roots, by their real and imaginary parts, to those of the matrix, pairs next to each other and real ones next to
/// each other. Whether they are certain.
///
/// Each is corrected by Weierstrass's `w_i = p(s_i) / prod (s_i - s_j)`, with p from the matrix. Discs about `s_i - w_i` with
/// the radius `(n - 1) |w_i|` have all roots in them, and where they are apart each has one (Braess & Hadeler 1973). What is
/// left after the step is `|w_i| sum |w_j| / |s_i - s_j|` to first order.
#[inline(always)]
pub(super) fn correct<T: Lane, const C: usize>(
    recurrence: &Recurrence<'_, T, C>,
    [re, im]: &mut [[T; C]; 2],
    norm: T,
) -> T::Mask {
    let size = recurrence.size;
    assert!(size <= C);
    let zero = norm.like(0.0);
    let mut are_certain = norm.less(zero);
    for _ in 0..ROUNDS {
        let (mut by_re, mut by_im) = ([zero; C], [zero; C]);
        let (mut gaps, mut steps) = ([zero; C], [zero; C]);
        let mut largest = zero;
        for i in (0..size).step_by(2) {
            let is_real = zero.less_or_equal(im[i]);
            let value = if T::all(is_real) { [recurrence.at_real(re[i]), zero] } else { recurrence.at(re[i], im[i]) };
            let step = quotient(size, i, value, re, im);
            (by_re[i], by_im[i], gaps[i], steps[i]) =
                (step.re, T::select(is_real, zero, step.im), step.gap, step.square);
            // Conjugate, where the other one is not real as well.
            (by_re[i + 1], by_im[i + 1], gaps[i + 1], steps[i + 1]) = (by_re[i], zero - by_im[i], gaps[i], steps[i]);
            if !T::all(!is_real) {
                let step = quotient(size, i + 1, [recurrence.at_real(re[i + 1]), zero], re, im);
                by_re[i + 1] = T::select(is_real, step.re, by_re[i + 1]);
                by_im[i + 1] = T::select(is_real, zero, by_im[i + 1]);
                gaps[i + 1] = T::select(is_real, step.gap, gaps[i + 1]);
                steps[i + 1] = T::select(is_real, step.square, steps[i + 1]);
            }
            let larger = T::select(steps[i].less(steps[i + 1]), steps[i + 1], steps[i]);
            largest = T::select(larger.less_or_equal(largest), largest, larger);
        }
        // All of these are squares.
        let count = zero.like((size * size) as f64);
        let reach = count * largest;
        let left = norm * norm * zero.like(LEFT * LEFT);
        let mut is_last = largest.less_or_equal(largest);
        for i in 0..size {
            is_last =
                is_last & (zero.like(16.0) * reach).less(gaps[i]) & (steps[i] * reach).less_or_equal(left * gaps[i]);
        }
        for i in 0..size {
            re[i] = T::select(are_certain, re[i], re[i] - by_re[i]);
            im[i] = T::select(are_certain, im[i], im[i] - by_im[i]);
        }
        are_certain = are_certain | is_last;
        if T::all(are_certain) {
            break;
        }
    }
    are_certain
}

/// A step of one root, with the squares of its size and of the distance to the nearest other root.
struct Step<T> {
    re: T,
    im: T,
    square: T,
    gap: T,
}

/// The value of the polynomial at the i-th root over the product of its distances to all others.
#[inline(always)]
fn quotient<T: Lane, const C: usize>(
    size: usize,
    i: usize,
    [value_re, value_im]: [T; 2],
    re: &[T; C],
    im: &[T; C],
) -> Step<T> {
    let (mut product_re, mut product_im) = (value_re.like(1.0), value_re.like(0.0));
    let mut gap = value_re.like(f64::MAX);
    for j in 0..size {
        if i != j {
            let (x, y) = (re[i] - re[j], im[i] - im[j]);
            (product_re, product_im) = (product_re * x - product_im * y, product_re * y + product_im * x);
            let square = x * x + y * y;
            gap = T::select(square.less(gap), square, gap);
        }
    }
    let scale = value_re.like(1.0) / (product_re * product_re + product_im * product_im);
    let re = (value_re * product_re + value_im * product_im) * scale;
    let im = (value_im * product_re - value_re * product_im) * scale;
    Step { re, im, square: re * re + im * im, gap }
}
