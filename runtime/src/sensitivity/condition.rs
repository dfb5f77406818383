//! The conditions that define critical speeds, and how their solutions answer to a change of the matrices.

use nalgebra::Complex;

use super::scaled::{Quartic, Scaled};
use crate::characteristic::determinant::{ByPower, Rows, cofactors};
use crate::characteristic::double_root::Jet;
use crate::number::real::Real as _;
use crate::numeric::{ComplexDoubleDouble, DoubleDouble, Tracked, expand_taylor};
use crate::stability::CriticalKind;

/// A critical speed with its eigenvalue, in the units of [`Scaled`], and what its condition makes of a change.
///
/// With the characteristic polynomial p, at an eigenvalue that is zero without the factors s that it has at all speeds,
/// the conditions are `p(0) = 0` for capsize, `p(i omega) = 0` for weave, and `p = p_s = 0` for a double root.
pub(super) struct Condition {
    kind: CriticalKind,
    s: ComplexDoubleDouble,
    /// How many of the lowest coefficients are left out: those that are zero at all speeds, if the eigenvalue is zero.
    pub(super) zeros: usize,
    /// p and its derivatives.
    at: Jet<ComplexDoubleDouble>,
    /// The size of the terms of p.
    size: f64,
    /// The size of the terms of its curvature in s.
    curvature_size: f64,
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
    pub(super) speed: ByPower<Rows<Complex<f64>>>,
    pub(super) eigenvalue: ByPower<Rows<Complex<f64>>>,
}

impl Condition {
    pub(super) fn new(
        scaled: &Scaled,
        kind: CriticalKind,
        speed: DoubleDouble,
        s: ComplexDoubleDouble,
        zeros: usize,
    ) -> Self {
        let p = scaled.characteristic(speed);
        let at = Jet::new(shifted(&p, zeros), shifted(&scaled.by_speed(speed), zeros), s);
        let [size, _, half_curvature] = expand_taylor(p[zeros..].iter().map(|p| p.size), s.norm());
        Self { kind, s, zeros, at, size, curvature_size: 2.0 * half_curvature, speed: speed.to_f64() }
    }

    /// How far the condition is from being met, as a change that would make up for it.
    pub(super) fn residual(&self) -> Response {
        self.answer([self.at.p, self.at.by_s])
    }

    /// The answers to a change of each entry, which keeps the zeros: the characteristic polynomial changes by the cofactor
    /// of the entry, times 1, s or s^2.
    pub(super) fn answers(&self, scaled: &Scaled, speed: DoubleDouble) -> Answers {
        // The derivatives of p with respect to an entry of each of the matrices K, C and M.
        let cofactors = scaled.matrices(speed).map(cofactors);
        let answer = |power: usize, i: usize, j: usize| {
            let mut change = [Tracked::ZERO; 5];
            for (coefficient, cofactor) in change[power..].iter_mut().zip(&cofactors) {
                *coefficient = cofactor[i][j];
            }
            let [value, slope, _] = expand_taylor(shifted(&change, self.zeros).into_iter(), self.s);
            self.answer([value, slope])
        };
        let rows = |power| [0, 1].map(|i| [0, 1].map(|j| answer(power, i, j)));
        let all = [0, 1, 2].map(rows);
        let part =
            |part: fn(&Response) -> ComplexDoubleDouble| all.map(|rows| rows.map(|row| row.map(|r| part(&r).to_f64())));
        Answers { speed: part(|response| response.speed), eigenvalue: part(|response| response.eigenvalue) }
    }

    /// The answer to a change of p and of its slope in s.
    fn answer(&self, [value, slope]: [ComplexDoubleDouble; 2]) -> Response {
        let at = &self.at;
        let (speed, eigenvalue) = match self.kind {
            CriticalKind::Capsize => (-value / at.by_v, ComplexDoubleDouble::ZERO),
            CriticalKind::Weave => {
                // p_v dv + i p_s d(omega) = -change, two real equations.
                let by_omega = ComplexDoubleDouble { re: -at.by_s.im, im: at.by_s.re };
                let cross = |x: ComplexDoubleDouble, y: ComplexDoubleDouble| x.re * y.im - x.im * y.re;
                let determinant = cross(at.by_v, by_omega);
                let omega = -cross(at.by_v, value) / determinant;
                let speed = -cross(value, by_omega) / determinant;
                (ComplexDoubleDouble::real(speed), ComplexDoubleDouble { re: DoubleDouble::ZERO, im: omega })
            }
            CriticalKind::DoubleRoot => {
                let [speed, eigenvalue] = at.step_against([value, slope]);
                let determinant = at.determinant();
                (speed / determinant, eigenvalue / determinant)
            }
        };
        Response { speed, eigenvalue }
    }

    /// By how much the speed may answer to a change of the polynomial by one.
    fn leverage(&self) -> f64 {
        let Jet { by_s, by_v, .. } = self.at;
        match self.kind {
            CriticalKind::Weave => {
                // The determinant, in a complex product.
                let product = by_s.norm() * (by_v / by_s).re.abs().to_f64();
                1.0 / product
            }
            _ => 1.0 / by_v.norm(),
        }
    }

    /// By how much rounding of the terms of the characteristic polynomial moves the speed, both relative; for a double root
    /// also what it does to the curvature, without which two of them meet.
    pub(super) fn condition(&self) -> f64 {
        let condition = self.size * self.leverage() / self.speed;
        let curvature = self.curvature_size / self.at.by_ss.norm();
        let condition = if self.kind == CriticalKind::DoubleRoot { condition.max(curvature) } else { condition };
        if condition.is_nan() { f64::INFINITY } else { condition }
    }
}

/// The coefficients without the lowest ones.
fn shifted(p: &Quartic, zeros: usize) -> [ComplexDoubleDouble; 5] {
    let mut shifted = [ComplexDoubleDouble::ZERO; 5];
    for (place, p) in shifted.iter_mut().zip(&p[zeros..]) {
        *place = ComplexDoubleDouble::real(p.value);
    }
    shifted
}
