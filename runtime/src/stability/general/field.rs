//! Real and complex numbers in either precision, for what is first done in `f64` and then once more with twice its digits.

use core::ops::{Add, Div, Mul, Neg, Sub};

use nalgebra::Complex;

use crate::numeric::{ComplexDoubleDouble, DoubleDouble};

/// A real number.
pub(super) trait RealField:
    Copy
    + From<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    fn to_f64(self) -> f64;
}

/// A complex number, or a real one in its place where nothing is complex.
pub(super) trait ComplexField:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    type Real: RealField;
    fn real(re: Self::Real) -> Self;
    fn times(self, factor: Self::Real) -> Self;
    fn to_complex(self) -> Complex<f64>;

    fn norm(self) -> f64 {
        let Complex { re, im } = self.to_complex();
        re.hypot(im)
    }
}

/// A number with an imaginary part.
pub(super) trait Imaginary: ComplexField {
    fn new(re: Self::Real, im: Self::Real) -> Self;
    fn parts(self) -> [Self::Real; 2];
}

impl RealField for f64 {
    #[inline]
    fn to_f64(self) -> f64 {
        self
    }
}

impl RealField for DoubleDouble {
    #[inline]
    fn to_f64(self) -> f64 {
        DoubleDouble::to_f64(self)
    }
}

impl<R: RealField> ComplexField for R {
    type Real = R;
    #[inline]
    fn real(re: R) -> Self {
        re
    }
    #[inline]
    fn times(self, factor: R) -> Self {
        self * factor
    }
    #[inline]
    fn to_complex(self) -> Complex<f64> {
        Complex::new(self.to_f64(), 0.0)
    }
    #[inline]
    fn norm(self) -> f64 {
        self.to_f64().abs()
    }
}

impl ComplexField for Complex<f64> {
    type Real = f64;
    #[inline]
    fn real(re: f64) -> Self {
        Complex::new(re, 0.0)
    }
    #[inline]
    fn times(self, factor: f64) -> Self {
        Complex::new(self.re * factor, self.im * factor)
    }
    #[inline]
    fn to_complex(self) -> Complex<f64> {
        self
    }
}

impl Imaginary for Complex<f64> {
    fn new(re: f64, im: f64) -> Self {
        Complex { re, im }
    }
    fn parts(self) -> [f64; 2] {
        [self.re, self.im]
    }
}

impl ComplexField for ComplexDoubleDouble {
    type Real = DoubleDouble;
    #[inline]
    fn real(re: DoubleDouble) -> Self {
        ComplexDoubleDouble::real(re)
    }
    #[inline]
    fn times(self, factor: DoubleDouble) -> Self {
        Self { re: self.re * factor, im: self.im * factor }
    }
    #[inline]
    fn to_complex(self) -> Complex<f64> {
        self.to_f64()
    }
}

impl Imaginary for ComplexDoubleDouble {
    fn new(re: DoubleDouble, im: DoubleDouble) -> Self {
        Self { re, im }
    }
    fn parts(self) -> [DoubleDouble; 2] {
        [self.re, self.im]
    }
}
