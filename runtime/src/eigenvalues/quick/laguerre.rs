//! The roots of a polynomial, by Laguerre's iteration from zero and division: the smallest come first, so that division does
//! not make errors larger (Wilkinson 1963).

use super::MOST;
use crate::eigenvalues::quadratic::Pair;
use crate::eigenvalues::quartic::Quartic;
use crate::number::lane::Lane;

/// The bound on steps to a root; four or five are usual.
const STEPS: usize = 20;

/// The last step, relative to the root: what is left is about its cube, so that one correction is enough.
const CLOSE: f64 = 1e-4;

/// The imaginary part of a real root, relative to the real one, that is only what is left. A pair so close to the real axis is
/// not certain.
const REAL: f64 = 1e-5;

/// The coefficients of a polynomial and their number at most.
type Coefficients<T> = [T; 2 * MOST + 1];

/// A number, or what a polynomial is there, by its real and imaginary part.
type Complex<T> = [T; 2];

/// The real and imaginary parts of the roots of a polynomial by its coefficients, ascending, without the last one, which is one:
/// pairs next to each other, the negative imaginary part first, and two real ones next to each other. What does not converge is
/// no root.
#[inline(always)]
pub(super) fn find<T: Lane, const C: usize>(size: usize, below: &[T; C]) -> [[T; C]; 2] {
    assert!(4 <= size && size <= C && size.is_multiple_of(2));
    let (zero, one) = (below[0].like(0.0), below[0].like(1.0));
    let (two, four) = (zero.like(2.0), zero.like(4.0));
    let mut a = [zero; 2 * MOST + 1];
    a[..size].copy_from_slice(&below[..size]);
    a[size] = one;
    let mut roots = Pairs { re: [zero; C], im: [zero; C], count: zero, alone: zero, is_alone: one.less(zero) };
    // Of each lane, and of all of them at most: what a lane does depends on no other.
    let (mut degree, mut most) = (zero.like(size as f64), size);
    while most > 4 {
        let is_here = four.less(degree);
        let [x, y] = smallest(&a, most, degree, !is_here);
        let is_real = y.abs().less_or_equal(x.abs() * x.like(REAL));
        if T::all(is_here) {
            divide(&mut a, most, [x, y], is_real);
        } else {
            let before = a;
            divide(&mut a, most, [x, y], is_real);
            for k in 0..=most {
                a[k] = T::select(is_here, a[k], before[k]);
            }
        }
        roots.push_either(size / 2, is_here, is_real, [x, y.abs()]);
        degree = degree - T::select(is_here, T::select(is_real, one, two), zero);
        while most > 4 && T::all(degree.less_or_equal(zero.like((most - 1) as f64))) {
            most -= 1;
        }
    }
    // What is of the fourth degree is written down, and what is of the third with a root that is zero.
    let is_quartic = four.less_or_equal(degree);
    let [d, c, b, a] = if T::all(is_quartic) {
        [a[0], a[1], a[2], a[3]]
    } else {
        let place = |k: usize| T::select(is_quartic, a[k], if k == 0 { zero } else { a[k - 1] });
        [place(0), place(1), place(2), place(3)]
    };
    let ([large, small], _) = Quartic { a, b, c, d }.quick_factors();
    roots.push(size / 2, is_quartic | !is_quartic, large.roots());
    if !T::all(!is_quartic) {
        roots.push(size / 2, is_quartic, small.roots());
    }
    if !T::all(is_quartic) {
        roots.push_either(size / 2, !is_quartic, is_quartic | !is_quartic, [zero - small.p, zero]);
    }
    [roots.re, roots.im]
}

/// Roots two by two: so many in each lane, and a real one that has no other yet.
struct Pairs<T: Lane, const C: usize> {
    re: [T; C],
    im: [T; C],
    count: T,
    alone: T,
    is_alone: T::Mask,
}

impl<T: Lane, const C: usize> Pairs<T, C> {
    /// Adds two to the lanes of a mask.
    #[inline(always)]
    fn push(&mut self, most: usize, mask: T::Mask, Pair { re, im }: Pair<T>) {
        assert!(2 * most <= C);
        let one = self.count.like(1.0);
        for place in 0..most {
            let is_next = mask & is_equal(self.count, one.like(place as f64));
            for half in 0..2 {
                let (x, y) = (&mut self.re[2 * place + half], &mut self.im[2 * place + half]);
                (*x, *y) = (T::select(is_next, re[half], *x), T::select(is_next, im[half], *y));
            }
        }
        self.count = T::select(mask, self.count + one, self.count);
    }

    /// Adds a pair to the lanes of a mask, or a real root, which waits for another one.
    #[inline(always)]
    fn push_either(&mut self, most: usize, mask: T::Mask, is_real: T::Mask, [x, y]: Complex<T>) {
        let zero = x.like(0.0);
        let is_first = is_real & !self.is_alone;
        let y = T::select(is_real, zero, y);
        let pair = Pair { re: [T::select(is_real, self.alone, x), x], im: [zero - y, y] };
        self.push(most, mask & !is_first, pair);
        self.alone = T::select(mask & is_first, x, self.alone);
        self.is_alone = self.is_alone ^ (mask & is_real);
    }
}

/// Divides by the quadratic of a pair, or by the factor of a real root.
#[inline(always)]
fn divide<T: Lane>(a: &mut Coefficients<T>, most: usize, [x, y]: Complex<T>, is_real: T::Mask) {
    assert!(most <= 2 * MOST);
    let zero = x.like(0.0);
    let p = T::select(is_real, zero - x, zero - (x + x));
    let q = T::select(is_real, zero, x * x + y * y);
    let (mut next, mut after, mut above) = (zero, zero, a[most]);
    for k in (0..most).rev() {
        (next, after) = ((above - q * after) - p * next, next);
        // The quotient moves down by one place or two.
        (above, a[k]) = (a[k], T::select(is_real, next, after));
    }
    a[most] = zero;
}

/// A root of a polynomial near zero; in lanes that wait, nothing that counts.
#[inline(always)]
fn smallest<T: Lane>(a: &Coefficients<T>, most: usize, degree: T, mut is_there: T::Mask) -> Complex<T> {
    let (zero, close) = (degree.like(0.0), degree.like(CLOSE * CLOSE));
    let [by_x, by_y] = real_step(degree, [a[0], a[1], a[2] + a[2]]);
    let (mut x, mut y) = (zero - by_x, zero - by_y);
    for _ in 1..STEPS {
        let is_real = y.abs().less_or_equal(zero);
        let [by_x, by_y] = if T::all(!is_real | is_there) {
            step(degree, derivatives_at(a, most, x, y))
        } else {
            let real = real_step(degree, real_derivatives_at(a, most, x));
            if T::all(is_real | is_there) {
                real
            } else {
                let [by_x, by_y] = step(degree, derivatives_at(a, most, x, y));
                [T::select(is_real, real[0], by_x), T::select(is_real, real[1], by_y)]
            }
        };
        x = T::select(is_there, x, x - by_x);
        y = T::select(is_there, y, y - by_y);
        let square = x * x + y * y;
        is_there = is_there | (by_x * by_x + by_y * by_y).less_or_equal(close * square);
        // What is not a number any more stays so.
        if T::all(is_there | !zero.less_or_equal(square)) {
            break;
        }
    }
    [x, y]
}

/// Laguerre's step from a real number, which may lead off the axis.
#[inline(always)]
fn real_step<T: Lane>(n: T, [value, slope, curvature]: [T; 3]) -> Complex<T> {
    let zero = n.like(0.0);
    let less = n - n.like(1.0);
    let square = less * (less * (slope * slope) - n * (value * curvature));
    let root = square.abs().sqrt();
    let is_real = zero.less_or_equal(square);
    let re = slope + T::select(is_real, root.copysign(slope), zero);
    let im = T::select(is_real, zero, root);
    let scale = n * value / (re * re + im * im);
    [re * scale, zero - im * scale]
}

/// A polynomial and its first two derivatives at a real number.
#[inline(always)]
fn real_derivatives_at<T: Lane>(a: &Coefficients<T>, most: usize, x: T) -> [T; 3] {
    assert!(most <= 2 * MOST);
    let zero = x.like(0.0);
    let [mut value, mut slope, mut half] = [a[most], zero, zero];
    for k in (1..most).rev() {
        slope = slope * x + value;
        value = value * x + a[k];
        half = half * x + slope;
    }
    let (slope, value) = (slope * x + value, value * x + a[0]);
    [value, slope, half + half]
}

/// Laguerre's step `n f / (f' + sqrt((n - 1) ((n - 1) f'^2 - n f f'')))`, where the root is the one that does not cancel.
#[inline(always)]
fn step<T: Lane>(n: T, [value, slope, curvature]: [Complex<T>; 3]) -> Complex<T> {
    let (zero, one, half) = (n.like(0.0), n.like(1.0), n.like(0.5));
    let less = n - one;
    let (square, product) = (times(slope, slope), times(value, curvature));
    let re = less * (less * square[0] - n * product[0]);
    let im = less * (less * square[1] - n * product[1]);
    // The square of the larger part of the root: times this part everything is without a division.
    let square = half * ((re * re + im * im).sqrt() + re.abs());
    let large = T::select(square.less_or_equal(zero), one, square.sqrt());
    let (is_positive, product) = (zero.less_or_equal(re), half * im);
    let root_re = T::select(is_positive, square, product.abs());
    let root_im = T::select(is_positive, product, square.copysign(im));
    let (slope_re, slope_im) = (large * slope[0], large * slope[1]);
    let is_opposite = (root_re * slope_re + root_im * slope_im).less(zero);
    let re = slope_re + T::select(is_opposite, zero - root_re, root_re);
    let im = slope_im + T::select(is_opposite, zero - root_im, root_im);
    let scale = n * large / (re * re + im * im);
    times(value, [re * scale, zero - im * scale])
}

/// A polynomial and its first two derivatives at `x + i y`: divided by the quadratic of this number and its conjugate three
/// times over, so that all of it is real.
#[inline(always)]
fn derivatives_at<T: Lane>(a: &Coefficients<T>, most: usize, x: T, y: T) -> [Complex<T>; 3] {
    assert!(most <= 2 * MOST);
    let zero = x.like(0.0);
    let (p, q) = (zero - (x + x), x * x + y * y);
    let [mut b1, mut b2, mut c1, mut c2, mut d1, mut d2] = [zero; 6];
    for k in (4..=most).rev() {
        // What comes last is what the next one waits for.
        (b1, b2) = ((a[k] - q * b2) - p * b1, b1);
        (c1, c2) = ((b1 - q * c2) - p * c1, c1);
        (d1, d2) = ((c1 - q * d2) - p * d1, d1);
    }
    for k in [3, 2] {
        (b1, b2) = ((a[k] - q * b2) - p * b1, b1);
        (c1, c2) = ((b1 - q * c2) - p * c1, c1);
    }
    for k in [1, 0] {
        (b1, b2) = ((a[k] - q * b2) - p * b1, b1);
    }
    // The remainders there, and the derivative of the divisor, `2 i y`.
    let twice = y + y;
    let value = [b1 - x * b2, y * b2];
    let quotient = [c1 - x * c2, y * c2];
    let slope = [b2 - twice * quotient[1], twice * quotient[0]];
    let inner = [c2 - twice * (y * d2), twice * (d1 - x * d2)];
    let curvature = [quotient[0] - twice * inner[1], quotient[1] + twice * inner[0]];
    [value, slope, [curvature[0] + curvature[0], curvature[1] + curvature[1]]]
}

#[inline(always)]
fn times<T: Lane>([a, b]: Complex<T>, [c, d]: Complex<T>) -> Complex<T> {
    [a * c - b * d, a * d + b * c]
}

#[inline(always)]
fn is_equal<T: Lane>(x: T, y: T) -> T::Mask {
    x.less_or_equal(y) & y.less_or_equal(x)
}
