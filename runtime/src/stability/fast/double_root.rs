//! The double eigenvalue near a root of the discriminant.

use super::even::{Even, Square};
use crate::numeric::{DoubleDouble, Sum};

pub(super) struct DoubleRoot {
    pub(super) square: Square,
    /// An estimate of the error of the square of the speed.
    pub(super) error: f64,
    /// The eigenvalue divided by the speed.
    pub(super) sigma: f64,
    pub(super) sigma_rest: f64,
    /// Whether two real eigenvalues become a pair.
    pub(super) merges: bool,
}

/// With s = v sigma the characteristic polynomial is `a(sigma) u^2 + b(sigma) u + p_00`.
struct Terms<T> {
    a: [T; 5],
    b: [T; 3],
    c: T,
}

impl Terms<Sum> {
    fn new(even: &Even) -> Self {
        let Even { p0, p1, p2, p3, p4 } = even;
        Self { a: [p0[2], p1[1], p2[1], *p3, *p4], b: [p0[1], p1[0], p2[0]], c: p0[0] }
    }

    fn map<T>(&self, f: impl Fn(Sum) -> T) -> Terms<T> {
        Terms { a: self.a.map(&f), b: self.b.map(&f), c: f(self.c) }
    }
}

pub(super) struct DoubleRoots {
    exact: Terms<DoubleDouble>,
    value: Terms<f64>,
    size: Terms<f64>,
}

/// The least of derivatives that are not nearly zero, relative to their terms.
const SAFE: f64 = 1.0 / (1u64 << 24) as f64;

impl DoubleRoots {
    pub(super) fn new(even: &Even) -> Self {
        let terms = Terms::new(even);
        Self {
            exact: terms.map(|sum| sum.value),
            value: terms.map(|sum| sum.value.to_f64()),
            size: terms.map(|sum| sum.size),
        }
    }

    pub(super) fn near(&self, u: f64) -> Option<DoubleRoot> {
        let sigma = self.double(u);
        // Newton's iteration for p = p_sigma = 0: one step in f64, one with residuals in double-double.
        let at = derivatives(&self.value, sigma, u);
        let (du, ds) = step([at.p, at.slope], &at);
        let (u, sigma) = (u + du, sigma + ds);
        let at = derivatives(&self.value, sigma, u);
        let (dv, dt) = step(self.residuals(sigma, u), &at);
        let size = derivatives(&self.size, sigma.abs(), u);
        let safe = at.by_u.abs() > SAFE * size.by_u && at.curvature.abs() > SAFE * size.curvature;
        let error = f64::EPSILON * size.p / at.by_u.abs();
        // What the last step leaves.
        let left = (size.curvature * dt * dt + (size.by_u / u) * dv * dv) / at.by_u.abs();
        let is_close = du.abs() <= CLOSE * u && ds.abs() <= CLOSE * sigma.abs() && left <= NEGLIGIBLE * u;
        (safe && is_close).then_some(DoubleRoot {
            square: Square { u, rest: dv },
            error,
            sigma,
            sigma_rest: dt,
            merges: (at.by_u > 0.0) == (at.curvature > 0.0),
        })
    }

    /// The double root in sigma at u, if there is one: of the remainder of degree one of p and its derivative.
    fn double(&self, u: f64) -> f64 {
        let Terms { a: [a0, a1, a2, a3, a4], b: [b0, b1, b2], c } = self.value;
        let (a, b, c, d, e) = (a4 * u, a3 * u, a2 * u + b2, a1 * u + b1, (a0 * u + b0) + c / u);
        let (q2, q1, q0) = (8.0 * a * c - 3.0 * b * b, 12.0 * a * d - 2.0 * b * c, 16.0 * a * e - b * d);
        let constant = 4.0 * a * q1 * q0 + q2 * (q2 * d - 3.0 * b * q0);
        let linear = 4.0 * a * (q1 * q1 - q0 * q2) + q2 * (2.0 * c * q2 - 3.0 * b * q1);
        -constant / linear
    }

    /// p and p_sigma in double-double, rounded.
    fn residuals(&self, sigma: f64, u: f64) -> [f64; 2] {
        let Terms { a, b, c } = &self.exact;
        let mut value = a[4];
        let mut slope = a[4];
        value = value.times(sigma).add_roughly(a[3]);
        for i in (0..3).rev() {
            slope = slope.times(sigma).add_roughly(value);
            value = value.times(sigma).add_roughly(a[i]);
        }
        let b_slope = b[2].times(sigma).add_roughly(b[1]);
        let b_value = b_slope.times(sigma).add_roughly(b[0]);
        let b_slope = b[2].times(sigma).add_roughly(b_slope);
        let p = value.times(u).add_roughly(b_value).times(u).add_roughly(*c);
        let slope = slope.times(u).add_roughly(b_slope).times(u).to_f64();
        [p.to_f64(), slope]
    }
}

const CLOSE: f64 = 1.0 / (1u64 << 14) as f64;
const NEGLIGIBLE: f64 = 1.0 / (1u64 << 57) as f64;

/// The polynomial and its derivatives.
struct Derivatives {
    p: f64,
    slope: f64,
    curvature: f64,
    by_u: f64,
    slope_by_u: f64,
}

#[inline]
fn derivatives(terms: &Terms<f64>, sigma: f64, u: f64) -> Derivatives {
    let Terms { a, b, c } = terms;
    let a0 = (((a[4] * sigma + a[3]) * sigma + a[2]) * sigma + a[1]) * sigma + a[0];
    let a1 = ((4.0 * a[4] * sigma + 3.0 * a[3]) * sigma + 2.0 * a[2]) * sigma + a[1];
    let a2 = (12.0 * a[4] * sigma + 6.0 * a[3]) * sigma + 2.0 * a[2];
    let b0 = (b[2] * sigma + b[1]) * sigma + b[0];
    let b1 = 2.0 * b[2] * sigma + b[1];
    let b2 = 2.0 * b[2];
    Derivatives {
        p: (a0 * u + b0) * u + c,
        slope: (a1 * u + b1) * u,
        curvature: (a2 * u + b2) * u,
        by_u: 2.0 * a0 * u + b0,
        slope_by_u: 2.0 * a1 * u + b1,
    }
}

/// The steps of u and sigma.
#[inline]
fn step([p, slope]: [f64; 2], at: &Derivatives) -> (f64, f64) {
    let scale = 1.0 / (at.by_u * at.curvature - slope * at.slope_by_u);
    ((slope * slope - p * at.curvature) * scale, (p * at.slope_by_u - slope * at.by_u) * scale)
}
