//! The roots of a quartic with real coefficients, as two quadratic factors.
//!
//! The factors are polished together, so that not only each root but all of them jointly belong to a quartic close to
//! the given one: roots polished one by one drift apart where they nearly coincide.

use nalgebra::Complex;

use super::quadratic::Quadratic;
use super::quartic::Quartic;
use super::resolvent::Resolvent;
use crate::number::lane::Lane;
use crate::number::real::Real;
use crate::numeric::{DoubleDouble, Part, Scaled, ldexp};

/// The error of a coefficient of the product of the factors, relative to the size of its terms, that is only rounding.
const fn rounding<T: Lane>() -> f64 {
    2.0 * T::EPSILON
}

/// A number in which eigenvalues are computed from beginning to end.
pub(crate) trait Precision: Lane<Mask = bool> + Part + Scaled {
    /// The smallest positive number of all digits.
    const TINY: Self;
    /// By how much a double root of the resolvent may be off, and a margin.
    const ABOVE: Self;
}

impl Precision for f64 {
    const TINY: Self = f64::MIN_POSITIVE;
    const ABOVE: Self = 1.0 + 1e-7;
}

impl Precision for f32 {
    const TINY: Self = f32::MIN_POSITIVE;
    const ABOVE: Self = 1.0 + 2e-3;
}

impl<T: Precision> Quartic<T> {
    /// The four roots: in each half two real ones, ascending, or a conjugate pair, the negative imaginary part first.
    ///
    /// Real roots have an imaginary part of exactly zero and pairs are exactly conjugate. Finite if the coefficients are,
    /// unless a root itself overflows.
    #[inline]
    pub(crate) fn roots(self) -> [[Complex<T>; 2]; 2] {
        if self.is_moderate() {
            return self.factors().map(Quadratic::complex_roots);
        }
        self.scaled_roots()
    }

    #[cold]
    fn scaled_roots(self) -> [[Complex<T>; 2]; 2] {
        let Self { a, b, c, d } = self;
        let unit = self.unit();
        let [a, b, c, d] = [(a, -unit), (b, -2 * unit), (c, -3 * unit), (d, -4 * unit)].map(|(x, e)| ldexp(x, e));
        let unscale = |root: Complex<T>| Complex::new(ldexp(root.re, unit), ldexp(root.im, unit));
        Self { a, b, c, d }.factors().map(|factor| factor.complex_roots().map(unscale))
    }

    /// Two quadratic factors with real coefficients.
    #[inline]
    fn factors(self) -> [Quadratic<T>; 2] {
        let (factors, are_exact) = self.quick_factors();
        if are_exact { factors } else { self.careful_factors(factors) }
    }

    /// The factors where a few steps are not enough: close to three or four equal roots, or with roots of very different size.
    #[cold]
    fn careful_factors(self, factors: [Quadratic<T>; 2]) -> [Quadratic<T>; 2] {
        let (mut factors, mut error) = self.polish(factors);
        // The sum of the errors of all four that is no more than rounding.
        if error <= T::from_f64(4.0 * rounding::<T>()) {
            return factors;
        }
        let Self { a, b, c, d } = self;
        let [a, b, c, d] = [a, b, c, d].map(DoubleDouble::from);
        for candidate in
            [Resolvent::new(self).factors()].into_iter().chain(Resolvent::new(Quartic { a, b, c, d }).factors())
        {
            let (candidate, candidate_error) = self.polish(candidate);
            // What is not a number is no better than anything.
            if candidate_error < error || !error.is_finite() {
                (factors, error) = (candidate, candidate_error);
            }
        }
        factors
    }

    /// Newton's iteration for both factors at once, as long as it brings their product closer to the quartic.
    fn polish(self, mut factors: [Quadratic<T>; 2]) -> ([Quadratic<T>; 2], T) {
        const STEPS: usize = 6;
        let measure = |factors| {
            let (residual, size) = self.residual(factors);
            let term = |i: usize| Real::abs(residual[i]) / (size[i] + T::TINY);
            (residual, (term(0) + term(1)) + (term(2) + term(3)))
        };
        let (mut residual, mut error) = measure(factors);
        for _ in 0..STEPS {
            if error <= T::from_f64(rounding::<T>()) {
                break;
            }
            let next = newton(factors, residual);
            let (next_residual, next_error) = measure(next);
            // Factors with a root in common may give what is not a number, which is not smaller either.
            if next_error < error {
                (factors, residual, error) = (next, next_residual, next_error);
            } else {
                break;
            }
        }
        (factors, error)
    }
}

impl<T: Lane> Quartic<T> {
    /// Two quadratic factors, and whether their product is the quartic but for rounding.
    #[inline(always)]
    pub(super) fn quick_factors(self) -> ([Quadratic<T>; 2], T::Mask) {
        const STEPS: usize = 3;
        let mut factors = Resolvent::new(self).factors();
        let (mut residual, size) = self.residual(factors);
        let mut are_exact = is_rounding(residual, size);
        for _ in 0..STEPS {
            if T::all(are_exact) {
                break;
            }
            let [s, t] = newton(factors, residual);
            let [before_s, before_t] = factors;
            factors = [Quadratic::select(are_exact, before_s, s), Quadratic::select(are_exact, before_t, t)];
            let (next, size) = self.residual(factors);
            residual = next;
            are_exact = is_rounding(residual, size);
        }
        (factors, are_exact)
    }
}

/// Whether each residual is no more than rounding; what is not a number is more.
#[inline(always)]
fn is_rounding<T: Lane>(residual: [T; 4], size: [T; 4]) -> T::Mask {
    let term = |i: usize| residual[i].abs().less_or_equal(size[i] * size[i].like(rounding::<T>()));
    (term(0) & term(1)) & (term(2) & term(3))
}

/// The factors moved so that, to first order, their product changes by `residual`.
#[inline(always)]
fn newton<T: Real>([s, t]: [Quadratic<T>; 2], [ra, rb, rc, rd]: [T; 4]) -> [Quadratic<T>; 2] {
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

#[cfg(all(test, feature = "std"))]
mod tests {
    use nalgebra::Complex;
    use proptest::prelude::*;

    use super::Quartic;
    use crate::numeric::DoubleDouble;

    /// The largest difference between a coefficient of the quartic and that of the product of its roots, in double-double
    /// arithmetic, relative to the size of the terms in the latter, in units of machine precision.
    fn backward_error(quartic: Quartic) -> f64 {
        let exact = |[x, y]: [Complex<f64>; 2]| {
            let product = DoubleDouble::product;
            let p = -(DoubleDouble::from(x.re) + y.re.into());
            (p, product(x.re, y.re) - product(x.im, y.im), x.norm() + y.norm(), x.norm() * y.norm())
        };
        let [(p0, q0, p0_size, q0_size), (p1, q1, p1_size, q1_size)] = quartic.roots().map(exact);
        let coefficients = [
            (quartic.a, p0 + p1, p0_size + p1_size),
            (quartic.b, q0 + q1 + p0 * p1, q0_size + q1_size + p0_size * p1_size),
            (quartic.c, p0 * q1 + p1 * q0, p0_size * q1_size + p1_size * q0_size),
            (quartic.d, q0 * q1, q0_size * q1_size),
        ];
        let error = |(given, product, size): (f64, DoubleDouble, f64)| {
            let difference = (product - given.into()).to_f64().abs();
            if difference == 0.0 { 0.0 } else { difference / size / f64::EPSILON }
        };
        coefficients.map(error).into_iter().fold(0.0, f64::max)
    }

    /// The same in `f32`, in units of its precision. Products of its numbers are exact in `f64`, and sums nearly.
    fn backward_error_f32(quartic: Quartic<f32>) -> f64 {
        let factors = quartic.roots().map(|pair| pair.map(|root| Complex::new(f64::from(root.re), f64::from(root.im))));
        let [(p0, q0, p0_size, q0_size), (p1, q1, p1_size, q1_size)] =
            factors.map(|[x, y]| (-(x.re + y.re), x.re * y.re - x.im * y.im, x.norm() + y.norm(), x.norm() * y.norm()));
        let coefficients = [
            (quartic.a, p0 + p1, p0_size + p1_size),
            (quartic.b, q0 + q1 + p0 * p1, q0_size + q1_size + p0_size * p1_size),
            (quartic.c, p0 * q1 + p1 * q0, p0_size * q1_size + p1_size * q0_size),
            (quartic.d, q0 * q1, q0_size * q1_size),
        ];
        let error = |(given, product, size): (f32, f64, f64)| {
            let difference = (product - f64::from(given)).abs();
            if difference == 0.0 { 0.0 } else { difference / size / f64::from(f32::EPSILON) }
        };
        coefficients.map(error).into_iter().fold(0.0, f64::max)
    }

    /// Whether no root is smaller than the largest by more than a factor of 1e9: below that those in `f32` lose digits.
    fn is_in_reach_of_f32(quartic: Quartic) -> bool {
        let sizes = quartic.roots().map(|pair| pair.map(|root| root.norm()));
        let [smallest, largest] = [f64::min, f64::max].map(|pick| sizes.as_flattened().iter().copied().reduce(pick));
        smallest > largest.map(|largest| 1e-9 * largest)
    }

    fn in_f32(Quartic { a, b, c, d }: Quartic) -> Quartic<f32> {
        Quartic { a: a as f32, b: b as f32, c: c as f32, d: d as f32 }
    }

    /// Numbers of either sign over some decades.
    fn number(decades: f64) -> impl Strategy<Value = f64> {
        (any::<bool>(), 1.0..10.0f64, -decades..decades).prop_map(|(negative, mantissa, exponent)| {
            10f64.powf(exponent) * if negative { -mantissa } else { mantissa }
        })
    }

    /// Two real roots or a pair, from their mean and half of their distance.
    fn factor((mean, half, is_pair): (f64, f64, bool)) -> (f64, f64) {
        (-2.0 * mean, mean * mean + if is_pair { half * half } else { -half * half })
    }

    fn product((p0, q0): (f64, f64), (p1, q1): (f64, f64)) -> Quartic {
        Quartic { a: p0 + p1, b: q0 + q1 + p0 * p1, c: p0 * q1 + p1 * q0, d: q0 * q1 }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4096))]

        #[test]
        fn any_coefficients(a in number(6.0), b in number(6.0), c in number(6.0), d in number(6.0)) {
            let quartic = Quartic { a, b, c, d };
            prop_assert!(backward_error(quartic) < 16.0);
            prop_assert!(!is_in_reach_of_f32(quartic) || backward_error_f32(in_f32(quartic)) < 16.0);
        }

        #[test]
        fn roots_of_any_kind(s in (number(4.0), number(4.0), any::<bool>()), t in (number(4.0), number(4.0), any::<bool>())) {
            let quartic = product(factor(s), factor(t));
            prop_assert!(backward_error(quartic) < 16.0);
            prop_assert!(!is_in_reach_of_f32(quartic) || backward_error_f32(in_f32(quartic)) < 16.0);
        }

        /// Two imaginary pairs that nearly coincide, as without damping.
        #[test]
        fn biquadratics(square in 1e-3..1e3f64, near in -1e-12..1e-12f64) {
            let other = square * (1.0 + near);
            let quartic = Quartic { a: 0.0, b: square + other, c: 0.0, d: square * other };
            prop_assert!(backward_error(quartic) < 16.0);
        }

        /// Up to four roots that differ from the fourth digit on, in half of the precision.
        #[test]
        fn clusters_f32(x in number(2.0), near in prop::array::uniform3(-1e-4..1e-4), pairs in any::<(bool, bool)>()) {
            let near = near.map(|relative| x * relative);
            let quartic = product(factor((x, near[0], pairs.0)), factor((x + near[1], near[2], pairs.1)));
            prop_assert!(backward_error_f32(in_f32(quartic)) < 16.0);
        }

        /// Up to four roots that differ from the eighth digit on.
        #[test]
        fn clusters(x in number(2.0), near in prop::array::uniform3(-1e-8..1e-8), pairs in any::<(bool, bool)>()) {
            let near = near.map(|relative| x * relative);
            let quartic = product(factor((x, near[0], pairs.0)), factor((x + near[1], near[2], pairs.1)));
            prop_assert!(backward_error(quartic) < 16.0);
        }
    }

    /// Newton's iteration for the resolvent cubic once left such a double root again, by the noise of its last step.
    #[test]
    fn a_biquadratic_that_was_lost() {
        let (square, near) = (566.702001756334, -8.333203552743818e-13);
        let other = square * (1.0 + near);
        assert!(backward_error(Quartic { a: 0.0, b: square + other, c: 0.0, d: square * other }) < 16.0);
    }

    #[test]
    fn roots_that_are_exact() {
        let assert_roots = |[a, b, c, d]: [f64; 4], expected: [(f64, f64); 4]| {
            let mut roots = Quartic { a, b, c, d }.roots().as_flattened().to_vec();
            roots.sort_by(|x, y| x.re.total_cmp(&y.re).then(x.im.total_cmp(&y.im)));
            assert_eq!(roots, expected.map(|(re, im)| Complex::new(re, im)));
        };
        assert_roots([0.0, 0.0, 0.0, 0.0], [(0.0, 0.0); 4]);
        assert_roots([-2.0, 0.0, 0.0, 0.0], [(0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (2.0, 0.0)]);
        assert_roots([0.0, 0.0, 0.0, -16.0], [(-2.0, 0.0), (0.0, -2.0), (0.0, 2.0), (2.0, 0.0)]);
        assert_roots([0.0, 2.0, 0.0, 1.0], [(0.0, -1.0), (0.0, -1.0), (0.0, 1.0), (0.0, 1.0)]);
        assert_roots([-4.0, 6.0, -4.0, 1.0], [(1.0, 0.0); 4]);
    }

    #[test]
    fn coefficients_of_any_size() {
        for scale in [1e-70, 1e-30, 1e30, 1e70_f64] {
            let quartic = Quartic { a: 0.0, b: -5.0 * scale * scale, c: 0.0, d: 4.0 * scale.powi(4) };
            let mut magnitudes =
                quartic.roots().as_flattened().iter().map(|root| root.re.abs() / scale).collect::<Vec<_>>();
            magnitudes.sort_by(f64::total_cmp);
            for (magnitude, expected) in magnitudes.into_iter().zip([1.0, 1.0, 2.0, 2.0]) {
                assert!((magnitude - expected).abs() < 1e-14);
            }
        }
    }
}
