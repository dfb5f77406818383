//! The conditions that define critical speeds, and how their solutions answer to a change of the matrices.

use nalgebra::Complex;

use super::scaled::{Quartic, Scaled};
use crate::characteristic::determinant::{self, ByPower, Rows, cofactors};
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
    /// K, C and M at the speed.
    matrices: ByPower<Rows<Tracked>>,
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
        let matrices = scaled.matrices(speed);
        let p = determinant::coefficients(matrices);
        let at = Jet::new(shifted(&p, zeros), shifted(&scaled.by_speed(matrices, speed), zeros), s);
        let [size, _, half_curvature] = expand_taylor(p[zeros..].iter().map(|p| p.size), s.norm());
        Self { kind, s, zeros, matrices, at, size, curvature_size: 2.0 * half_curvature, speed: speed.to_f64() }
    }

    /// How far the condition is from being met, as a change that would make up for it.
    pub(super) fn residual(&self) -> Response {
        self.law().answer([self.at.p, self.at.by_s])
    }

    /// The answers to a change of each entry, which keeps the zeros: the characteristic polynomial changes by the cofactor
    /// of the entry, times 1, s or s^2.
    pub(super) fn answers(&self) -> Answers {
        let (law, zero) = (self.law(), ComplexDoubleDouble::ZERO);
        // The derivatives of p with respect to an entry of K, by powers of s.
        let cofactors = self.matrices.map(cofactors);
        let none = [[[Complex::new(0.0, 0.0); 2]; 2]; 3];
        let mut answers = Answers { speed: none, eigenvalue: none };
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let [c0, c1, c2] = cofactors.each_ref().map(|cofactor| ComplexDoubleDouble::real(cofactor[i][j].value));
            let [mut value, mut slope, _] = expand_taylor([c0, c1, c2].into_iter(), self.s);
            for power in 0..3 {
                if self.zeros > 0 {
                    // At s = 0 they are coefficients.
                    let change = [zero, zero, c0, c1, c2, zero, zero];
                    let at = |place: usize| change.get(place + self.zeros - power).copied().unwrap_or(zero);
                    (value, slope) = (at(2), at(3));
                } else if power > 0 {
                    // Another factor s.
                    (value, slope) = (value * self.s, value + slope * self.s);
                }
                let Response { speed, eigenvalue } = law.answer([value, slope]);
                answers.speed[power][i][j] = speed.to_f64();
                answers.eigenvalue[power][i][j] = eigenvalue.to_f64();
            }
        }
        answers
    }

    /// The law by which speed and eigenvalue answer to a change of p and of its slope in s.
    fn law(&self) -> Law {
        let at = &self.at;
        let one = ComplexDoubleDouble::from(1.0);
        match self.kind {
            CriticalKind::Capsize => Law::Capsize(-(one / at.by_v)),
            CriticalKind::Weave => {
                // p_v dv + i p_s d(omega) = -change, two real equations.
                let by_omega = ComplexDoubleDouble { re: -at.by_s.im, im: at.by_s.re };
                let inverse = DoubleDouble::from(1.0) / cross(at.by_v, by_omega);
                let scaled = |x: ComplexDoubleDouble| ComplexDoubleDouble { re: x.re * inverse, im: x.im * inverse };
                Law::Weave { by_v: scaled(at.by_v), by_omega: scaled(by_omega) }
            }
            CriticalKind::DoubleRoot => {
                let inverse = one / at.determinant();
                let [by_slope, by_value] = [[0.0, 1.0], [1.0, 0.0]].map(|change| {
                    let change = change.map(ComplexDoubleDouble::from);
                    at.step_against(change).map(|step| step * inverse)
                });
                Law::DoubleRoot { by_value, by_slope }
            }
        }
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

/// The answers to a change of p and of its slope, without the equations that they solve.
enum Law {
    /// What the change of p is multiplied by.
    Capsize(ComplexDoubleDouble),
    /// The derivatives of p, divided by their determinant.
    Weave { by_v: ComplexDoubleDouble, by_omega: ComplexDoubleDouble },
    /// What speed and eigenvalue answer to a change of p, and of its slope, by one.
    DoubleRoot { by_value: [ComplexDoubleDouble; 2], by_slope: [ComplexDoubleDouble; 2] },
}

impl Law {
    fn answer(&self, [value, slope]: [ComplexDoubleDouble; 2]) -> Response {
        match *self {
            Self::Capsize(factor) => Response { speed: value * factor, eigenvalue: ComplexDoubleDouble::ZERO },
            Self::Weave { by_v, by_omega } => {
                let eigenvalue = ComplexDoubleDouble { re: DoubleDouble::ZERO, im: -cross(by_v, value) };
                Response { speed: ComplexDoubleDouble::real(-cross(value, by_omega)), eigenvalue }
            }
            Self::DoubleRoot { by_value, by_slope } => {
                let [speed, eigenvalue] = [0, 1].map(|of| by_value[of] * value + by_slope[of] * slope);
                Response { speed, eigenvalue }
            }
        }
    }
}

fn cross(x: ComplexDoubleDouble, y: ComplexDoubleDouble) -> DoubleDouble {
    x.re * y.im - x.im * y.re
}

/// The coefficients without the lowest ones.
fn shifted(p: &Quartic, zeros: usize) -> [ComplexDoubleDouble; 5] {
    let mut shifted = [ComplexDoubleDouble::ZERO; 5];
    for (place, p) in shifted.iter_mut().zip(&p[zeros..]) {
        *place = ComplexDoubleDouble::real(p.value);
    }
    shifted
}
