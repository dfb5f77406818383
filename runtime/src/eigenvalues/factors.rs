//! The roots of a quartic with real coefficients, as two quadratic factors.
//!
//! The factors are polished together, so that not only each root but all of them jointly belong to a quartic close to
//! the given one: roots polished one by one drift apart where they nearly coincide.

use nalgebra::Complex;

use super::quadratic::Quadratic;
use super::quartic::Quartic;
use super::resolvent::Resolvent;
use crate::number::Scalar;
use crate::number::lane::Lane;
use crate::number::real::Real;
use crate::numeric::{DoubleDouble, Part, Scaled, ldexp};
use crate::system::SystemError;

/// The error of a coefficient of the product of the factors, relative to the size of its terms, that is only rounding.
const fn rounding<T: Lane>() -> f64 {
    2.0 * T::EPSILON
}

/// The bound on the steps in twice the precision.
const STEPS: usize = 24;

/// A number in which eigenvalues are computed from beginning to end.
pub(crate) trait Precision: Lane<Mask = bool> + Part + Scalar + Scaled {
    const ZERO: Self;
    /// The smallest positive number of all digits.
    const TINY: Self;
    /// By how much a double root of the resolvent may be off, and a margin.
    const ABOVE: Self;
    /// The sum of the errors of the coefficients from which on factors are refused. In `f32` roots that are small beside the
    /// largest may have fewer digits.
    const REFUSED: Self;
}

impl Precision for f64 {
    const ZERO: Self = 0.0;
    const TINY: Self = f64::MIN_POSITIVE;
    const ABOVE: Self = 1.0 + 1e-7;
    const REFUSED: Self = 8.0 * rounding::<Self>();
}

impl Precision for f32 {
    const ZERO: Self = 0.0;
    const TINY: Self = f32::MIN_POSITIVE;
    const ABOVE: Self = 1.0 + 2e-3;
    const REFUSED: Self = Self::INFINITY;
}

impl<T: Precision> Quartic<T> {
    /// The four roots: in each half two real ones, ascending, or a conjugate pair, the negative imaginary part first.
    ///
    /// Real roots have an imaginary part of exactly zero and pairs are exactly conjugate. Finite if the coefficients are,
    /// unless a root itself overflows.
    ///
    /// # Errors
    /// If coefficients differ so much in size, by 1e16 and more, that the iteration does not find all of the roots.
    #[inline]
    pub(crate) fn roots(self) -> Result<[[Complex<T>; 2]; 2], SystemError> {
        if self.is_moderate() {
            let (factors, are_exact) = self.quick_factors();
            if are_exact {
                return Ok(factors.map(Quadratic::complex_roots));
            }
        }
        self.careful_roots()
    }

    #[cold]
    fn careful_roots(self) -> Result<[[Complex<T>; 2]; 2], SystemError> {
        let (roots, error) = self.nearest_roots();
        if error > T::REFUSED { Err(SystemError::NotConverged { iterations: STEPS }) } else { Ok(roots) }
    }

    /// The roots as far as they are found, in any case, and the sum of the errors of the coefficients that they have jointly.
    pub(crate) fn nearest_roots(self) -> ([[Complex<T>; 2]; 2], T) {
        let Self { a, b, c, d } = self;
        let unit = if self.is_moderate() { 0 } else { self.unit() };
        let [a, b, c, d] = [(a, -unit), (b, -2 * unit), (c, -3 * unit), (d, -4 * unit)].map(|(x, e)| ldexp(x, e));
        let (factors, error) = Self { a, b, c, d }.careful_factors();
        let unscale = |root: Complex<T>| Complex::new(ldexp(root.re, unit), ldexp(root.im, unit));
        (factors.map(|factor| factor.complex_roots().map(unscale)), error)
    }

    /// The factors where a few steps are not enough: close to three or four equal roots, or with roots of very different size.
    fn careful_factors(self) -> ([Quadratic<T>; 2], T) {
        let (mut factors, mut error) = self.polish(Resolvent::new(self).factors());
        // The sum of the errors of all four that is no more than rounding.
        if error <= T::from_f64(4.0 * rounding::<T>()) {
            return (factors, error);
        }
        let Self { a, b, c, d } = self;
        let [a, b, c, d] = [a, b, c, d].map(DoubleDouble::from);
        let precise = Resolvent::new(Quartic { a, b, c, d }).factors();
        for candidate in [self.graded_factors()].into_iter().chain(precise) {
            let (candidate, candidate_error) = self.polish(candidate);
            // What is not a number is no better than anything.
            if candidate_error < error || !error.is_finite() {
                (factors, error) = (candidate, candidate_error);
            }
        }
        self.refine(factors, error)
    }

    /// The factors where one root is far larger than all others, and another one far smaller: both in the first.
    fn graded_factors(self) -> [Quadratic<T>; 2] {
        // Each changes the others by the ratio of the sizes.
        const STEPS: usize = 4;
        let Self { a, b, c, d } = self;
        let [mut s, mut t] = [Quadratic { p: a, q: T::ZERO }, Quadratic { p: T::ZERO, q: c / a }];
        for _ in 0..STEPS {
            s.q = d / t.q;
            t.p = (b - s.q - t.q) / s.p;
            s.p = a - t.p;
            t.q = (c - t.p * s.q) / s.p;
        }
        [s, t]
    }

    /// The same iteration as [`polish`](Self::polish) in twice the precision: close to a quartic with two equal factors each
    /// step takes a quarter off, and rounding would end it too early.
    fn refine(self, mut factors: [Quadratic<T>; 2], mut error: T) -> ([Quadratic<T>; 2], T) {
        let Self { a, b, c, d } = self;
        let [a, b, c, d] = [a, b, c, d].map(DoubleDouble::from);
        let exact = Quartic { a, b, c, d };
        let mut precise = factors.map(|Quadratic { p, q }| Quadratic { p: DoubleDouble::from(p), q: q.into() });
        for _ in 0..STEPS {
            if error <= T::from_f64(4.0 * rounding::<T>()) {
                break;
            }
            precise = newton(precise, exact.residual(precise).0);
            let next = precise.map(|Quadratic { p, q }| Quadratic { p: p.high(), q: q.high() });
            let next_error = self.error(next).1;
            if next_error < error {
                (factors, error) = (next, next_error);
            }
        }
        (factors, error)
    }

    /// The residual of the factors, and the sum of the errors of all four coefficients.
    fn error(self, factors: [Quadratic<T>; 2]) -> ([T; 4], T) {
        let (residual, size) = self.residual(factors);
        let term = |i: usize| Real::abs(residual[i]) / (size[i] + T::TINY);
        (residual, (term(0) + term(1)) + (term(2) + term(3)))
    }

    /// Newton's iteration for both factors at once, as long as it brings their product closer to the quartic.
    fn polish(self, mut factors: [Quadratic<T>; 2]) -> ([Quadratic<T>; 2], T) {
        const STEPS: usize = 6;
        let (mut residual, mut error) = self.error(factors);
        for _ in 0..STEPS {
            if error <= T::from_f64(rounding::<T>()) {
                break;
            }
            let next = newton(factors, residual);
            let (next_residual, next_error) = self.error(next);
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

    use super::{Quartic, STEPS};
    use crate::numeric::DoubleDouble;
    use crate::system::SystemError;

    /// The largest difference between a coefficient of the quartic and that of the product of its roots, in double-double
    /// arithmetic, relative to the size of the terms in the latter, in units of machine precision.
    fn backward_error(quartic: Quartic) -> f64 {
        let exact = |[x, y]: [Complex<f64>; 2]| {
            let product = DoubleDouble::product;
            let p = -(DoubleDouble::from(x.re) + y.re.into());
            (p, product(x.re, y.re) - product(x.im, y.im), x.norm() + y.norm(), x.norm() * y.norm())
        };
        let [(p0, q0, p0_size, q0_size), (p1, q1, p1_size, q1_size)] = quartic.roots().expect("roots").map(exact);
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
        let factors = quartic
            .roots()
            .expect("roots")
            .map(|pair| pair.map(|root| Complex::new(f64::from(root.re), f64::from(root.im))));
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
        let sizes = quartic.roots().expect("roots").map(|pair| pair.map(|root| root.norm()));
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

        /// Coefficients that differ by up to 16 orders of magnitude.
        #[test]
        fn coefficients_of_any_spread(a in number(8.0), b in number(8.0), c in number(8.0), d in number(8.0)) {
            let quartic = Quartic { a, b, c, d };
            prop_assert!(backward_error(quartic) < 16.0);
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

    /// About two factors that are nearly equal Newton's iteration takes a quarter off with each step, and rounding once ended
    /// it too early: four of twenty million random clusters.
    #[test]
    fn clusters_that_were_lost() {
        for [a, b, c, d] in [
            [665.8990134550309, 166283.06104514375, 18454621.050707318, 768057121.959528],
            [-57.28791923967282, 1230.714634054228, -11750.846760463686, 42073.84751320091],
            [-0.8679450381437332, 0.28249822096437244, -0.0408654881950765, 0.0022168123568898717],
            [0.5178997943214234, 0.10058257385931475, 0.008681949052343083, 0.00028102372678234745],
        ] {
            let error = backward_error(Quartic { a, b, c, d });
            assert!(error < 16.0, "{error} of {a}");
        }
    }

    /// By mpmath's `polyroots` with 400 digits: a root that is far larger than a pair, and one that is far smaller.
    #[test]
    fn coefficients_of_very_different_size() {
        let cases = [
            (
                [9596962655663066.0, 59954707.755377024, 338683795209.7416, -3.843045911469538e-5],
                [
                    (-9596962655663066.0, 0.0),
                    (-3.1236293708473847e-9, -0.005940599939026379),
                    (-3.1236293708473847e-9, 0.005940599939026379),
                    (1.1347002619625187e-16, 0.0),
                ],
            ),
            (
                [-5464305569571213.0, -0.05187959364205807, -166310748.53006235, -3.807382100777449e-15],
                [
                    (-4.747126448369079e-18, -0.00017445871542071554),
                    (-4.747126448369079e-18, 0.00017445871542071554),
                    (-2.2893181195015944e-23, 0.0),
                    (5464305569571213.0, 0.0),
                ],
            ),
            (
                [329582578616151.3, 50627.0831525959, 12933359.84011881, 2.5066848906559464e-12],
                [
                    (-329582578616151.3, 0.0),
                    (-7.680485312854074e-11, -0.00019809501958195188),
                    (-7.680485312854074e-11, 0.00019809501958195188),
                    (-1.9381544483748928e-19, 0.0),
                ],
            ),
        ];
        for ([a, b, c, d], expected) in cases {
            let mut roots = Quartic::<f64> { a, b, c, d }.roots().expect("roots").as_flattened().to_vec();
            roots.sort_by(|x, y| x.re.total_cmp(&y.re).then(x.im.total_cmp(&y.im)));
            for (root, (re, im)) in roots.into_iter().zip(expected) {
                let distance = (root - Complex::new(re, im)).norm();
                assert!(distance <= 4.0 * f64::EPSILON * f64::hypot(re, im), "{root} is not {re} + {im}i");
            }
        }
    }

    /// Three roots of about 1e-14 beside one of 5e39: they are not found, and that is said.
    #[test]
    fn roots_that_are_not_found_are_refused() {
        let (a, b, c, d) =
            (-4.7941041388314354e39, -0.00036961717769342235, 3.3340361535071345e-21, 0.1890317053100779);
        assert_eq!(Quartic::<f64> { a, b, c, d }.roots(), Err(SystemError::NotConverged { iterations: STEPS }));
    }

    #[test]
    fn roots_that_are_exact() {
        let assert_roots = |[a, b, c, d]: [f64; 4], expected: [(f64, f64); 4]| {
            let mut roots = Quartic { a, b, c, d }.roots().expect("roots").as_flattened().to_vec();
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
            let mut magnitudes = quartic
                .roots()
                .expect("roots")
                .as_flattened()
                .iter()
                .map(|root| root.re.abs() / scale)
                .collect::<Vec<_>>();
            magnitudes.sort_by(f64::total_cmp);
            for (magnitude, expected) in magnitudes.into_iter().zip([1.0, 1.0, 2.0, 2.0]) {
                assert!((magnitude - expected).abs() < 1e-14);
            }
        }
    }
}
