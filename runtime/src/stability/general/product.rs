//! Products of many factors, which may leave the range of `f64`.

use crate::numeric::{exponent, ldexp};

/// `mantissa 2^exponent`, with what rounding may do to it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Product {
    pub(super) mantissa: f64,
    pub(super) exponent: i32,
    /// The relative error; of one or more, even the sign is not known.
    pub(super) error: f64,
}

impl Product {
    pub(super) const ONE: Self = Self { mantissa: 1.0, exponent: 0, error: 0.0 };

    pub(super) fn times(mut self, factor: f64, error: f64) -> Self {
        self.mantissa *= factor;
        self.error += error;
        self.normalized()
    }

    /// Times an integral power of a positive number.
    pub(super) fn times_power(self, base: f64, power: i32) -> Self {
        let unit = exponent(base).unwrap_or(0);
        let factor = ldexp(base, -unit).powi(power);
        let mut product = self.times(factor, 0.0);
        product.exponent += unit * power;
        product
    }

    fn normalized(mut self) -> Self {
        if let Some(unit) = exponent(self.mantissa) {
            self.mantissa = ldexp(self.mantissa, -unit);
            self.exponent += unit;
        }
        self
    }

    /// The number and its error in a power of two. Even where it is nothing but rounding it is of the size of that.
    pub(super) fn in_unit(&self, unit: i32) -> (f64, f64) {
        let value = ldexp(self.mantissa, self.exponent - unit);
        (value, value.abs() * self.error.min(1.0) + f64::MIN_POSITIVE)
    }

    pub(super) fn log2(&self) -> f64 {
        self.mantissa.abs().log2() + f64::from(self.exponent)
    }
}
