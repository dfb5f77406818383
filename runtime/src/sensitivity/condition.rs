//! The conditions that define critical speeds, and how their solutions answer to a change of the matrices.

use nalgebra::Complex;

use super::scaled::{Entries, Quartic, Scaled};
use crate::number::real::Real as _;
use crate::numeric::{ComplexDoubleDouble, DoubleDouble, Tracked};
use crate::stability::CriticalKind;

/// A polynomial in s and its first two derivatives at a point, with the sizes of the terms of the first and the last.
#[derive(Clone, Copy)]
pub(super) struct Taylor {
    value: ComplexDoubleDouble,
    slope: ComplexDoubleDouble,
    curvature: ComplexDoubleDouble,
    size: f64,
    curvature_size: f64,
}

impl Taylor {
    /// Without the lowest coefficients.
    fn new(p: &Quartic, s: ComplexDoubleDouble, zeros: usize) -> Self {
        let two = ComplexDoubleDouble::real(2.0.into());
        let [mut value, mut slope, mut half] = [ComplexDoubleDouble::ZERO; 3];
        let (mut size, mut half_size, mut slope_size) = (0.0, 0.0, 0.0);
        let norm = s.norm();
        for &coefficient in p[zeros..].iter().rev() {
            half = half * s + slope;
            slope = slope * s + value;
            value = value * s + ComplexDoubleDouble::real(coefficient.value);
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
    s: ComplexDoubleDouble,
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
    pub(super) speed: ComplexDoubleDouble,
    pub(super) eigenvalue: ComplexDoubleDouble,
}

/// The derivatives of a critical speed and of its eigenvalue with respect to the entries of K, C and M.
pub(super) struct Answers {
    pub(super) speed: Entries<Complex<f64>>,
    pub(super) eigenvalue: Entries<Complex<f64>>,
}

impl Condition {
    pub(super) fn new(
        scaled: &Scaled,
        kind: CriticalKind,
        speed: DoubleDouble,
        s: ComplexDoubleDouble,
        zeros: usize,
    ) -> Self {
        let p = Taylor::new(&scaled.characteristic(speed), s, zeros);
        let p_v = Taylor::new(&scaled.by_speed(speed), s, zeros);
        Self { kind, s, zeros, p, p_v, speed: speed.to_f64() }
    }

    /// How far the condition is from being met, as a change that would make up for it.
    pub(super) fn residual(&self) -> Response {
        self.answer(&self.p)
    }

    /// The answers to a change of each entry, which keeps the zeros: the characteristic polynomial changes by the cofactor
    /// of the entry, times 1, s or s^2.
    pub(super) fn answers(&self, scaled: &Scaled, speed: DoubleDouble) -> Answers {
        let [[a, b], [c, d]] = scaled.matrices(speed);
        let of = |cofactor: [Tracked; 3], power: usize| {
            let mut change = [Tracked::ZERO; 5];
            change[power..power + 3].copy_from_slice(&cofactor);
            self.answer(&Taylor::new(&change, self.s, self.zeros))
        };
        let of_entry = |cofactor: [Tracked; 3]| [0, 1, 2].map(|power| of(cofactor, power));
        let negative = |entry: [Tracked; 3]| entry.map(|sum| -sum);
        let all = [[of_entry(d), of_entry(negative(c))], [of_entry(negative(b)), of_entry(a)]];
        let part = |part: fn(&Response) -> ComplexDoubleDouble| {
            all.map(|row| row.map(|entry| entry.map(|r| part(&r).to_f64())))
        };
        Answers { speed: part(|response| response.speed), eigenvalue: part(|response| response.eigenvalue) }
    }

    fn answer(&self, change: &Taylor) -> Response {
        let (p, p_v) = (&self.p, &self.p_v);
        let (speed, eigenvalue) = match self.kind {
            CriticalKind::Capsize => (-change.value / p_v.value, ComplexDoubleDouble::ZERO),
            CriticalKind::Weave => {
                // p_v dv + i p_s d(omega) = -change, two real equations.
                let by_omega = ComplexDoubleDouble { re: -p.slope.im, im: p.slope.re };
                let cross = |x: ComplexDoubleDouble, y: ComplexDoubleDouble| x.re * y.im - x.im * y.re;
                let determinant = cross(p_v.value, by_omega);
                let omega = -cross(p_v.value, change.value) / determinant;
                let speed = -cross(change.value, by_omega) / determinant;
                (ComplexDoubleDouble::real(speed), ComplexDoubleDouble { re: DoubleDouble::ZERO, im: omega })
            }
            CriticalKind::DoubleRoot => {
                let determinant = p_v.value * p.curvature - p.slope * p_v.slope;
                let speed = -(change.value * p.curvature - change.slope * p.slope) / determinant;
                (speed, -(change.slope * p_v.value - change.value * p_v.slope) / determinant)
            }
        };
        Response { speed, eigenvalue }
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
