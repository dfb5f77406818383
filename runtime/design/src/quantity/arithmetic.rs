//! The numbers that expressions are computed with.

use std::ops::{Add, Div, Mul, Neg};

use super::function::{self, One, Two};
use crate::dual::Dual;

/// A double, perhaps with its derivative.
pub trait Arithmetic:
    Copy + Add<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self> + From<f64>
{
    /// The double.
    fn value(self) -> f64;
    /// A power.
    fn powf(self, exponent: Self) -> Self;
    /// A function of it, with its name.
    fn one(self, name: &str, function: One) -> Self;
    /// A function of it and another number, with its name.
    fn two(self, other: Self, name: &str, function: Two) -> Self;
}

impl Arithmetic for f64 {
    fn value(self) -> f64 {
        self
    }

    fn powf(self, exponent: Self) -> Self {
        self.powf(exponent)
    }

    fn one(self, _: &str, function: One) -> Self {
        function(self)
    }

    fn two(self, other: Self, _: &str, function: Two) -> Self {
        function(self, other)
    }
}

impl Arithmetic for Dual {
    fn value(self) -> f64 {
        self.value
    }

    fn powf(self, exponent: Self) -> Self {
        self.powf(exponent)
    }

    fn one(self, name: &str, function: One) -> Self {
        self.chain(function(self.value), function::slope_of_one(name, self.value))
    }

    fn two(self, other: Self, name: &str, _: Two) -> Self {
        match name {
            "hypot" => self.hypot(other),
            "atan2" | "arctan2" => self.atan2(other),
            _ => self.powf(other),
        }
    }
}
