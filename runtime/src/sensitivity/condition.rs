//! The conditions that define critical speeds, and how their solutions answer to a change of the matrices.

use core::ops::{Add, Div, Mul, Neg, Sub};

use super::pencil::equilibrate;
use crate::numeric::{DoubleDouble, Real as _, Sum, exponent, ldexp};
use crate::{Coefficients, CriticalKind, Matrix};

/// The coefficients of `det(M s^2 + C s + K)` in s, ascending, or their derivatives.
pub(super) type Quartic = [Sum; 5];

/// The entries of `[K, C, M]`.
type Entries = [[[Sum; 3]; 2]; 2];

/// The matrices of two coordinates, with rows, columns, time and speed measured in powers of two that bring all entries to
/// at most about one.
pub(super) struct Scaled {
    coefficients: Coefficients<f64, 2>,
    /// Gravity is this, times a power of two that K0 is scaled by.
    gravity: f64,
    gravity_exponent: i32,
    rows: [i32; 2],
    columns: [i32; 2],
    pub(super) speed_unit: i32,
    pub(super) time_unit: i32,
}

impl Scaled {
    pub(super) fn new(coefficients: &Coefficients<f64, 2>, gravity: f64) -> Self {
        let Coefficients { m, c0, c1, kc, k0, k2 } = coefficients;
        let (rows, columns) = equilibrate(m);
        let largest = |matrix: &Matrix<f64, 2>| {
            let places = (0..4).map(|i| (i / 2, i % 2));
            places.filter_map(|(i, j)| Some(exponent(matrix[(i, j)])? + rows[i] + columns[j])).max()
        };
        let gravity_exponent = exponent(gravity).unwrap_or(0);
        let weight = if gravity == 0.0 { None } else { largest(k0).map(|e| e + gravity_exponent) };
        let half = |e: i32| (e + 1).div_euclid(2);
        let time_unit = largest(c0).max(largest(kc).max(weight).map(half)).unwrap_or(0);
        let speed_unit = time_unit - largest(c1).max(largest(k2).map(half)).unwrap_or(time_unit);
        let gravity = ldexp(gravity, -gravity_exponent);
        let mut scaled =
            Self { coefficients: *coefficients, gravity, gravity_exponent, rows, columns, speed_unit, time_unit };
        scaled.coefficients = scaled.scaled(coefficients);
        scaled
    }

    /// Other coefficients, or derivatives of them, in the same units.
    pub(super) fn scaled(&self, coefficients: &Coefficients<f64, 2>) -> Coefficients<f64, 2> {
        let scaled = |matrix: &Matrix<f64, 2>, power: i32| {
            Matrix::from_fn(|i, j| ldexp(matrix[(i, j)], self.rows[i] + self.columns[j] + power))
        };
        let Coefficients { m, c0, c1, kc, k0, k2 } = coefficients;
        let (time, speed) = (self.time_unit, self.speed_unit);
        Coefficients {
            m: scaled(m, 0),
            c0: scaled(c0, -time),
            c1: scaled(c1, speed - time),
            kc: scaled(kc, -2 * time),
            k0: scaled(k0, self.gravity_exponent - 2 * time),
            k2: scaled(k2, 2 * (speed - time)),
        }
    }

    /// The characteristic polynomial at a scaled speed.
    pub(super) fn characteristic(&self, speed: DoubleDouble) -> Quartic {
        let [[a, b], [c, d]] = self.entries(&self.coefficients, speed);
        powers(|i, j| a[i] * d[j] - b[i] * c[j])
    }

    /// Its derivative with respect to the speed.
    pub(super) fn by_speed(&self, speed: DoubleDouble) -> Quartic {
        let Coefficients { c1, k2, .. } = &self.coefficients;
        let twice = Sum::from(speed + speed);
        let entry = |i, j| [twice * k2[(i, j)].into(), c1[(i, j)].into(), Sum::ZERO];
        self.along(&[[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]], speed)
    }

    /// Its derivative in the direction of scaled derivatives of the coefficients.
    pub(super) fn by(&self, direction: &Coefficients<f64, 2>, speed: DoubleDouble) -> Quartic {
        self.along(&self.entries(direction, speed), speed)
    }

    fn along(&self, [[da, db], [dc, dd]]: &Entries, speed: DoubleDouble) -> Quartic {
        let [[a, b], [c, d]] = self.entries(&self.coefficients, speed);
        powers(|i, j| (da[i] * d[j] + a[i] * dd[j]) - (db[i] * c[j] + b[i] * dc[j]))
    }

    fn entries(&self, coefficients: &Coefficients<f64, 2>, speed: DoubleDouble) -> Entries {
        let Coefficients { m, c0, c1, kc, k0, k2 } = coefficients;
        let speed = Sum::from(speed);
        let entry = |i, j| {
            let weight: Sum = DoubleDouble::product(self.gravity, k0[(i, j)]).into();
            let stiffness = Sum::from(kc[(i, j)]) + weight + speed * speed * k2[(i, j)].into();
            [stiffness, Sum::from(c0[(i, j)]) + speed * c1[(i, j)].into(), m[(i, j)].into()]
        };
        [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
    }

    /// How many of the lowest coefficients are zero at all speeds.
    pub(super) fn zeros(&self, speed: DoubleDouble) -> usize {
        let samples = samples(speed).map(|speed| self.characteristic(speed));
        (0..4).take_while(|&power| samples.iter().all(|p| p[power].sign() == 0)).count()
    }

    /// Whether so many of the lowest coefficients stay zero at all speeds in a direction.
    pub(super) fn keeps_zeros(&self, zeros: usize, direction: &Coefficients<f64, 2>, speed: DoubleDouble) -> bool {
        zeros == 0 || samples(speed).iter().all(|&v| self.by(direction, v)[..zeros].iter().all(|p| p.sign() == 0))
    }
}

/// Different speeds, more than the degree of the coefficients, which are polynomials in the speed.
fn samples(speed: DoubleDouble) -> [DoubleDouble; 5] {
    [1.0, 2.0, 3.0, 4.0, 5.0].map(|factor: f64| speed * factor.into())
}

/// The coefficients of a sum of products of two polynomials of the second degree, given the terms of a pair of powers.
fn powers(terms: impl Fn(usize, usize) -> Sum) -> Quartic {
    let mut product = [Sum::ZERO; 5];
    for i in 0..3 {
        for j in 0..3 {
            product[i + j] = product[i + j] + terms(i, j);
        }
    }
    product
}

/// A complex number of two double-doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wide {
    pub(super) re: DoubleDouble,
    pub(super) im: DoubleDouble,
}

impl Wide {
    pub(super) const ZERO: Self = Self { re: DoubleDouble::ZERO, im: DoubleDouble::ZERO };

    pub(super) fn real(re: DoubleDouble) -> Self {
        Self { re, im: DoubleDouble::ZERO }
    }

    pub(super) fn norm(self) -> f64 {
        self.re.to_f64().hypot(self.im.to_f64())
    }
}

impl Neg for Wide {
    type Output = Self;
    fn neg(self) -> Self {
        Self { re: -self.re, im: -self.im }
    }
}

impl Add for Wide {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Sub for Wide {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Wide {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}

impl Div for Wide {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let norm = other.re * other.re + other.im * other.im;
        let product = self * Self { im: -other.im, ..other };
        Self { re: product.re / norm, im: product.im / norm }
    }
}

/// A polynomial in s and its first two derivatives at a point, with the sizes of the terms of the first and the last.
#[derive(Clone, Copy)]
pub(super) struct Taylor {
    value: Wide,
    slope: Wide,
    curvature: Wide,
    size: f64,
    curvature_size: f64,
}

impl Taylor {
    /// Without the lowest coefficients.
    fn new(p: &Quartic, s: Wide, zeros: usize) -> Self {
        let two = Wide::real(2.0.into());
        let [mut value, mut slope, mut half] = [Wide::ZERO; 3];
        let (mut size, mut half_size, mut slope_size) = (0.0, 0.0, 0.0);
        let norm = s.norm();
        for &coefficient in p[zeros..].iter().rev() {
            half = half * s + slope;
            slope = slope * s + value;
            value = value * s + Wide::real(coefficient.value);
            half_size = half_size * norm + slope_size;
            slope_size = slope_size * norm + size;
            size = size * norm + coefficient.size;
        }
        Self { value, slope, curvature: half * two, size, curvature_size: 2.0 * half_size }
    }
}

/// A critical speed with its eigenvalue, in the units of [`Scaled`], and what its condition makes of a change.
///
/// With the characteristic polynomial p, at an eigenvalue that is zero without the factors s that it has at all speeds,
/// the conditions are `p(0) = 0` for capsize, `p(i omega) = 0` for weave, and `p = p_s = 0` for a double root.
pub(super) struct Condition {
    kind: CriticalKind,
    s: Wide,
    /// How many of the lowest coefficients are left out: those that are zero at all speeds, if the eigenvalue is zero.
    pub(super) zeros: usize,
    p: Taylor,
    p_v: Taylor,
    speed: f64,
}

/// By how much a critical speed and its eigenvalue answer to a change.
#[derive(Clone, Copy)]
pub(super) struct Response {
    /// Complex where no real speed answers.
    pub(super) speed: Wide,
    pub(super) eigenvalue: Wide,
    /// The size of the terms that the speed is summed from.
    pub(super) size: f64,
}

impl Condition {
    pub(super) fn new(scaled: &Scaled, kind: CriticalKind, speed: DoubleDouble, s: Wide, zeros: usize) -> Self {
        let p = Taylor::new(&scaled.characteristic(speed), s, zeros);
        let p_v = Taylor::new(&scaled.by_speed(speed), s, zeros);
        Self { kind, s, zeros, p, p_v, speed: speed.to_f64() }
    }

    /// How far the condition is from being met, as a change that would make up for it.
    pub(super) fn residual(&self) -> Response {
        self.answer(&self.p)
    }

    /// The answer to a change of the characteristic polynomial by a derivative of it, which keeps the zeros.
    pub(super) fn response(&self, change: &Quartic) -> Response {
        self.answer(&Taylor::new(change, self.s, self.zeros))
    }

    fn answer(&self, change: &Taylor) -> Response {
        let (p, p_v) = (&self.p, &self.p_v);
        let (speed, eigenvalue) = match self.kind {
            CriticalKind::Capsize => (-change.value / p_v.value, Wide::ZERO),
            CriticalKind::Weave => {
                // p_v dv + i p_s d(omega) = -change, two real equations.
                let by_omega = Wide { re: -p.slope.im, im: p.slope.re };
                let cross = |x: Wide, y: Wide| x.re * y.im - x.im * y.re;
                let determinant = cross(p_v.value, by_omega);
                let omega = -cross(p_v.value, change.value) / determinant;
                let speed = -cross(change.value, by_omega) / determinant;
                (Wide::real(speed), Wide { re: DoubleDouble::ZERO, im: omega })
            }
            CriticalKind::DoubleRoot => {
                let determinant = p_v.value * p.curvature - p.slope * p_v.slope;
                let speed = -(change.value * p.curvature - change.slope * p.slope) / determinant;
                (speed, -(change.slope * p_v.value - change.value * p_v.slope) / determinant)
            }
        };
        Response { speed, eigenvalue, size: change.size * self.leverage() }
    }

    /// By how much the speed may answer to a change of the polynomial by one.
    fn leverage(&self) -> f64 {
        let (p, p_v) = (&self.p, &self.p_v);
        match self.kind {
            CriticalKind::Weave => {
                // The determinant, in a complex product.
                let product = p.slope.norm() * (p_v.value / p.slope).re.abs().to_f64();
                1.0 / product
            }
            _ => 1.0 / p_v.value.norm(),
        }
    }

    /// By how much rounding of the terms of the characteristic polynomial moves the speed, both relative; for a double root
    /// also what it does to the curvature, without which two of them meet.
    pub(super) fn condition(&self) -> f64 {
        let condition = self.p.size * self.leverage() / self.speed;
        let curvature = self.p.curvature_size / self.p.curvature.norm();
        let condition = if self.kind == CriticalKind::DoubleRoot { condition.max(curvature) } else { condition };
        if condition.is_nan() { f64::INFINITY } else { condition }
    }
}
