//! Complex numbers with twice the precision of `f64`.

use core::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::Complex;

use super::double_double::DoubleDouble;

/// A complex number of two double-doubles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ComplexDoubleDouble {
    pub(crate) re: DoubleDouble,
    pub(crate) im: DoubleDouble,
}

impl ComplexDoubleDouble {
    pub(crate) const ZERO: Self = Self { re: DoubleDouble::ZERO, im: DoubleDouble::ZERO };

    pub(crate) fn real(re: DoubleDouble) -> Self {
        Self { re, im: DoubleDouble::ZERO }
    }

    pub(crate) fn to_f64(self) -> Complex<f64> {
        Complex::new(self.re.to_f64(), self.im.to_f64())
    }

    pub(crate) fn norm(self) -> f64 {
        self.re.to_f64().hypot(self.im.to_f64())
    }
}

impl From<f64> for ComplexDoubleDouble {
    fn from(re: f64) -> Self {
        Self::real(re.into())
    }
}

impl Neg for ComplexDoubleDouble {
    type Output = Self;
    fn neg(self) -> Self {
        Self { re: -self.re, im: -self.im }
    }
}

impl Add for ComplexDoubleDouble {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { re: self.re + other.re, im: self.im + other.im }
    }
}

impl Sub for ComplexDoubleDouble {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for ComplexDoubleDouble {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { re: self.re * other.re - self.im * other.im, im: self.re * other.im + self.im * other.re }
    }
}

impl Div for ComplexDoubleDouble {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let norm = other.re * other.re + other.im * other.im;
        let product = self * Self { im: -other.im, ..other };
        Self { re: product.re / norm, im: product.im / norm }
    }
}
