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
    pub fn parse(decimal: &str) -> Self {
        CONSTANTS.with_borrow_mut(|constants| BigFloat::parse(decimal, Radix::Dec, BITS, ROUNDING, constants).into())
    }

    /// Sine of an angle in radians.
    pub fn sin(self) -> Self {
        CONSTANTS.with_borrow_mut(|constants| BigFloat::from(self).sin(BITS, ROUNDING, constants).into())
    }

    /// Cosine of an angle in radians.
    pub fn cos(self) -> Self {
        CONSTANTS.with_borrow_mut(|constants| BigFloat::from(self).cos(BITS, ROUNDING, constants).into())
    }

    /// The square root of a number that is not negative.
    pub fn sqrt(self) -> Self {
        BigFloat::from(self).sqrt(BITS, ROUNDING).into()
    }

    /// The magnitude.
    pub fn abs(self) -> Self {
        Self { sign: Sign::Pos, ..self }
    }

    /// The nearest `f64`.
    pub fn to_f64(self) -> f64 {
        BigFloat::from(self).to_string().parse().expect("the decimal form of a finite number")
    }
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
