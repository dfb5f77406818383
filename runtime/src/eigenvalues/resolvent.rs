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

use super::quartic::{Quadratic, Quartic};
use crate::Number;
use crate::numeric::{DoubleDouble, Real};

/// The ratio of constant terms from which on it pays to compute one factor from the other.
const MUCH_SMALLER: f64 = 1.0 / 64.0;

/// By how much a double root may be off in `f64`, and a margin.
const ABOVE: f64 = 1.0 + 1e-7;

/// A quartic and its resolvent cubic, `f^3 - 3 m f - 2 n` with `y = b/3 + f`.
pub(super) struct Resolvent<T> {
    a: T,
    b: T,
    c: T,
    d: T,
    m: T,
    n: T,
    third: T,
    /// `n^2 - m^3`: positive if the cubic has one real root, negative if it has three.
    discriminant: T,
}

impl<T: Real> Resolvent<T> {
    #[inline]
    pub(super) fn new(Quartic { a, b, c, d }: Quartic) -> Self {
        let [a, b, c, d] = [a, b, c, d].map(T::from);
        let third = b / T::from(3.0);
        let e = a * c - T::from(4.0) * d;
        let m = third * third - e / T::from(3.0);
        let n = T::from(0.5) * (c * c + a * a * d - third * (e + T::from(12.0) * d - T::from(2.0) * third * third));
        Self { a, b, c, d, m, n, third, discriminant: n * n - m * m * m }
    }

    /// The two factors that belong to a root f, unless g or h is imaginary.
    #[inline]
    fn factors_at(&self, f: T) -> ([Quadratic<T>; 2], bool) {
        let &Self { a, b, c, d, third, .. } = self;
        let (zero, half) = (T::from(0.0), T::from(0.5));
        let y = third + f;
        let (half_a, half_y) = (half * a, half * y);
        let g_square = y - b + half_a * half_a;
        let h_square = half_y * half_y - d;
        let product = half * (a * half_y - c);
        // The square that cancelled less gives one of g and h; the other follows from their product.
        let y_size = third.abs() + f.abs();
        let g_size = y_size + b.abs() + half_a * half_a;
        let h_size = half_y.abs() * y_size + d.abs();
        let (g, h) = if h_square <= zero || g_square * h_size > h_square * g_size {
            let g = g_square.sqrt();
            (g, if g > zero { product / g } else { zero })
        } else {
            let h = h_square.sqrt();
            (if h > zero { product / h } else { zero }, h)
        };
        // The factor with the larger constant term first.
        let (p_large, q_large, p_small) = if h * half_y >= zero {
            (half_a + g, half_y + h, half_a - g)
        } else {
            (half_a - g, half_y - h, half_a + g)
        };
        if q_large == zero {
            return ([Quadratic { p: p_large, q: zero }, Quadratic { p: p_small, q: zero }], true);
        }
        // The smaller constant term has cancelled, and its p as well if it is much smaller; c and d have not.
        let q_small = d / q_large;
        let is_much_smaller = q_small.abs() < T::from(MUCH_SMALLER) * q_large.abs();
        let p_small = if is_much_smaller { (c - p_large * q_small) / q_large } else { p_small };
        let factors = [Quadratic { p: p_large, q: q_large }, Quadratic { p: p_small, q: q_small }];
        (factors, g_square >= zero && h_square >= zero)
    }
}

impl Resolvent<f64> {
    /// The two factors.
    #[inline]
    pub(super) fn factors(&self) -> [Quadratic; 2] {
        let &Self { m, n, discriminant, .. } = self;
        if discriminant > 0.0 {
            return self.factors_at(single_root(m, n, discriminant)).0;
        }
        if n < 0.0 {
            let (factors, are_real) = self.factors_at(-largest_root(m, -n));
            if are_real {
                return factors;
            }
        }
        self.factors_at(largest_root(m, n)).0
    }
}

impl Resolvent<DoubleDouble> {
    /// The two factors from the root that is farthest from the others, and from the largest.
    pub(super) fn factors(&self) -> [[Quadratic; 2]; 2] {
        let (m, n) = (self.m.to_f64(), self.n.to_f64());
        let discriminant = self.discriminant.to_f64();
        let outer =
            if discriminant > 0.0 { single_root(m, n, discriminant) } else { largest_root(m, n.abs()).copysign(n) };
        // Between two roots that nearly coincide the iteration may leave both; above the largest it cannot.
        [outer, largest_root(m, n) * ABOVE].map(|f| {
            let (factors, _) = self.factors_at(self.polished(f));
            factors.map(|Quadratic { p, q }| Quadratic { p: p.to_f64(), q: q.to_f64() })
        })
    }

    fn polished(&self, f: f64) -> DoubleDouble {
        // Newton's iteration at most halves the distance to a multiple root; about 50 bits are missing.
        const STEPS: usize = 60;
        let three = DoubleDouble::from(3.0);
        let mut f = DoubleDouble::from(f);
        for _ in 0..STEPS {
            let square = f * f;
            let (value, slope) = (f * (square - three * self.m) - self.n - self.n, three * (square - self.m));
            let step = value / slope;
            // Where the slope is zero the step may not be a number, which is not larger either.
            if step.abs().to_f64() > f.abs().to_f64() * f64::EPSILON * f64::EPSILON {
                f = f - step;
            } else {
                break;
            }
        }
        f
    }
}

/// The only real root of `f^3 - 3 m f - 2 n`, for a positive discriminant.
#[inline]
fn single_root(m: f64, n: f64, discriminant: f64) -> f64 {
    // A sum of two terms whose product is m; where their signs differ they would cancel.
    let cube = n.abs() + Number::sqrt(discriminant);
    let reciprocal = inverse_cube_root(cube);
    let (large, small) = (cube * reciprocal * reciprocal, m * reciprocal);
    let f = if m > 0.0 { large + small } else { 2.0 * n.abs() / (large * large - m + small * small) };
    f.copysign(n)
}

/// The largest of the three real roots of `f^3 - 3 m f - 2 n`, for a discriminant that is not positive.
#[inline]
fn largest_root(m: f64, n: f64) -> f64 {
    if m <= 0.0 {
        return 0.0;
    }
    let root = Number::sqrt(m);
    let cosine = (n / (m * root)).clamp(-1.0, 1.0);
    2.0 * root * (0.5 + third_of_angle(0.5 + 0.5 * cosine))
}

/// `x^(-1/3)` for a positive normal number, to a few units in the last place and without a division: several times faster
/// than a correctly rounded cube root, of which nothing would be left in the end.
#[inline]
fn inverse_cube_root(x: f64) -> f64 {
    // A third of the exponent, and a linear approximation of the mantissa that is right to 4 %.
    const LINEAR: u64 = 0x553e_f0ff_289d_d796;
    let mut root = f64::from_bits(LINEAR - x.to_bits() / 3);
    // The error becomes its fourth power with each step.
    for _ in 0..2 {
        let h = 1.0 - x * root * (root * root);
        root += root * h * ((1.0 / 3.0 + h * (2.0 / 9.0)) + h * h * (14.0 / 81.0));
    }
    root
}

/// `cos(acos(2 x - 1) / 3) - 1/2` for x in [0, 1].
///
/// It is the root u of `u^2 (1 + 2/3 u) = x/3`, without the cancellation of the cosine near x = 0: a polynomial in
/// `sqrt(x/3)` to six digits and one step of Halley's iteration.
#[inline]
fn third_of_angle(x: f64) -> f64 {
    let square = x / 3.0;
    let w = Number::sqrt(square);
    let series = (0.999_998_25 - 0.333_113_36 * w)
        + square * (0.273_085_70 - 0.257_508_55 * w)
        + square * square * (0.195_737_48 - 0.075_921_859 * w);
    let u = w * series;
    let value = u * u * (1.0 + 2.0 / 3.0 * u) - square;
    let (slope, half_curvature) = (2.0 * u * (1.0 + u), 1.0 + 2.0 * u);
    let divisor = slope * slope - value * half_curvature;
    if divisor > 0.0 { u - value * slope / divisor } else { u }
}
