//! Constants far beyond double precision, and formulas evaluated with them.

use std::cell::RefCell;
use std::cmp::Ordering;

use astro_float::{BigFloat, Consts, Radix, RoundingMode};

use crate::formula::{Algebra, Decimal, Factor, Formula, Function, Term, Values};

/// Bits of the calculation: enough that the nearest `f64` of the result is the nearest of the exact value.
const PRECISION: usize = 320;
const ROUNDING: RoundingMode = RoundingMode::ToEven;
/// A sine or cosine that has the first digit so many binary places behind that of its argument is nothing but the rounding of
/// π, and is taken for zero.
const ROUNDED: i32 = 256;

/// A constant, finite unless an operation says otherwise.
#[derive(Clone, Debug)]
pub struct Constant(BigFloat);

/// An operation without a real and finite result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoValue;

/// Reads as a whole message.
impl std::fmt::Display for NoValue {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("not a real and finite number: expected a constant that has a value")
    }
}

/// Digits of π and the like. Found anew for each constant they would take most of the time of a check.
fn with_digits<T>(work: impl FnOnce(&mut Consts) -> T) -> Option<T> {
    thread_local!(static DIGITS: RefCell<Option<Consts>> = RefCell::new(Consts::new().ok()));
    DIGITS.with_borrow_mut(|digits| digits.as_mut().map(work))
}

fn finite(value: Option<BigFloat>) -> Result<Constant, NoValue> {
    value.filter(|value| !value.is_nan() && !value.is_inf()).map(Constant).ok_or(NoValue)
}

impl Constant {
    /// A decimal number as text; nothing if it is none.
    pub fn parse(text: &str) -> Option<Self> {
        let value = with_digits(|digits| BigFloat::parse(text, Radix::Dec, PRECISION, ROUNDING, digits))?;
        (!value.is_nan()).then_some(Self(value))
    }

    /// A decimal number.
    ///
    /// # Errors
    /// If it is beyond the range of the calculation.
    pub fn of_decimal(number: &Decimal) -> Result<Self, NoValue> {
        let text = number.to_string();
        finite(with_digits(|digits| BigFloat::parse(&text, Radix::Dec, PRECISION, ROUNDING, digits)))
    }

    /// The number zero.
    pub fn zero() -> Self {
        Self(BigFloat::from_word(0, PRECISION))
    }

    /// The number one.
    pub fn one() -> Self {
        Self(BigFloat::from_word(1, PRECISION))
    }

    /// The number π.
    pub fn pi() -> Self {
        // Without memory for the digits there is none for the rest of the compiler either.
        Self(with_digits(|digits| digits.pi(PRECISION, ROUNDING)).unwrap_or(astro_float::NAN))
    }

    /// The sum of terms.
    ///
    /// # Errors
    /// If it is not finite.
    pub fn sum(terms: impl IntoIterator<Item = Term<Self>>) -> Result<Self, NoValue> {
        let sum = terms.into_iter().fold(BigFloat::from_word(0, PRECISION), |sum, Term { negative, value }| {
            if negative { sum.sub(&value.0, PRECISION, ROUNDING) } else { sum.add(&value.0, PRECISION, ROUNDING) }
        });
        finite(Some(sum))
    }

    /// The product of factors.
    ///
    /// # Errors
    /// If it is not finite.
    pub fn product(factors: impl IntoIterator<Item = Factor<Self>>) -> Result<Self, NoValue> {
        let product =
            factors.into_iter().fold(BigFloat::from_word(1, PRECISION), |product, Factor { inverse, value }| {
                if inverse {
                    product.div(&value.0, PRECISION, ROUNDING)
                } else {
                    product.mul(&value.0, PRECISION, ROUNDING)
                }
            });
        finite(Some(product))
    }

    /// A whole power.
    ///
    /// # Errors
    /// If it is not finite, and for powers of zero that are not positive.
    pub fn power(&self, exponent: i32) -> Result<Self, NoValue> {
        if exponent <= 0 && self.is_zero() {
            return Err(NoValue);
        }
        let power = self.0.powi(exponent.unsigned_abs() as usize, PRECISION, ROUNDING);
        let one = BigFloat::from_word(1, PRECISION);
        finite(Some(if exponent < 0 { one.div(&power, PRECISION, ROUNDING) } else { power }))
    }

    /// A function of a formula.
    ///
    /// # Errors
    /// If it is not real and finite.
    pub fn call(&self, function: Function) -> Result<Self, NoValue> {
        let (p, rm) = (PRECISION, ROUNDING);
        let settled = |value: BigFloat| {
            let is_rounding = value.exponent().zip(self.0.exponent()).is_some_and(|(own, of)| own < of - ROUNDED);
            if is_rounding { BigFloat::from_word(0, p) } else { value }
        };
        finite(with_digits(|digits| match function {
            Function::Sin => settled(self.0.sin(p, rm, digits)),
            Function::Cos => settled(self.0.cos(p, rm, digits)),
            Function::Tan if settled(self.0.cos(p, rm, digits)).is_zero() => astro_float::NAN,
            Function::Tan => settled(self.0.tan(p, rm, digits)),
            Function::Sqrt => self.0.sqrt(p, rm),
        }))
    }

    /// The arcsine.
    ///
    /// # Errors
    /// Beyond one.
    pub fn asin(&self) -> Result<Self, NoValue> {
        finite(with_digits(|digits| self.0.asin(PRECISION, ROUNDING, digits)))
    }

    /// The arccosine.
    ///
    /// # Errors
    /// Beyond one.
    pub fn acos(&self) -> Result<Self, NoValue> {
        finite(with_digits(|digits| self.0.acos(PRECISION, ROUNDING, digits)))
    }

    /// The arctangent.
    ///
    /// # Errors
    /// If the digits cannot be had.
    pub fn atan(&self) -> Result<Self, NoValue> {
        finite(with_digits(|digits| self.0.atan(PRECISION, ROUNDING, digits)))
    }

    /// The size of the difference of two constants.
    pub fn distance(&self, other: &Self) -> Self {
        Self(self.0.sub(&other.0, PRECISION, ROUNDING).abs())
    }

    /// This less a product.
    pub fn minus_product(&self, one: &Self, other: &Self) -> Self {
        let product = one.0.mul(&other.0, PRECISION, ROUNDING);
        Self(self.0.sub(&product, PRECISION, ROUNDING))
    }

    /// This divided by another constant.
    pub fn over(&self, other: &Self) -> Self {
        Self(self.0.div(&other.0, PRECISION, ROUNDING))
    }

    /// Whether it is above zero by more than the rounding of a calculation with numbers of the size of `scale`.
    pub fn is_positive_beside(&self, scale: &Self) -> bool {
        let rounding = BigFloat::from_word(2, PRECISION).powi(PRECISION / 2, PRECISION, ROUNDING);
        self.0 > scale.0.abs().div(&rounding, PRECISION, ROUNDING)
    }

    /// Whether its size is more than the rounding of a calculation with numbers of the size of `scale`.
    pub fn is_apart_from_zero_beside(&self, scale: &Self) -> bool {
        Self(self.0.abs()).is_positive_beside(scale)
    }

    /// Whether it is zero.
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    /// The nearest `f64`.
    ///
    /// # Errors
    /// If the value is beyond the range of `f64`, a sentence that says so.
    pub fn to_f64(&self) -> Result<f64, String> {
        let text = with_digits(|digits| self.0.format(Radix::Dec, ROUNDING, digits).ok()).flatten();
        let value: f64 = text.and_then(|text| text.parse().ok()).unwrap_or(f64::NAN);
        if value.is_finite() && (value != 0.0 || self.0.is_zero()) {
            Ok(value)
        } else {
            Err("beyond the range of f64: expected a magnitude between 1e-300 and 1e300".into())
        }
    }
}

impl PartialOrd for Constant {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.0.partial_cmp(&other.0)
    }
}

impl PartialEq for Constant {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

/// Eliminates below the diagonal of a symmetric matrix. Returns the first row whose pivot is refused, beside the entry
/// that was there before, and then stops.
pub fn eliminate(matrix: &mut [Vec<Constant>], accepts: impl Fn(&Constant, &Constant) -> bool) -> Option<usize> {
    let diagonal: Vec<Constant> = matrix.iter().enumerate().map(|(index, row)| row[index].clone()).collect();
    for (pivot, before) in diagonal.iter().enumerate() {
        let (done, rest) = matrix.split_at_mut(pivot + 1);
        let value = &done[pivot][pivot];
        if !accepts(value, before) {
            return Some(pivot);
        }
        for row in rest {
            let factor = row[pivot].over(value);
            for (entry, above) in row.iter_mut().zip(&done[pivot]).skip(pivot + 1) {
                *entry = entry.minus_product(&factor, above);
            }
        }
    }
    None
}

/// The constants that parameters and definitions are, for formulas in them.
#[derive(Debug)]
pub struct Constants {
    /// By position.
    pub parameters: Vec<Constant>,
    /// By position.
    pub definitions: Vec<Constant>,
}

impl Constants {
    /// The value of a formula.
    ///
    /// # Errors
    /// If it has none that is real and finite.
    pub fn of(&self, formula: &Formula) -> Result<Constant, NoValue> {
        formula.fold(self)
    }
}

impl Algebra for Constants {
    type Value = Constant;
    type Error = NoValue;

    fn number(&self, number: &Decimal) -> Result<Constant, NoValue> {
        Constant::of_decimal(number)
    }

    fn pi(&self) -> Constant {
        Constant::pi()
    }

    fn parameter(&self, index: usize) -> Constant {
        self.parameters[index].clone()
    }

    fn definition(&self, index: usize) -> Constant {
        self.definitions[index].clone()
    }

    fn sum(&self, terms: impl Values<Term<Constant>, NoValue>) -> Result<Constant, NoValue> {
        Constant::sum(terms.collect::<Result<Vec<_>, _>>()?)
    }

    fn product(&self, factors: impl Values<Factor<Constant>, NoValue>) -> Result<Constant, NoValue> {
        Constant::product(factors.collect::<Result<Vec<_>, _>>()?)
    }

    fn power(&self, base: Constant, exponent: i32) -> Result<Constant, NoValue> {
        base.power(exponent)
    }

    fn call(&self, function: Function, argument: Constant) -> Result<Constant, NoValue> {
        argument.call(function)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn multiple_of_pi(numerator: &str, denominator: &str) -> Constant {
        let [above, below] = [numerator, denominator].map(|text| Constant::parse(text).expect("a number"));
        Constant::product([Factor::times(Constant::pi()), Factor::times(above), Factor::over(below)]).expect("finite")
    }

    #[test]
    fn what_is_zero_at_multiples_of_pi_is_zero() {
        for (numerator, function) in [
            ("2", Function::Sin),
            ("-14", Function::Sin),
            ("1", Function::Cos),
            ("-7", Function::Cos),
            ("2", Function::Tan),
        ] {
            let value = multiple_of_pi(numerator, "2").call(function).expect("a value");
            assert!(value.is_zero(), "{function:?} of {numerator} pi/2");
            assert_eq!(value.power(4).expect("finite").to_f64(), Ok(0.0));
            assert!(value.power(-1).is_err());
        }
        assert_eq!(multiple_of_pi("1", "2").call(Function::Tan).err(), Some(NoValue));
    }

    #[test]
    fn what_is_small_for_another_reason_is_not_zero() {
        let small = Constant::parse("1e-200").expect("a number");
        for function in [Function::Sin, Function::Tan] {
            assert_eq!(small.call(function).expect("a value").to_f64(), Ok(1e-200));
            let nearly = Constant::parse("3.14159265358979323846").expect("a number");
            assert!(nearly.call(function).expect("a value").to_f64().is_ok_and(|value| value.abs() > 1e-21));
        }
    }
}
