//! The resolvent cubic of a quartic, and the two quadratic factors that follow from its largest root.
//!
//! With the factors `x^2 + (a/2 + g) x + (y/2 + h)` and `x^2 + (a/2 - g) x + (y/2 - h)` of the quartic
//! `x^4 + a x^3 + b x^2 + c x + d`,
//!
//! ```text
//! g^2 = y - b + a^2/4    h^2 = y^2/4 - d    2 g h = a y/2 - c
//! ```
//!
//! so that y is a root of `y^3 - b y^2 + (a c - 4 d) y - (c^2 + a^2 d - 4 b d)`. The largest real root gives real g and h.
//! So does the smallest of three, if all roots of the quartic are real; it is the better one where the other two nearly
//! coincide.

use super::factors::Precision;
use super::quadratic::Quadratic;
use super::quartic::Quartic;
use crate::number::lane::Lane;
use crate::number::real::Real;
use crate::numeric::DoubleDouble;

/// The ratio of constant terms from which on it pays to compute one factor from the other.
const MUCH_SMALLER: f64 = 1.0 / 64.0;

/// A quartic and its resolvent cubic, `f^3 - 3 m f - 2 n` with `y = b/3 + f`.
pub(super) struct Resolvent<T> {
    quartic: Quartic<T>,
    m: T,
    n: T,
    third: T,
    /// `n^2 - m^3`: positive if the cubic has one real root, negative if it has three.
    discriminant: T,
}

impl<T: Real> Resolvent<T> {
    #[inline(always)]
    pub(super) fn new(quartic: Quartic<T>) -> Self {
        let Quartic { a, b, c, d } = quartic;
        let constant = |value| a.like(value);
        let one_third = constant(1.0) / constant(3.0);
        let third = b * one_third;
        let e = a * c - constant(4.0) * d;
        let m = third * third - e * one_third;
        let n = constant(0.5) * (c * c + a * a * d - third * (e + constant(12.0) * d - constant(2.0) * third * third));
        Self { quartic, m, n, third, discriminant: n * n - m * m * m }
    }

    /// The two factors that belong to a root f, the one with the larger constant term first; and whether g and h are real.
    #[inline(always)]
    fn factors_at(&self, f: T) -> ([Quadratic<T>; 2], T::Mask) {
        let &Self { quartic: Quartic { a, b, c, d }, third, .. } = self;
        let (zero, half) = (f.like(0.0), f.like(0.5));
        let y = third + f;
        let (half_a, half_y) = (half * a, half * y);
        let g_square = y - b + half_a * half_a;
        let h_square = half_y * half_y - d;
        let product = half * (a * half_y - c);
        // The square that cancelled less gives one of g and h; the other follows from their product.
        let y_size = third.abs() + f.abs();
        let g_size = y_size + b.abs() + half_a * half_a;
        let h_size = half_y.abs() * y_size + d.abs();
        let is_h_better = !h_square.less_or_equal(zero) & (g_square * h_size).less_or_equal(h_square * g_size);
        let root = T::select(is_h_better, h_square, g_square).sqrt_or_zero();
        let other = T::select(root.less_or_equal(zero), zero, product / root);
        let (g, h) = (T::select(is_h_better, other, root), T::select(is_h_better, root, other));
        let is_plus_larger = zero.less_or_equal(h * half_y);
        let (g, h) = (T::select(is_plus_larger, g, -g), T::select(is_plus_larger, h, -h));
        let (p_large, q_large, p_small) = (half_a + g, half_y + h, half_a - g);
        // The smaller constant term has cancelled, and its p as well if it is much smaller; c and d have not.
        let inverse = f.like(1.0) / q_large;
        let q_small = d * inverse;
        let is_much_smaller = q_small.abs().less_or_equal(f.like(MUCH_SMALLER) * q_large.abs());
        let p_small = T::select(is_much_smaller, (c - p_large * q_small) * inverse, p_small);
        // Both are zero if the larger one is.
        let is_zero = q_large.abs().less_or_equal(zero);
        let small = Quadratic { p: T::select(is_zero, half_a - g, p_small), q: T::select(is_zero, zero, q_small) };
        ([Quadratic { p: p_large, q: q_large }, small], zero.less_or_equal(g_square) & zero.less_or_equal(h_square))
    }
}

impl<T: Lane> Resolvent<T> {
    /// The two factors.
    #[inline(always)]
    pub(super) fn factors(&self) -> [Quadratic<T>; 2] {
        let &Self { m, n, discriminant, .. } = self;
        let zero = m.like(0.0);
        let has_three = discriminant.less_or_equal(zero);
        // What no lane needs is left out.
        let single = if T::all(has_three) { zero } else { single_root(m, n.abs(), discriminant) };
        let outer = if T::all(!has_three) { zero } else { outer_root(m, n.abs()) };
        let f = T::select(has_three, outer, single).copysign(n);
        let (factors, is_real) = self.factors_at(f);
        // Of three, the smallest may belong to imaginary factors; the largest does not.
        let is_wrong = has_three & n.less(zero) & !is_real;
        if T::all(!is_wrong) {
            return factors;
        }
        let largest = largest_root(m, n);
        self.factors_at(T::select(is_wrong, largest, f)).0
    }
}

impl<T: Precision> Resolvent<DoubleDouble<T>> {
    /// The two factors from the root that is farthest from the others, and from the largest.
    pub(super) fn factors(&self) -> [[Quadratic<T>; 2]; 2] {
        let (m, n) = (self.m.high(), self.n.high());
        let (discriminant, magnitude) = (self.discriminant.high(), Real::abs(n));
        let size =
            if discriminant > T::ZERO { single_root(m, magnitude, discriminant) } else { outer_root(m, magnitude) };
        // Between two roots that nearly coincide the iteration may leave both; above the largest it cannot.
        [size.copysign(n), largest_root(m, n) * T::ABOVE].map(|f| {
            let (factors, _) = self.factors_at(self.polished(f));
            factors.map(|Quadratic { p, q }| Quadratic { p: p.high(), q: q.high() })
        })
    }

    fn polished(&self, f: T) -> DoubleDouble<T> {
        // Newton's iteration at most halves the distance to a multiple root; about half of the bits are missing.
        const STEPS: usize = 60;
        let three = DoubleDouble::from(T::from_f64(3.0));
        let epsilon = T::from_f64(<T as Lane>::EPSILON);
        let mut f = DoubleDouble::from(f);
        let mut before = T::from_f64(f64::INFINITY);
        for _ in 0..STEPS {
            let square = f * f;
            let (value, slope) = (f * (square - three * self.m) - self.n - self.n, three * (square - self.m));
            let step = value / slope;
            let size = Real::abs(step).high();
            // A step that is not shorter than the one before is noise: it could lead anywhere. Where the slope is zero it may
            // not be a number, which is not shorter either.
            if size < before && size > Real::abs(f).high() * epsilon * epsilon {
                (f, before) = (f - step, size);
            } else {
                break;
            }
        }
        f
    }
}

/// The magnitude of the only real root of `f^3 - 3 m f - 2 n`, for a positive discriminant, from that of n.
#[inline(always)]
fn single_root<T: Lane>(m: T, n: T, discriminant: T) -> T {
    // A sum of two terms whose product is m; where their signs differ they would cancel.
    let cube = n + discriminant.sqrt_or_zero();
    let reciprocal = inverse_cube_root(cube);
    let (large, small) = (cube * reciprocal * reciprocal, m * reciprocal);
    let is_sum = m.like(0.0).less(m);
    if T::all(is_sum) {
        return large + small;
    }
    T::select(is_sum, large + small, (n + n) / (large * large - m + small * small))
}

/// The largest magnitude of the three real roots of `f^3 - 3 m f - 2 n`, for a discriminant that is not positive, from
/// the magnitude of n.
#[inline(always)]
fn outer_root<T: Lane>(m: T, n: T) -> T {
    let zero = m.like(0.0);
    let root = m.sqrt_or_zero();
    let cosine = n / (m * root);
    // Rounding may leave it a little above one.
    let cosine = T::select(cosine.less(m.like(1.0)), cosine, m.like(1.0));
    T::select(zero.less(m), root * twice_cosine_of_third(cosine), zero)
}

/// The largest of the three real roots of `f^3 - 3 m f - 2 n`, for a discriminant that is not positive.
#[inline(always)]
fn largest_root<T: Lane>(m: T, n: T) -> T {
    let constant = |value| m.like(value);
    let root = m.sqrt_or_zero();
    let cosine = n / (m * root);
    let cosine = T::select(cosine.less(constant(1.0)), cosine, constant(1.0));
    let cosine = T::select(constant(-1.0).less(cosine), cosine, constant(-1.0));
    let half_cosine = constant(0.5) + third_of_angle(constant(0.5) + constant(0.5) * cosine);
    T::select(constant(0.0).less(m), (root + root) * half_cosine, constant(0.0))
}

/// `cos(acos(2 x - 1) / 3) - 1/2` for x in [0, 1].
///
/// It is the root u of `u^2 (1 + 2/3 u) = x/3`, without the cancellation of the cosine near x = 0: a polynomial in
/// `sqrt(x/3)` to six digits and one step of Halley's iteration.
#[inline(always)]
fn third_of_angle<T: Lane>(x: T) -> T {
    let constant = |value| x.like(value);
    let square = x * constant(1.0 / 3.0);
    let w = square.sqrt();
    let series = (constant(0.999_998_25) - constant(0.333_113_36) * w)
        + square * (constant(0.273_085_70) - constant(0.257_508_55) * w)
        + square * square * (constant(0.195_737_48) - constant(0.075_921_859) * w);
    let u = w * series;
    let value = u * u * (constant(1.0) + constant(2.0 / 3.0) * u) - square;
    let (slope, half_curvature) = (constant(2.0) * u * (constant(1.0) + u), constant(1.0) + constant(2.0) * u);
    let divisor = slope * slope - value * half_curvature;
    T::select(constant(0.0).less(divisor), u - value * slope / divisor, u)
}

/// `x^(-1/3)` for a positive normal number, to a few units in the last place and without a division: several times faster
/// than a correctly rounded cube root, of which nothing would be left in the end.
#[inline(always)]
fn inverse_cube_root<T: Lane>(x: T) -> T {
    let constant = |value| x.like(value);
    let mut root = x.estimate_inverse_cube_root();
    // The error becomes its fourth power with each step.
    for _ in 0..2 {
        let h = constant(1.0) - x * root * (root * root);
        let series = (constant(1.0 / 3.0) + h * constant(2.0 / 9.0)) + h * h * constant(14.0 / 81.0);
        root = root + root * h * series;
    }
    root
}

/// `2 cos(acos(x) / 3)` for x in [0, 1], to 1e-14: its interpolant of degree 15 in the Chebyshev points.
#[inline(always)]
fn twice_cosine_of_third<T: Lane>(x: T) -> T {
    const COEFFICIENTS: [[f64; 2]; 8] = [
        [1.879_385_241_571_821_5, 0.131_643_614_544_898_06],
        [-0.012_862_827_975_927_013, 0.002_213_309_911_858_552_8],
        [-0.000_467_290_546_299_206_64, 0.000_109_828_833_415_630_47],
        [-2.758_265_608_623_184e-5, 7.246_609_674_858_31e-6],
        [-1.966_688_741_632_738_6e-6, 5.472_349_971_500_674e-7],
        [-1.561_011_416_816_043e-7, 4.500_095_673_460_225e-8],
        [-1.214_350_511_363_463_2e-8, 3.574_336_647_800_619e-9],
        [-1.675_676_757_722_238_2e-9, 5.054_221_440_171_932e-10],
    ];
    let t = (x + x) - x.like(1.0);
    // In pairs, pairs of pairs and so on: the additions do not wait for each other.
    let t2 = t * t;
    let (t4, t8) = (t2 * t2, t2 * t2 * (t2 * t2));
    let [a, b, c, d, e, f, g, h] = COEFFICIENTS;
    let [a, b, c, d] = [linear(a, t), linear(b, t), linear(c, t), linear(d, t)];
    let [e, f, g, h] = [linear(e, t), linear(f, t), linear(g, t), linear(h, t)];
    (a + b * t2 + (c + d * t2) * t4) + (e + f * t2 + (g + h * t2) * t4) * t8
}

/// `a + b t`, with constants.
#[inline(always)]
fn linear<T: Lane>([a, b]: [f64; 2], t: T) -> T {
    t.like(a) + t.like(b) * t
}
