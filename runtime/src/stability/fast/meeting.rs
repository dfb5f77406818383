//! The double eigenvalue at a root of the discriminant.

use super::conditions::Conditions;
use super::simple_root::Root;
use crate::characteristic::double_root::Jet;
use crate::numeric::isolation::Bracket;
use crate::numeric::{DoubleDouble, Tracked};

/// A speed with a real double eigenvalue.
pub(super) struct DoubleRoot {
    pub(super) root: Root,
    /// The eigenvalue in two parts; in the square of the speed divided by the speed.
    pub(super) sigma: (f64, f64),
    /// Whether two real eigenvalues become a pair as the speed grows.
    pub(super) merges: bool,
}

/// The characteristic polynomial in x and sigma, by powers of sigma: that is s or, in the square of
/// the speed, s / v.
pub(super) struct DoubleRoots<'a, const P: usize> {
    p: &'a [[Tracked; P]; 5],
    value: [[f64; P]; 5],
    size: [[f64; P]; 5],
}

/// The least of derivatives that are not nearly zero, relative to their terms.
const SAFE: f64 = 1.0 / (1u64 << 24) as f64;

/// How often Newton's iteration is repeated in `f64` at most, and the step after which it is not, relative to the root.
const STEPS: usize = 4;
const CLOSE: f64 = 1.0 / (1u64 << 22) as f64;

/// What may be lacking of the speed, relative to it.
const LACKING: f64 = f64::EPSILON / 256.0;

/// The degrees of the coefficients in x, and the powers of x that they are multiplied with: in the square of the speed,
/// or in the speed.
const fn shape<const P: usize>() -> [(usize, usize); 5] {
    if P == 3 { [(2, 0), (1, 1), (1, 1), (0, 2), (0, 2)] } else { [(4, 0), (3, 0), (2, 0), (1, 0), (0, 0)] }
}

impl<'a, const P: usize> DoubleRoots<'a, P> {
    pub(super) fn new<const H: usize, const D: usize>(conditions: &'a Conditions<P, H, D>) -> Self {
        let p = &conditions.p;
        let (mut value, mut size) = ([[0.0; P]; 5], [[0.0; P]; 5]);
        for power in 0..5 {
            for i in 0..P {
                (value[power][i], size[power][i]) = (p[power][i].value.to_f64(), p[power][i].size);
            }
        }
        Self { p, value, size }
    }

    /// The double root in an interval, near x, by Newton's iteration for `p = p_sigma = 0`: in `f64`, then a step in
    /// double-double.
    #[inline]
    pub(super) fn near(&self, mut x: f64, bracket: &Bracket) -> Option<DoubleRoot> {
        let mut sigma = root_shared_with_derivative(values_and_slopes(&self.value, x)[0]);
        let mut at = jet(&self.value, sigma, x);
        let mut steps = 0;
        loop {
            let [x_step, sigma_step] = step(&at);
            (x, sigma, steps) = (x + x_step, sigma + sigma_step, steps + 1);
            at = jet(&self.value, sigma, x);
            if x_step.abs() <= CLOSE * x && sigma_step.abs() <= CLOSE * sigma.abs() {
                break;
            } else if steps == STEPS {
                return None;
            }
        }
        let [p, by_s] = self.residuals(sigma, x);
        let [x_rest, sigma_rest] = step(&Jet { p, by_s, ..at });

        let size = jet(&self.size, sigma.abs(), x);
        let is_safe = at.by_v.abs() > SAFE * size.by_v && at.by_ss.abs() > SAFE * size.by_ss;
        // The next step would be about this.
        let left = (size.by_ss * sigma_rest * sigma_rest + size.by_v / x * x_rest * x_rest) / at.by_v.abs();
        let error = f64::EPSILON * size.p / at.by_v.abs();
        let is_there = left <= LACKING * x && x > bracket.low && x < bracket.high;
        (is_safe && is_there).then_some(DoubleRoot {
            root: Root::new(x, x_rest, error),
            sigma: (sigma, sigma_rest),
            // Nearby `sigma^2 = -2 p_x x / p_sigma_sigma`, both measured from there.
            merges: (at.by_v > 0.0) == (at.by_ss > 0.0),
        })
    }

    /// p and its derivative by sigma, as far as double-double tells.
    #[inline]
    fn residuals(&self, sigma: f64, x: f64) -> [f64; 2] {
        let mut p = [DoubleDouble::ZERO; 5];
        for ((p, coefficients), (degree, factors)) in p.iter_mut().zip(self.p).zip(const { shape::<P>() }) {
            *p = coefficient(coefficients, degree, Tracked::ZERO).value;
            for i in (0..degree).rev() {
                *p = p.times(x).add_roughly(coefficient(coefficients, i, Tracked::ZERO).value);
            }
            for _ in 0..factors {
                *p = p.times(x);
            }
        }
        let mut value = p[4].times(sigma).add_roughly(p[3]);
        let mut slope = p[4];
        for power in (0..3).rev() {
            slope = slope.times(sigma).add_roughly(value);
            value = value.times(sigma).add_roughly(p[power]);
        }
        [value.to_f64(), slope.to_f64()]
    }
}

/// The step of x and of sigma that makes p and its derivative by sigma zero, to first order.
#[inline]
fn step(at: &Jet<f64>) -> [f64; 2] {
    let scale = 1.0 / at.determinant();
    at.step_against([at.p, at.by_s]).map(|step| step * scale)
}

/// A polynomial in x and sigma, and its derivatives, at a point.
#[inline]
fn jet<const P: usize>(polynomial: &[[f64; P]; 5], sigma: f64, x: f64) -> Jet<f64> {
    let [p, by_x] = values_and_slopes(polynomial, x);
    Jet::new(p, by_x, sigma)
}

/// The coefficients of the powers of sigma at x, and their derivatives.
#[inline]
fn values_and_slopes<const P: usize>(coefficients: &[[f64; P]; 5], x: f64) -> [[f64; 5]; 2] {
    let mut at = [[0.0; 5]; 2];
    for power in 0..5 {
        let (degree, factors) = const { shape::<P>() }[power];
        let (mut value, mut slope) = (coefficient(&coefficients[power], degree, 0.0), 0.0);
        for i in (0..degree).rev() {
            (value, slope) = (value * x + coefficient(&coefficients[power], i, 0.0), slope * x + value);
        }
        for _ in 0..factors {
            (value, slope) = (value * x, slope * x + value);
        }
        (at[0][power], at[1][power]) = (value, slope);
    }
    at
}

/// A coefficient, which is always there. Indexing would link a panic into the programs of microcontrollers, where loops are not
/// unrolled.
#[inline(always)]
fn coefficient<T: Copy>(coefficients: &[T], power: usize, zero: T) -> T {
    coefficients.get(power).copied().unwrap_or(zero)
}

/// The double root of a quartic that has one: the root of the remainder of degree one of the quartic and its derivative.
#[inline]
fn root_shared_with_derivative([e, d, c, b, a]: [f64; 5]) -> f64 {
    let (q2, q1, q0) = (8.0 * a * c - 3.0 * b * b, 12.0 * a * d - 2.0 * b * c, 16.0 * a * e - b * d);
    let constant = 4.0 * a * q1 * q0 + q2 * (q2 * d - 3.0 * b * q0);
    let linear = 4.0 * a * (q1 * q1 - q0 * q2) + q2 * (2.0 * c * q2 - 3.0 * b * q1);
    -constant / linear
}
