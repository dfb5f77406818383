//! The characteristic polynomial without damping at rest, and the polynomials in the square of the speed made from it.

use crate::numeric::fixed::{add, product, square, sub, times, trimmed};
use crate::numeric::{DoubleDouble, Sum};
use crate::{Coefficients, Matrix, Scalar};

/// `det(M s^2 + v C1 s + Kc + g K0 + v^2 K2)`, up to a sign, as
/// `p_4 s^4 + v p_3 s^3 + p_2(u) s^2 + v p_1(u) s + p_0(u)` with u = v^2.
pub(super) struct Even {
    pub(super) p0: [Sum; 3],
    pub(super) p1: [Sum; 2],
    pub(super) p2: [Sum; 2],
    pub(super) p3: Sum,
    pub(super) p4: Sum,
}

/// Products of numbers within these limits, as many as occur here, stay in the range of `f64`.
const SMALLEST: f64 = 1e-20;
const LARGEST: f64 = 1e20;

/// The smallest determinant of the mass matrix that is surely not zero, relative to its terms.
const REGULAR: f64 = 16.0 * f64::EPSILON;

type Rows<T> = [[T; 2]; 2];

impl Even {
    /// `None` with damping at rest, a singular mass matrix, or entries that are not finite or of unusual size.
    pub(super) fn new<T: Scalar>(coefficients: &Coefficients<T, 2>, gravity: f64) -> Option<Self> {
        let Coefficients { m, c0, c1, kc, k0, k2 } = coefficients;
        let [m, c0, c1, kc, k0, k2] = [m, c0, c1, kc, k0, k2].map(rows);
        let is_moderate = |x: f64| ((SMALLEST..=LARGEST).contains(&x.abs())) | (x == 0.0);
        let entries = [m, c1, kc, k0, k2];
        let moderate = entries.as_flattened().as_flattened().iter().fold(true, |all, &x| all & is_moderate(x));
        let damped = c0.as_flattened().iter().any(|&x| x != 0.0);
        if !moderate || damped || !is_moderate(gravity) {
            return None;
        }
        let k: Rows<Sum> =
            core::array::from_fn(|i| core::array::from_fn(|j| Sum::product(gravity, k0[i][j]) + kc[i][j].into()));
        let p4 = determinant(m);
        let (mass, sign) = (p4.value.to_f64(), p4.value.to_f64().signum());
        if mass.abs() <= REGULAR * p4.size {
            return None;
        }
        let p0 = [k[0][0] * k[1][1] - k[0][1] * k[1][0], mixed(k2, k), determinant(k2)];
        let p1 = [mixed(c1, k), mixed_exact(c1, k2)];
        let p2 = [mixed(m, k), mixed_exact(m, k2) + determinant(c1)];
        let p3 = mixed_exact(m, c1);
        let (p0, p1, p2) = (trimmed(p0), trimmed(p1), trimmed(p2));
        if sign < 0.0 {
            return Some(Self { p0: p0.map(|p| -p), p1: p1.map(|p| -p), p2: p2.map(|p| -p), p3: -p3, p4: -p4 });
        }
        Some(Self { p0, p1, p2, p3, p4 })
    }

    /// The Hurwitz determinant divided by u, and the discriminant, both in u.
    pub(super) fn hurwitz_and_discriminant(&self) -> ([Sum; 3], [Sum; 7]) {
        let Self { p0, p1, p2, p3, p4 } = self;
        let p31 = p1.map(|p1| *p3 * p1);
        let first: [Sum; 3] = product(&p31, p2);
        let p11: [Sum; 3] = square(p1);
        let p33 = *p3 * *p3;
        let rest: [Sum; 3] = core::array::from_fn(|i| *p4 * p11[i] + p33 * p0[i]);
        let hurwitz = trimmed(sub(first, rest));

        let p40 = p0.map(|p0| *p4 * p0);
        let p22: [Sum; 3] = square(p2);
        // The invariants I and J of the quartic.
        let three = times(p31, 3.0);
        let mut i = add(times(p40, 12.0), p22);
        i[1] = i[1] - three[0];
        i[2] = i[2] - three[1];
        let mut j: [Sum; 4] = product(p2, &sub(times(p40, 72.0), times(p22, 2.0)));
        let terms = sub(times(first, 9.0), times(rest, 27.0));
        for power in 0..3 {
            j[power + 1] = j[power + 1] + terms[power];
        }
        let ii: [Sum; 5] = square(&i);
        let iii: [Sum; 7] = product(&ii, &i);
        (hurwitz, sub(times(iii, 4.0), square(&j)))
    }
}

#[inline]
fn rows<T: Scalar>(matrix: &Matrix<T, 2>) -> Rows<f64> {
    [[matrix.m11.to_f64(), matrix.m12.to_f64()], [matrix.m21.to_f64(), matrix.m22.to_f64()]]
}

#[inline]
fn determinant(x: Rows<f64>) -> Sum {
    Sum::product(x[0][0], x[1][1]) - Sum::product(x[0][1], x[1][0])
}

/// The terms of `det(x + y)` with an entry of each.
#[inline]
fn mixed(x: Rows<f64>, y: Rows<Sum>) -> Sum {
    (y[1][1].times(x[0][0]) - y[1][0].times(x[0][1])) + (y[0][0].times(x[1][1]) - y[0][1].times(x[1][0]))
}

#[inline]
fn mixed_exact(x: Rows<f64>, y: Rows<f64>) -> Sum {
    (Sum::product(x[0][0], y[1][1]) - Sum::product(x[0][1], y[1][0]))
        + (Sum::product(y[0][0], x[1][1]) - Sum::product(y[0][1], x[1][0]))
}

/// A value in double-double of a polynomial.
#[inline]
pub(super) fn at<const N: usize>(coefficients: &[Sum; N], u: f64) -> Sum {
    let mut value = coefficients[N - 1];
    for i in (0..N - 1).rev() {
        value = value.times(u) + coefficients[i];
    }
    value
}

/// A number in double-double and, in `f64`, what it lacks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Square {
    pub(super) u: f64,
    pub(super) rest: f64,
}

impl Square {
    /// Its square root, rounded once.
    #[inline]
    pub(super) fn speed(self) -> (f64, f64) {
        let root = Scalar::sqrt(self.u);
        let rest = DoubleDouble::from(self.u) - DoubleDouble::product(root, root);
        let rest = (rest.to_f64() + self.rest) / (2.0 * root);
        let speed = root + rest;
        (speed, rest - (speed - root))
    }
}
