//! Eigenvalues and critical speeds to all digits, by Newton's iteration on the determinant of the pencil.

use nalgebra::Complex;

use super::equations::Equations;
use super::field::{Imaginary, RealField as _};
use super::inverse::{Slopes, precise_determinant};
use crate::numeric::{ComplexDoubleDouble, DoubleDouble};

/// A speed at which an eigenvalue `i omega` is on the imaginary axis; zero for omega where there is nothing to oscillate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    /// The scaled speed.
    pub(super) v: DoubleDouble,
    /// The scaled frequency.
    pub(super) omega: f64,
    /// What a rounding of the coefficients may do to the scaled speed, to first order.
    pub(super) error: f64,
    /// The derivative of the real part of the eigenvalue by the speed, both scaled.
    pub(super) growth: f64,
}

/// The bound on steps in `f64`: simple crossings take about four.
const STEPS: usize = 40;

/// The steps in twice the precision, each of which doubles the digits.
const FINE_STEPS: usize = 3;

/// The last step in `f64`, relative to the speed, from where on there are digits to be doubled.
const CLOSE: f64 = 1e-9;

/// The last step in twice the precision, relative: the next one would be of the order of its square.
const LAST: f64 = 1.0 / (1u64 << 42) as f64;

impl Equations {
    /// The speed and the frequency near given ones at which a pair is on the imaginary axis.
    pub(super) fn find_flutter(&self, v: f64, omega: f64) -> Option<Crossing> {
        let (mut v, mut omega) = (v, omega);
        let mut is_close = false;
        for _ in 0..STEPS {
            let ([dv, domega], _) = self.flutter_step::<Complex<f64>>(v, omega)?;
            (v, omega) = (v + dv, omega + domega);
            if !(v > 0.0 && omega > 0.0 && v.is_finite() && omega.is_finite()) {
                return None;
            }
            is_close = dv.abs() <= CLOSE * v && domega.abs() <= CLOSE * omega;
            if is_close {
                break;
            }
        }
        if !is_close {
            return None;
        }
        let (mut fine_v, mut fine_omega) = (DoubleDouble::from(v), DoubleDouble::from(omega));
        let mut steps = 0;
        loop {
            let ([dv, domega], slopes) = self.flutter_step::<ComplexDoubleDouble>(fine_v, fine_omega)?;
            if dv.to_f64().is_nan() || dv.to_f64().abs() > CLOSE * v {
                return None;
            }
            (fine_v, fine_omega) = (fine_v + dv, fine_omega + domega);
            steps += 1;
            if dv.to_f64().abs() <= LAST * v || steps == FINE_STEPS {
                let rate = -(slopes.by_v.to_f64() / slopes.by_s.to_f64());
                let rounding = slopes.rounding(&self.magnitudes(omega, v));
                let error = rounding / slopes.by_s.norm() / rate.re.abs();
                return Some(Crossing { v: fine_v, omega: fine_omega.to_f64(), error, growth: rate.re });
            }
        }
    }

    /// Newton's step of the speed and of the frequency, if there is one, and the derivatives that it is from: the determinant is
    /// zero as a complex number at two unknowns that are real.
    fn flutter_step<C: Imaginary>(&self, v: C::Real, omega: C::Real) -> Option<([C::Real; 2], Slopes<C>)> {
        let zero = C::Real::from(0.0);
        let slopes = Slopes::new(&self.pencil(C::new(zero, omega), v));
        let ([by_s, i_by_s], [by_v, i_by_v]) = (slopes.by_s.parts(), slopes.by_v.parts());
        // i by_s domega + by_v dv = -1.
        let determinant = -(i_by_s * i_by_v) - by_s * by_v;
        let step = [by_s / determinant, -(i_by_v / determinant)];
        step.iter().all(|step| step.to_f64().is_finite()).then_some((step, slopes))
    }

    /// The speed near a given one at which an eigenvalue is zero.
    pub(super) fn find_divergence(&self, v: f64) -> Option<Crossing> {
        let mut v = v;
        let mut is_close = false;
        for _ in 0..STEPS {
            let dv = -1.0 / Slopes::new(&self.pencil(0.0, v)).by_v;
            v += dv;
            if !(v > 0.0 && v.is_finite()) {
                return None;
            }
            is_close = dv.abs() <= CLOSE * v;
            if is_close {
                break;
            }
        }
        if !is_close {
            return None;
        }
        let mut fine = DoubleDouble::from(v);
        for _ in 0..FINE_STEPS {
            let dv = -(DoubleDouble::from(1.0) / Slopes::new(&self.pencil(DoubleDouble::ZERO, fine)).by_v);
            if dv.to_f64().is_nan() || dv.to_f64().abs() > CLOSE * v {
                return None;
            }
            fine = fine + dv;
            if dv.to_f64().abs() <= LAST * v {
                break;
            }
        }
        let slopes = Slopes::new(&self.pencil(0.0, fine.to_f64()));
        let error = slopes.rounding(&self.magnitudes(0.0, v)) / slopes.by_v.abs();
        Some(Crossing { v: fine, omega: 0.0, error, growth: -slopes.by_v / slopes.by_s })
    }

    /// The speed near a given one at which the lowest coefficient of the characteristic polynomial is zero that is not so at
    /// all speeds, by the secant method.
    pub(super) fn find_divergence_beside(&self, v: f64, drifts: usize) -> Option<Crossing> {
        let mut last = (DoubleDouble::from(v), self.lowest_coefficient(v.into(), drifts));
        let mut fine = DoubleDouble::from(v * (1.0 + CLOSE));
        for _ in 0..STEPS {
            let (value, size) = self.lowest_coefficient(fine, drifts);
            let slope = (value - last.1.0) / (fine - last.0);
            let dv = -(value / slope);
            if !dv.to_f64().is_finite() {
                return None;
            }
            last = (fine, (value, size));
            fine = fine + dv;
            if dv.to_f64().abs() <= f64::EPSILON * CLOSE * fine.to_f64().abs() {
                let error = f64::EPSILON * size / slope.to_f64().abs();
                return (fine.to_f64() > 0.0).then_some(Crossing { v: fine, omega: 0.0, error, growth: f64::NAN });
            }
        }
        None
    }

    /// The coefficient of `s^drifts` of the determinant, extrapolated to s = 0 from as many numbers s as the degree takes, and
    /// the sum of the magnitudes of its terms.
    fn lowest_coefficient(&self, v: DoubleDouble, drifts: usize) -> (DoubleDouble, f64) {
        let count = self.states().saturating_sub(drifts) + 1;
        // 1, -1, 2, -2 and so on, in the unit in which eigenvalues are about one.
        let point = |k: usize| (k / 2 + 1) as f64 * if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        let (mut sum, mut size) = (DoubleDouble::ZERO, 0.0);
        for k in 0..count {
            let s = point(k);
            let mut term = precise_determinant(self.pencil(DoubleDouble::from(s), v).value);
            for _ in 0..drifts {
                term = term / s.into();
            }
            for other in (0..count).filter(|&other| other != k).map(point) {
                term = term * DoubleDouble::from(other) / (other - s).into();
            }
            sum = sum + term;
            size += term.to_f64().abs();
        }
        (sum, size)
    }

    /// The speed and the frequency near given ones at which two pairs meet on the imaginary axis, for eigenvalues that are
    /// symmetric about it: the determinant and its derivative by s are zero together, and both unknowns are real.
    pub(super) fn find_meeting(&self, v: f64, omega: f64) -> Option<Crossing> {
        let (mut fine_v, mut fine_omega) = (DoubleDouble::from(v), DoubleDouble::from(omega));
        for _ in 0..STEPS {
            let pencil = self.pencil(ComplexDoubleDouble { re: DoubleDouble::ZERO, im: fine_omega }, fine_v);
            let slopes = Slopes::new(&pencil);
            let (by_s, by_v) = (slopes.by_s, slopes.by_v);
            let [by_ss, by_sv] = slopes.second(&pencil);
            // Newton's step for the determinant d and its derivative d', in terms of the logarithm.
            let divisor = by_s * by_sv - by_v * by_ss;
            let dv = (by_ss / divisor).re;
            let domega = (-by_sv / divisor).im;
            if !(dv.to_f64().is_finite() && domega.to_f64().is_finite()) {
                return None;
            }
            (fine_v, fine_omega) = (fine_v + dv, fine_omega + domega);
            if !(fine_v.to_f64() > 0.0 && fine_omega.to_f64() > 0.0) {
                return None;
            }
            if dv.to_f64().abs() <= LAST * fine_v.to_f64() {
                let rounding = slopes.rounding(&self.magnitudes(fine_omega.to_f64(), fine_v.to_f64()));
                let error = rounding / by_v.norm();
                return Some(Crossing { v: fine_v, omega: fine_omega.to_f64(), error, growth: 0.0 });
            }
        }
        None
    }

    /// The eigenvalue near a given one at a scaled speed, in twice the precision, and what a rounding of the coefficients
    /// may do to it.
    pub(super) fn refine(&self, s: Complex<f64>, v: f64) -> Option<(Complex<f64>, f64)> {
        let near = s.norm().max(f64::MIN_POSITIVE);
        let mut fine = ComplexDoubleDouble { re: s.re.into(), im: s.im.into() };
        let one = ComplexDoubleDouble::from(1.0);
        for _ in 0..STEPS {
            let slopes = Slopes::new(&self.pencil(fine, v.into()));
            let step = one / slopes.by_s;
            if !step.norm().is_finite() {
                return None;
            }
            fine = fine - step;
            if step.norm() <= LAST * near.max(fine.norm()) {
                let rounding = slopes.rounding(&self.magnitudes(fine.norm(), v));
                return Some((fine.to_f64(), rounding / slopes.by_s.norm()));
            }
        }
        None
    }

    /// The derivative of an eigenvalue by the speed, both scaled.
    pub(super) fn rate(&self, s: Complex<f64>, v: f64) -> Complex<f64> {
        let slopes = Slopes::new(&self.pencil(s, v));
        -(slopes.by_v / slopes.by_s)
    }
}
