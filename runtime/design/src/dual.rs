//! Numbers with their derivative, so that each formula also says how its value changes: what a deviation becomes in a
//! conversion, and where an optimum lies.

use std::ops::{Add, Div, Mul, Neg, Sub};

/// A number, and its derivative with respect to whatever is varied.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Dual {
    /// The number.
    pub value: f64,
    /// Its derivative.
    pub slope: f64,
}

impl Dual {
    /// A number that does not vary.
    pub const fn constant(value: f64) -> Self {
        Self { value, slope: 0.0 }
    }

    /// A function of one number, from its value and its derivative there.
    pub fn chain(self, value: f64, derivative: f64) -> Self {
        // What does not vary stays so where the derivative is infinite, as that of a root at zero.
        Self { value, slope: if self.slope == 0.0 { 0.0 } else { derivative * self.slope } }
    }

    /// Sine and cosine.
    pub fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = self.value.sin_cos();
        (self.chain(sin, cos), self.chain(cos, -sin))
    }

    /// The square.
    pub fn square(self) -> Self {
        self * self
    }

    /// The square root.
    pub fn sqrt(self) -> Self {
        let root = self.value.sqrt();
        self.chain(root, 0.5 / root)
    }

    /// The angle whose sine it is.
    pub fn asin(self) -> Self {
        self.chain(self.value.asin(), 1.0 / (1.0 - self.value * self.value).sqrt())
    }

    /// The angle of the direction with the components `x` and `self`.
    pub fn atan2(self, x: Self) -> Self {
        let square = self.value * self.value + x.value * x.value;
        let slope = self.slope * x.value - x.slope * self.value;
        Self { value: self.value.atan2(x.value), slope: if slope == 0.0 { 0.0 } else { slope / square } }
    }

    /// The larger one.
    pub fn max(self, other: Self) -> Self {
        if self.value >= other.value { self } else { other }
    }

    /// Its distance from zero.
    pub fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { self }
    }

    /// A power.
    pub fn powf(self, exponent: Self) -> Self {
        let value = self.value.powf(exponent.value);
        let by_base = if self.slope == 0.0 { 0.0 } else { exponent.value * self.value.powf(exponent.value - 1.0) };
        let by_exponent = if exponent.slope == 0.0 { 0.0 } else { value * self.value.ln() * exponent.slope };
        Self { value, slope: by_base * self.slope + by_exponent }
    }

    /// The length of a vector with two components.
    pub fn hypot(self, other: Self) -> Self {
        let value = self.value.hypot(other.value);
        let slope = self.value * self.slope + other.value * other.slope;
        Self { value, slope: if slope == 0.0 { 0.0 } else { slope / value } }
    }
}

impl From<f64> for Dual {
    fn from(value: f64) -> Self {
        Self::constant(value)
    }
}

impl Neg for Dual {
    type Output = Self;

    fn neg(self) -> Self {
        Self { value: -self.value, slope: -self.slope }
    }
}

impl Add for Dual {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { value: self.value + other.value, slope: self.slope + other.slope }
    }
}

impl Sub for Dual {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Dual {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self { value: self.value * other.value, slope: self.slope * other.value + self.value * other.slope }
    }
}

impl Div for Dual {
    type Output = Self;

    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self { value, slope: (self.slope - value * other.slope) / other.value }
    }
}

impl Mul<Dual> for f64 {
    type Output = Dual;

    fn mul(self, other: Dual) -> Dual {
        Dual { value: self * other.value, slope: self * other.slope }
    }
}
