//! The roots of a quartic with real coefficients, as two quadratic factors.
//!
//! The factors are polished together, so that not only each root but all of them jointly belong to a quartic close to
//! the given one: roots polished one by one drift apart where they nearly coincide.

use super::resolvent::Resolvent;
use crate::numeric::{DoubleDouble, exponent, ldexp};
use crate::{Complex, Scalar};

/// The error of the factors, as [`Quartic::polish`] measures it, that is no more than rounding.
const TOLERANCE: f64 = 8.0 * f64::EPSILON;

/// A monic quartic `x^4 + a x^3 + b x^2 + c x + d`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Quartic {
    pub(crate) a: f64,
    pub(crate) b: f64,
    pub(crate) c: f64,
    pub(crate) d: f64,
}

/// A monic quadratic `x^2 + p x + q`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Quadratic<T = f64> {
    pub(super) p: T,
    pub(super) q: T,
}

impl Quartic {
    /// The four roots: in each half two real ones, ascending, or a conjugate pair, the negative imaginary part first.
    ///
    /// Real roots have an imaginary part of exactly zero and pairs are exactly conjugate. Finite if the coefficients are,
    /// unless a root itself overflows.
    pub(crate) fn roots(self) -> [[Complex<f64>; 2]; 2] {
        let Self { a, b, c, d } = self;
        let largest = a.abs().max(b.abs()).max(c.abs()).max(d.abs());
        // Within these limits no intermediate result over- or underflows.
        if (1e-12..1e12).contains(&largest) {
            return self.factors().map(Quadratic::roots);
        }
        let unit = self.unit();
        let [a, b, c, d] = [(a, -unit), (b, -2 * unit), (c, -3 * unit), (d, -4 * unit)].map(|(x, e)| ldexp(x, e));
        let unscale = |root: Complex<f64>| Complex::new(ldexp(root.re, unit), ldexp(root.im, unit));
        Self { a, b, c, d }.factors().map(|factor| factor.roots().map(unscale))
    }

    /// The exponent of a power of two that is about the size of the largest root.
    #[cold]
    fn unit(self) -> i32 {
        let degrees = [(self.a, 1), (self.b, 2), (self.c, 3), (self.d, 4)];
        let units = degrees.map(|(x, degree)| exponent(x).map(|e| e.div_euclid(degree) + 1));
        units.into_iter().flatten().max().unwrap_or(0)
    }

    /// Two quadratic factors with real coefficients.
    #[inline]
    fn factors(self) -> [Quadratic; 2] {
        let (factors, error) = self.polish(Resolvent::<f64>::new(self).factors());
        if error <= TOLERANCE { factors } else { self.careful_factors(factors, error) }
    }

    /// The factors where `f64` is not enough: close to three or four equal roots, or with roots of very different size.
    #[cold]
    fn careful_factors(self, mut factors: [Quadratic; 2], mut error: f64) -> [Quadratic; 2] {
        for candidate in Resolvent::<DoubleDouble>::new(self).factors() {
            let (candidate, candidate_error) = self.polish(candidate);
            if candidate_error < error {
                (factors, error) = (candidate, candidate_error);
            }
        }
        factors
    }

    /// Newton's iteration for both factors at once, as long as it brings their product closer to the quartic.
    #[inline]
    fn polish(self, mut factors: [Quadratic; 2]) -> ([Quadratic; 2], f64) {
        const STEPS: usize = 6;
        let (mut residual, mut error) = self.residual(factors);
        for _ in 0..STEPS {
            if error <= 2.0 * f64::EPSILON {
                break;
            }
            let next = newton(factors, residual);
            let (next_residual, next_error) = self.residual(next);
            // Also stops at what is not a number, from factors with a root in common.
            if !(next_error < error) {
                break;
            }
            (factors, residual, error) = (next, next_residual, next_error);
        }
        (factors, error)
    }

    /// The coefficients of the quartic less those of the product of the factors, and the sum of their magnitudes, each
    /// relative to the size of the terms that it has in the roots.
    #[inline]
    fn residual(self, [s, t]: [Quadratic; 2]) -> ([f64; 4], f64) {
        let residual =
            [self.a - s.p - t.p, self.b - s.q - t.q - s.p * t.p, self.c - s.p * t.q - t.p * s.q, self.d - s.q * t.q];
        // Two roots may sum to zero, but then their size is not.
        let (sp, tp) = (s.p.abs() + Scalar::sqrt(s.q.abs()), t.p.abs() + Scalar::sqrt(t.q.abs()));
        let (sq, tq) = (s.q.abs(), t.q.abs());
        let size = [sp + tp, sq + tq + sp * tp, sp * tq + tp * sq, sq * tq];
        let term = |i: usize| residual[i].abs() / (size[i] + f64::MIN_POSITIVE);
        (residual, (term(0) + term(1)) + (term(2) + term(3)))
    }
}

/// The factors moved so that, to first order, their product changes by `residual`.
#[inline]
fn newton([s, t]: [Quadratic; 2], [ra, rb, rc, rd]: [f64; 4]) -> [Quadratic; 2] {
    let (dp, dq) = (t.p - s.p, t.q - s.q);
    // With the change of t.p and t.q eliminated, two equations are left for that of s.p and s.q.
    let slope = dq - s.p * dp;
    let rest = rb - s.p * ra;
    let e = rc - s.q * ra - s.p * rest;
    let f = rd - s.q * rest;
    // The resultant: zero if the factors have a root in common.
    let resultant = slope * dq + s.q * dp * dp;
    let p = (e * dq - f * dp) / resultant;
    let q = (slope * f + s.q * dp * e) / resultant;
    let first = Quadratic { p: s.p + p, q: s.q + q };
    [first, Quadratic { p: t.p + (ra - p), q: t.q + (rest - q - dp * p) }]
}

impl Quadratic {
    #[inline]
    fn roots(self) -> [Complex<f64>; 2] {
        let half = 0.5 * self.p;
        let discriminant = half * half - self.q;
        if discriminant < 0.0 {
            let (re, im) = (0.0 - half, Scalar::sqrt(-discriminant));
            return [Complex::new(re, -im), Complex::new(re, im)];
        }
        let large = 0.0 - (half + Scalar::sqrt(discriminant).copysign(half));
        let small = if large == 0.0 { 0.0 } else { self.q / large + 0.0 };
        [Complex::new(large.min(small), 0.0), Complex::new(large.max(small), 0.0)]
    }
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use proptest::prelude::*;

    use super::Quartic;
    use crate::Complex;
    use crate::numeric::DoubleDouble;

    /// The largest difference between a coefficient of the quartic and that of the product of its roots, relative to the
    /// size of the terms in the latter, in units of machine precision.
    fn backward_error(quartic: Quartic) -> f64 {
        let halves = quartic.roots();
        let exact = |[x, y]: [Complex<f64>; 2]| {
            let product = DoubleDouble::product;
            let p = -(DoubleDouble::from(x.re) + y.re.into());
            (p, product(x.re, y.re) - product(x.im, y.im), x.norm() + y.norm(), x.norm() * y.norm())
        };
        let [(p0, q0, p0_size, q0_size), (p1, q1, p1_size, q1_size)] = halves.map(exact);
        [
            (quartic.a, p0 + p1, p0_size + p1_size),
            (quartic.b, q0 + q1 + p0 * p1, q0_size + q1_size + p0_size * p1_size),
            (quartic.c, p0 * q1 + p1 * q0, p0_size * q1_size + p1_size * q0_size),
            (quartic.d, q0 * q1, q0_size * q1_size),
        ]
        .into_iter()
        .map(|(given, product, size)| {
            let difference = (product - given.into()).to_f64().abs();
            if difference == 0.0 { 0.0 } else { difference / size / f64::EPSILON }
        })
        .fold(0.0, f64::max)
    }
    #[test]
    fn explore() {
        let mut seed = 1u64;
        let mut next = || {
            seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            (seed >> 11) as f64 / (1u64 << 53) as f64
        };
        for spread in [0.0, 1.0, 3.0, 8.0, 16.0] {
            for kind in 0..7 {
                let mut worst = (0.0, Quartic { a: 0., b: 0., c: 0., d: 0. });
                let mut sum = 0.0;
                let mut fails = 0;
                for _ in 0..100000 {
                    let mut mag = || {
                        let s = if next() < 0.5 { -1.0 } else { 1.0 };
                        let m = 1.0 + next();
                        s * m * 10f64.powf(spread * (next() - 0.5))
                    };
                    let q = match kind {
                        0 => Quartic { a: mag(), b: mag(), c: mag(), d: mag() },
                        5 => {
                            let t = 10f64.powf(-60.0 * next());
                            let mut mag = || {
                                let s = if next() < 0.5 { -1.0 } else { 1.0 };
                                let m = 1.0 + next();
                                s * m * 10f64.powf(spread * (next() - 0.5))
                            };
                            Quartic {
                                a: mag(),
                                b: mag(),
                                c: t * mag(),
                                d: if mag() > 0.0 { 0.0 } else { t * t * mag() },
                            }
                        }
                        6 => {
                            let mut t = || {
                                if next() < 0.4 {
                                    0.0
                                } else {
                                    (8.0 * next() - 4.0).round() * 10f64.powf(-20.0 * (next() * 1.5).round())
                                }
                            };
                            Quartic { a: t(), b: t(), c: t(), d: t() }
                        }
                        k => {
                            let pair = |x: f64, y: f64, k: i32| {
                                if k == 0 { (-(x + y), x * y) } else { (-2.0 * x, x * x + y * y) }
                            };
                            let (x, y, mut z, mut w) = (mag(), mag(), mag(), mag());
                            if k == 4 {
                                z = x * (1.0 + 1e-9 * w);
                                w = x * (1.0 - 1e-10 * y);
                            }
                            let (p0, q0) = pair(x, y, (k == 2 || k == 3) as i32);
                            let (p1, q1) = pair(z, w, (k == 3) as i32);
                            Quartic { a: p0 + p1, b: q0 + q1 + p0 * p1, c: p0 * q1 + p1 * q0, d: q0 * q1 }
                        }
                    };
                    let e = backward_error(q);
                    if !(e < 1e3) {
                        fails += 1;
                    }
                    sum += e.min(1e9);
                    if !(e <= worst.0) {
                        worst = (e, q);
                    }
                }
                println!(
                    "spread {spread} kind {kind}: mean {:.2} worst {:.3e} fails {fails} {:?}",
                    sum / 1e5,
                    worst.0,
                    worst.1
                );
            }
        }
    }
}
#[cfg(test)]
mod dbg {
    use super::*;
    #[test]
    fn dbgq() {
        for q in [
            Quartic { a: 0.0, b: 4.0, c: 2e-20, d: 4.0 },
            Quartic { a: -11072.895347021133, b: -0.00017027034212065847, c: -2.045435924864367e-12, d: 0.0 },
        ] {
            println!("{:?}", q);
            let f = Resolvent::<f64>::new(q).factors();
            println!("f64 {:?} {:?}", f, q.residual(f));
            println!("   polished {:?}", q.polish(f));
            for f in Resolvent::<DoubleDouble>::new(q).factors() {
                println!("dd {:?} {:?}", f, q.residual(f));
                println!("   polished {:?}", q.polish(f));
            }
            println!("{:?}", q.roots());
        }
    }
}
