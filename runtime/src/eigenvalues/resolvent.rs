//! The resolvent cubic of a quartic, and the two quadratic factors that follow from its largest root.
//!
//! With the factors `x^2 + (a/2 + g) x + (y/2 + h)` and `x^2 + (a/2 - g) x + (y/2 - h)` of the quartic
//! `x^4 + a x^3 + b x^2 + c x + d`,
//!
//! ```text
//! g^2 = y - b + a^2/4    h^2 = y^2/4 - d    2 g h = a y/2 - c
//! ```
//!
//! so that y is a root of `y^3 - b y^2 + (a c - 4 d) y - (c^2 + a^2 d - 4 b d)`. For the largest real one g and h are real.

use super::quartic::{Quadratic, Quartic};
use crate::Scalar;
use crate::numeric::{DoubleDouble, Real};

/// A quartic and the largest real root y of its resolvent cubic.
pub(super) struct Resolvent<T> {
    a: T,
    b: T,
    c: T,
    d: T,
    y: T,
}

impl Resolvent<f64> {
    #[inline]
    pub(super) fn new(Quartic { a, b, c, d }: Quartic) -> Self {
        let (third, m, n) = depressed(a, b, c, d);
        Self { a, b, c, d, y: third + largest_root(m, n, n * n - m * m * m) }
    }
}

impl Resolvent<DoubleDouble> {
    pub(super) fn new(Quartic { a, b, c, d }: Quartic) -> Self {
        // Newton's iteration at most halves the distance to a multiple root; about 50 bits are missing.
        const STEPS: usize = 60;
        let [a, b, c, d] = [a, b, c, d].map(DoubleDouble::from);
        let (third, m, n) = depressed(a, b, c, d);
        let three = DoubleDouble::from(3.0);
        let discriminant = n * n - m * m * m;
        let mut f = DoubleDouble::from(largest_root(m.to_f64(), n.to_f64(), discriminant.to_f64()));
        for _ in 0..STEPS {
            let square = f * f;
            let (value, slope) = (f * (square - three * m) - n - n, three * (square - m));
            let step = value / slope;
            // Also stops at what is not a number, where the slope is zero.
            if !(step.abs().to_f64() > f.abs().to_f64() * f64::EPSILON * f64::EPSILON) {
                break;
            }
            f = f - step;
        }
        Self { a, b, c, d, y: third + f }
    }
}

impl<T: Real> Resolvent<T> {
    /// The two factors.
    #[inline]
    pub(super) fn factors(self) -> [Quadratic<T>; 2] {
        let Self { a, b, c, d, y } = self;
        let (zero, half) = (T::from(0.0), T::from(0.5));
        let (half_a, half_y) = (half * a, half * y);
        let g_square = y - b + half_a * half_a;
        let h_square = half_y * half_y - d;
        let product = half * (a * half_y - c);
        // The square that cancelled less gives one of g and h; the other follows from their product.
        let g_size = y.abs() + b.abs() + half_a * half_a;
        let h_size = half_y * half_y + d.abs();
        let (g, h) = if g_square * h_size >= h_square * g_size {
            let g = g_square.sqrt();
            (g, if g > zero { product / g } else { zero })
        } else {
            let h = h_square.sqrt();
            (if h > zero { product / h } else { zero }, h)
        };
        let (mut q0, mut q1) = (half_y + h, half_y - h);
        // The smaller one has cancelled; their product has not.
        if q0.abs() >= q1.abs() {
            q1 = if q0 == zero { zero } else { d / q0 };
        } else {
            q0 = d / q1;
        }
        [Quadratic { p: half_a + g, q: q0 }, Quadratic { p: half_a - g, q: q1 }]
    }
}

/// b/3, m and n that make the cubic `f^3 - 3 m f - 2 n` with `y = b/3 + f`.
#[inline]
fn depressed<T: Real>(a: T, b: T, c: T, d: T) -> (T, T, T) {
    let (half, two, three, four, twelve) = (T::from(0.5), T::from(2.0), T::from(3.0), T::from(4.0), T::from(12.0));
    let third = b / three;
    let e = a * c - four * d;
    let m = third * third - e / three;
    let n = half * (c * c + a * a * d - third * (e + twelve * d - two * third * third));
    (third, m, n)
}

/// The largest real root of `f^3 - 3 m f - 2 n`, with the discriminant `n^2 - m^3`.
#[inline]
fn largest_root(m: f64, n: f64, discriminant: f64) -> f64 {
    if discriminant > 0.0 {
        // One real root, of two terms whose product is m; where their signs differ they would cancel.
        let large = libm::cbrt(n.abs() + Scalar::sqrt(discriminant));
        let small = m / large;
        let f = if m > 0.0 { large + small } else { 2.0 * n.abs() / (large * large - m + small * small) };
        f.copysign(n)
    } else if m > 0.0 {
        let root = Scalar::sqrt(m);
        let cosine = (n / (m * root)).clamp(-1.0, 1.0);
        2.0 * root * (0.5 + third_of_angle(0.5 + 0.5 * cosine))
    } else {
        0.0
    }
}

/// `cos(acos(2 x - 1) / 3) - 1/2` for x in [0, 1].
///
/// It is the root u of `u^2 (1 + 2/3 u) = x/3`, without the cancellation of the cosine near x = 0: a polynomial in
/// `sqrt(x/3)` to six digits and one step of Halley's iteration.
#[inline]
fn third_of_angle(x: f64) -> f64 {
    let square = x / 3.0;
    let w = Scalar::sqrt(square);
    let series = (0.999_998_25 - 0.333_113_36 * w)
        + square * (0.273_085_70 - 0.257_508_55 * w)
        + square * square * (0.195_737_48 - 0.075_921_859 * w);
    let u = w * series;
    let value = u * u * (1.0 + 2.0 / 3.0 * u) - square;
    let (slope, half_curvature) = (2.0 * u * (1.0 + u), 1.0 + 2.0 * u);
    let divisor = slope * slope - value * half_curvature;
    if divisor > 0.0 { u - value * slope / divisor } else { u }
}
