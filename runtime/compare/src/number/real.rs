//! Real numbers with 320 bits.

use std::cell::RefCell;
use std::cmp::Ordering;
use std::ops::{Add, Div, Mul, Neg, Sub};

use astro_float::{BigFloat, Consts, Exponent, Radix, RoundingMode, Sign, WORD_BIT_SIZE, Word};

/// The bits of a mantissa: six times those of `f64`, so that rounding here never shows in a comparison with it.
const BITS: usize = 320;
const ROUNDING: RoundingMode = RoundingMode::ToEven;

thread_local! {
    static CONSTANTS: RefCell<Consts> = RefCell::new(Consts::new().expect("memory for constants"));
}

/// A finite real number with 320 bits; an operation without a finite result panics.
///
/// `BigFloat` owns its mantissa and so is not `Copy`; this keeps the mantissa in place, so that formulas read as written.
#[derive(Clone, Copy, Debug)]
pub struct Real {
    mantissa: [Word; BITS / WORD_BIT_SIZE],
    significant_bits: usize,
    sign: Sign,
    exponent: Exponent,
}

impl Real {
    /// The nearest number to a decimal such as `-5.5309437176539346`.
    #[must_use]
    pub fn parse(decimal: &str) -> Self {
        CONSTANTS.with_borrow_mut(|constants| BigFloat::parse(decimal, Radix::Dec, BITS, ROUNDING, constants).into())
    }

    /// The ratio of the circumference of a circle to its diameter.
    #[must_use]
    pub fn pi() -> Self {
        CONSTANTS.with_borrow_mut(|constants| constants.pi(BITS, ROUNDING).into())
    }

    /// Sine of an angle in radians.
    #[must_use]
    pub fn sin(self) -> Self {
        CONSTANTS.with_borrow_mut(|constants| BigFloat::from(self).sin(BITS, ROUNDING, constants).into())
    }

    /// Cosine of an angle in radians.
    #[must_use]
    pub fn cos(self) -> Self {
        CONSTANTS.with_borrow_mut(|constants| BigFloat::from(self).cos(BITS, ROUNDING, constants).into())
    }

    /// The square root of a number that is not negative.
    #[must_use]
    pub fn sqrt(self) -> Self {
        BigFloat::from(self).sqrt(BITS, ROUNDING).into()
    }

    /// The magnitude.
    #[must_use]
    pub fn abs(self) -> Self {
        Self { sign: Sign::Pos, ..self }
    }

    /// The nearest `f64`.
    #[must_use]
    pub fn to_f64(self) -> f64 {
        // The mantissa is a fraction whose first bit is set, its least word first. All but its upper 128 bits decide
        // nothing but whether the value lies between two numbers or on the middle.
        let most = 128 / WORD_BIT_SIZE;
        let (rest, upper) = self.mantissa.split_at(self.mantissa.len() - most);
        let upper = upper.iter().rev().fold(0_u128, |bits, word| (bits << WORD_BIT_SIZE) | u128::from(*word));
        let sticky = u128::from(rest.iter().any(|word| *word != 0));
        let exponent = i64::from(self.exponent) - 128;
        let magnitude = scale((upper | sticky) as f64, exponent);
        if self.sign == Sign::Neg { -magnitude } else { magnitude }
    }
}

/// A number times a power of two, in steps whose factors are numbers.
fn scale(mut value: f64, mut exponent: i64) -> f64 {
    while exponent != 0 && value != 0.0 && value.is_finite() {
        let step = exponent.clamp(-1000, 1000);
        value *= 2_f64.powi(step as i32);
        exponent -= step;
    }
    value
}

impl From<f64> for Real {
    fn from(value: f64) -> Self {
        BigFloat::from_f64(value, BITS).into()
    }
}

impl From<BigFloat> for Real {
    fn from(mut value: BigFloat) -> Self {
        // Exact results can come with a shorter mantissa.
        value.set_precision(BITS, ROUNDING).expect("memory for a mantissa");
        let (words, significant_bits, sign, exponent, _) = value.as_raw_parts().expect("a finite result");
        let mantissa = words.try_into().expect("the precision just set");
        Self { mantissa, significant_bits, sign, exponent }
    }
}

impl From<Real> for BigFloat {
    fn from(Real { mantissa, significant_bits, sign, exponent }: Real) -> Self {
        BigFloat::from_raw_parts(&mantissa, significant_bits, sign, exponent, false)
    }
}

impl Add for Real {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        BigFloat::from(self).add(&other.into(), BITS, ROUNDING).into()
    }
}

impl Sub for Real {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        BigFloat::from(self).sub(&other.into(), BITS, ROUNDING).into()
    }
}

impl Mul for Real {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        BigFloat::from(self).mul(&other.into(), BITS, ROUNDING).into()
    }
}

impl Div for Real {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        BigFloat::from(self).div(&other.into(), BITS, ROUNDING).into()
    }
}

impl Neg for Real {
    type Output = Self;
    fn neg(self) -> Self {
        BigFloat::from(self).neg().into()
    }
}

impl PartialEq for Real {
    fn eq(&self, other: &Self) -> bool {
        self.partial_cmp(other) == Some(Ordering::Equal)
    }
}

impl PartialOrd for Real {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        BigFloat::from(*self).partial_cmp(&BigFloat::from(*other))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_number_is_found() {
        for value in [0.0, 1.0, -1.5, 0.1, 1e300, -1e-300, f64::MAX, f64::MIN_POSITIVE, 2_f64.powi(-1074)] {
            assert_eq!(Real::from(value).to_f64(), value);
        }
        // A little above the middle between 1 and the next number, and the middle itself, which goes to the even one.
        let half = Real::from(f64::EPSILON / 2.0);
        let middle = Real::from(1.0) + half;
        assert_eq!(middle.to_f64(), 1.0);
        assert_eq!((middle + Real::from(1e-60)).to_f64(), 1.0 + f64::EPSILON);
        assert_eq!(Real::parse("0.1").to_f64(), 0.1);
        assert_eq!(Real::pi().to_f64(), std::f64::consts::PI);
        assert_eq!(Real::parse("1e400").to_f64(), f64::INFINITY);
    }
}
