//! The conditions that define critical speeds, and how their solutions answer to a change of the matrices.

use core::ops::{Add, Div, Mul, Neg, Sub};

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

/// The derivatives of a critical speed and of its eigenvalue with respect to the entries of K, C and M.
pub(super) struct Answers {
    pub(super) speed: ByPower<Rows<Complex<f64>>>,
    pub(super) eigenvalue: ByPower<Rows<Complex<f64>>>,
}

impl Answers {
    const NONE: Self =
        Self { speed: [[[Complex::new(0.0, 0.0); 2]; 2]; 3], eigenvalue: [[[Complex::new(0.0, 0.0); 2]; 2]; 3] };
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
        let (coefficients, by_v) = (shifted(&p, zeros), shifted(&scaled.by_speed(matrices, speed), zeros));
        let at = if is_real(s) {
            Jet::new(coefficients, by_v, s.re).map(ComplexDoubleDouble::real)
        } else {
            Jet::new(coefficients.map(ComplexDoubleDouble::real), by_v.map(ComplexDoubleDouble::real), s)
        };
        let [size, _, half_curvature] = expand_taylor(p[zeros..].iter().map(|p| p.size), s.norm());
        Self { kind, s, zeros, matrices, at, size, curvature_size: 2.0 * half_curvature, speed: speed.to_f64() }
    }

    /// The answers to a change of each entry, which keeps the zeros: the characteristic polynomial changes by the cofactor
    /// of the entry, times 1, s or s^2.
    pub(super) fn answers(&self) -> Answers {
        if self.kind == CriticalKind::Weave {
            self.answers_on_the_axis()
        } else if is_real(self.s) {
            self.answers_of(&Law::new(self.kind, &self.at.map(|part| part.re)), self.s.re)
        } else {
            self.answers_of(&Law::new(self.kind, &self.at), self.s)
        }
    }

    fn answers_of<C: Number>(&self, law: &Law<C>, s: C) -> Answers {
        let zero = C::from(0.0);
        // The derivatives of p with respect to an entry of K, by powers of s.
        let cofactors = self.matrices.map(cofactors);
        let mut answers = Answers::NONE;
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let [c0, c1, c2] = cofactors.each_ref().map(|cofactor| C::from(cofactor[i][j].value));
            let [mut value, mut slope, _] = expand_taylor([c0, c1, c2].into_iter(), s);
            for power in 0..3 {
                if self.zeros > 0 {
                    // At s = 0 they are coefficients.
                    let change = [zero, zero, c0, c1, c2, zero, zero];
                    let at = |place: usize| change.get(place + self.zeros - power).copied().unwrap_or(zero);
                    (value, slope) = (at(2), at(3));
                } else if power > 0 {
                    // Another factor s.
                    (value, slope) = (value * s, value + slope * s);
                }
                [answers.speed[power][i][j], answers.eigenvalue[power][i][j]] = law.answer([value, slope]);
            }
        }
        answers
    }

    /// Those of a pair at `i omega`, in real numbers: `p_v dv + i p_s d(omega) = -change`.
    fn answers_on_the_axis(&self) -> Answers {
        let (at, omega) = (&self.at, self.s.im);
        let by_omega = ComplexDoubleDouble { re: -at.by_s.im, im: at.by_s.re };
        let (inverse, square) = (DoubleDouble::from(1.0) / cross(at.by_v, by_omega), omega * omega);
        let scaled = |x: ComplexDoubleDouble| ComplexDoubleDouble { re: x.re * inverse, im: x.im * inverse };
        let sides = [scaled(by_omega), scaled(at.by_v)];
        let cofactors = self.matrices.map(cofactors);
        let mut answers = Answers::NONE;
        for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let [c0, c1, c2] = cofactors.each_ref().map(|cofactor| cofactor[i][j].value);
            let value = ComplexDoubleDouble { re: c0 - square * c2, im: omega * c1 };
            let next = ComplexDoubleDouble { re: -(omega * value.im), im: omega * value.re };
            for (power, change) in [value, next].into_iter().enumerate() {
                let [speed, frequency] = [-cross(change, sides[0]), -cross(sides[1], change)];
                let at = |power: usize, speed: DoubleDouble, frequency: DoubleDouble, answers: &mut Answers| {
                    answers.speed[power][i][j] = Complex::new(speed.to_f64(), 0.0);
                    answers.eigenvalue[power][i][j] = Complex::new(0.0, frequency.to_f64());
                };
                at(power, speed, frequency, &mut answers);
                if power == 0 {
                    // Another factor s^2 is real.
                    at(2, -(square * speed), -(square * frequency), &mut answers);
                }
            }
        }
        answers
    }

    /// Whether all that follows from it is real.
    pub(super) fn is_real(&self) -> bool {
        is_real(self.s)
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

fn is_real(s: ComplexDoubleDouble) -> bool {
    s.im == DoubleDouble::ZERO
}

/// A real or complex number of twice the precision.
trait Number:
    Copy
    + From<f64>
    + From<DoubleDouble>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    fn to_complex(self) -> Complex<f64>;
}

impl Number for DoubleDouble {
    fn to_complex(self) -> Complex<f64> {
        Complex::new(self.to_f64(), 0.0)
    }
}

impl Number for ComplexDoubleDouble {
    fn to_complex(self) -> Complex<f64> {
        self.to_f64()
    }
}

/// The answers to a change of p and of its slope, without the equations that they solve.
enum Law<C> {
    /// What the change of p is multiplied by.
    Value(C),
    /// What speed and eigenvalue answer to a change of p, and of its slope, by one.
    ValueAndSlope { by_value: [C; 2], by_slope: [C; 2] },
}

impl<C: Number> Law<C> {
    /// Of a capsize speed, or of a double root.
    fn new(kind: CriticalKind, at: &Jet<C>) -> Self {
        let one = C::from(1.0);
        if kind == CriticalKind::Capsize {
            return Self::Value(-(one / at.by_v));
        }
        let inverse = one / at.determinant();
        let [by_slope, by_value] =
            [[0.0, 1.0], [1.0, 0.0]].map(|change| at.step_against(change.map(C::from)).map(|step| step * inverse));
        Self::ValueAndSlope { by_value, by_slope }
    }

    fn answer(&self, [value, slope]: [C; 2]) -> [Complex<f64>; 2] {
        match self {
            Self::Value(factor) => [(value * *factor).to_complex(), Complex::new(0.0, 0.0)],
            Self::ValueAndSlope { by_value, by_slope } => {
                [0, 1].map(|of| (by_value[of] * value + by_slope[of] * slope).to_complex())
            }
        }
    }
}

/// Newton's step of speed and eigenvalue to where the condition is met: with what is left of it in twice the precision, and
/// derivatives in `f64`, which leave as much of the step as they err by.
pub(super) fn newton_step(
    scaled: &Scaled,
    kind: CriticalKind,
    speed: DoubleDouble,
    s: ComplexDoubleDouble,
    zeros: usize,
) -> [Complex<f64>; 2] {
    let matrices = scaled.matrices(speed);
    let p = shifted(&determinant::coefficients(matrices), zeros);
    let [value, slope] = if is_real(s) {
        let [value, slope, _] = expand_taylor(p.into_iter(), s.re);
        [value, slope].map(Number::to_complex)
    } else {
        let [value, slope, _] = expand_taylor(p.into_iter().map(ComplexDoubleDouble::real), s);
        [value, slope].map(Number::to_complex)
    };
    let none = Complex::new(0.0, 0.0);
    let by_v = scaled.rounded_by_speed(matrices, speed.to_f64());
    let by_v = core::array::from_fn(|power| by_v.get(power + zeros).map_or(none, |by_v| Complex::new(*by_v, 0.0)));
    let jet = Jet::new(p.map(Number::to_complex), by_v, s.to_f64());
    match kind {
        CriticalKind::Capsize => [-value / jet.by_v, none],
        CriticalKind::Weave => {
            // p_v dv + i p_s d(omega) = -p, two real equations.
            let cross = |x: Complex<f64>, y: Complex<f64>| x.re * y.im - x.im * y.re;
            let by_omega = Complex::new(-jet.by_s.im, jet.by_s.re);
            let determinant = cross(jet.by_v, by_omega);
            let step = [-cross(value, by_omega), -cross(jet.by_v, value)].map(|step| step / determinant);
            [Complex::new(step[0], 0.0), Complex::new(0.0, step[1])]
        }
        CriticalKind::DoubleRoot => jet.step_against([value, slope]).map(|step| step / jet.determinant()),
    }
}

fn cross(x: ComplexDoubleDouble, y: ComplexDoubleDouble) -> DoubleDouble {
    x.re * y.im - x.im * y.re
}

/// The coefficients without the lowest ones.
fn shifted(p: &Quartic, zeros: usize) -> [DoubleDouble; 5] {
    let mut shifted = [DoubleDouble::ZERO; 5];
    for (place, p) in shifted.iter_mut().zip(&p[zeros..]) {
        *place = p.value;
    }
    shifted
}
