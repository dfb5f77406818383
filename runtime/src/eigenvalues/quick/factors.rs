//! The quadratic factors of a polynomial, by Bairstow's iteration and division, and of the quartic that is left.

use crate::eigenvalues::quadratic::Quadratic;
use crate::eigenvalues::quartic::Quartic;
use crate::number::lane::Lane;

/// The bound on steps from each start; five to ten are usual.
const STEPS: usize = 16;

/// The last step, relative to the factor: what is left is its square.
const CLOSE: f64 = 1e-6;

/// The factors of a polynomial by its coefficients, ascending, without the last one, which is one. What does not converge is no
/// factor.
#[inline(always)]
pub(super) fn find<T: Lane, const C: usize>(size: usize, mut a: [T; C]) -> [Quadratic<T>; C] {
    assert!(4 <= size && size <= C && size.is_multiple_of(2));
    let (zero, one) = (a[0].like(0.0), a[0].like(1.0));
    let mut factors = [Quadratic { p: zero, q: zero }; C];
    let mut degree = size;
    while degree > 4 {
        let factor = find_one(degree, &a);
        let Quadratic { p, q } = factor;
        let (mut next, mut after) = (one, zero);
        for k in (2..degree).rev() {
            (next, after) = ((a[k] - q * after) - p * next, next);
            a[k] = after;
        }
        // The quotient has moved up by two places, but for its last coefficient.
        a[1] = next;
        for k in 0..degree - 2 {
            a[k] = a[k + 1];
        }
        factors[degree / 2 - 1] = factor;
        degree -= 2;
    }
    let quartic = Quartic { a: a[3], b: a[2], c: a[1], d: a[0] };
    ([factors[0], factors[1]], _) = quartic.quick_factors();
    factors
}

/// A factor of a polynomial of degree six or more.
#[inline(always)]
fn find_one<T: Lane, const C: usize>(degree: usize, a: &[T; C]) -> Quadratic<T> {
    let (zero, one) = (a[0].like(0.0), a[0].like(1.0));
    // The smallest roots come first: so division does not make errors larger. This has them where the others are far.
    let scale = one / a[2];
    let mut factor = Quadratic { p: a[1] * scale, q: a[0] * scale };
    let mut has_converged = bairstow(degree, a, &mut factor, one.less(zero));
    if T::all(has_converged) {
        return factor;
    }
    // About as small, and then as far away as possible.
    let (two, four) = ((a[0] * scale).abs(), (a[0] / a[4]).abs().sqrt());
    let q = T::select(two.less(four), two, four);
    let starts = [
        Quadratic { p: q.sqrt(), q },
        Quadratic { p: zero, q: q * q.like(4.0) },
        Quadratic { p: a[degree - 1], q: a[degree - 2] },
    ];
    for start in starts {
        let mut other = Quadratic::select(has_converged, factor, start);
        has_converged = bairstow(degree, a, &mut other, has_converged);
        factor = other;
        if T::all(has_converged) {
            break;
        }
    }
    factor
}

/// Moves what is no factor yet to one nearby, where there is any.
#[inline(always)]
fn bairstow<T: Lane, const C: usize>(
    degree: usize,
    a: &[T; C],
    factor: &mut Quadratic<T>,
    mut has_converged: T::Mask,
) -> T::Mask {
    let Quadratic { mut p, mut q } = *factor;
    let (zero, one, close) = (p.like(0.0), p.like(1.0), p.like(CLOSE));
    for _ in 0..STEPS {
        // Divided by x^2 + p x + q twice.
        let [mut b1, mut b2, mut c1, mut c2, mut c3] = [one, zero, one, zero, zero];
        for k in (1..degree).rev() {
            // What comes last is what the next one waits for.
            (b1, b2) = ((a[k] - q * b2) - p * b1, b1);
            (c1, c2, c3) = ((b1 - q * c2) - p * c1, c1, c2);
        }
        let b0 = (a[0] - q * b2) - p * b1;
        let scale = one / (c2 * c2 - c1 * c3);
        let (by_p, by_q) = ((b1 * c2 - b0 * c3) * scale, (b0 * c2 - b1 * c1) * scale);
        p = T::select(has_converged, p, p + by_p);
        q = T::select(has_converged, q, q + by_q);
        let size = p.abs() + q.abs().sqrt();
        let is_close = by_p.abs().less_or_equal(close * size) & by_q.abs().less_or_equal(close * size * size);
        has_converged = has_converged | is_close;
        // What is not a number any more stays so.
        if T::all(has_converged | !zero.less_or_equal(size)) {
            break;
        }
    }
    *factor = Quadratic { p, q };
    has_converged
}
