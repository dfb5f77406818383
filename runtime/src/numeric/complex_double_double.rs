//! Complex numbers with twice the precision of `f64`.

use core::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::Complex;

use super::double_double::DoubleDouble;

/// A complex number of two double-doubles.
///
/// Products leave out what a part of exactly zero makes nothing of: real numbers and those on the imaginary axis, of which
/// there are many here, take a half or a quarter of the work.
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

impl From<DoubleDouble> for ComplexDoubleDouble {
    fn from(re: DoubleDouble) -> Self {
        Self::real(re)
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
        Self {
            re: sum_of_products([self.re, -self.im], [other.re, other.im]),
            im: sum_of_products([self.re, self.im], [other.im, other.re]),
        }
    }
}

/// The sum of two products, of which those with zero are left out.
fn sum_of_products(x: [DoubleDouble; 2], y: [DoubleDouble; 2]) -> DoubleDouble {
    let is_zero = |of: usize| x[of].to_f64() == 0.0 || y[of].to_f64() == 0.0;
    match [is_zero(0), is_zero(1)] {
        [true, true] => DoubleDouble::ZERO,
        [false, true] => x[0] * y[0],
        [true, false] => x[1] * y[1],
        [false, false] => x[0] * y[0] + x[1] * y[1],
    }
}

impl Div for ComplexDoubleDouble {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        if other.im.to_f64() == 0.0 {
            return Self { re: self.re / other.re, im: self.im / other.re };
        }
        let norm = other.re * other.re + other.im * other.im;
        let product = self * Self { im: -other.im, ..other };
        Self { re: product.re / norm, im: product.im / norm }
    }
}
