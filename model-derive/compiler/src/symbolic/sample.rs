//! Formulas at values that mean nothing: what is not zero there is zero nowhere near all parameters, and needs no proof.

use std::convert::Infallible;

use crate::constant::{Constant, NoValue};
use crate::formula::{Algebra, Decimal, Factor, Formula, Function, Term, Values};
use crate::spread::fraction;

/// A value, and a bound on the error that rounding can have left in it.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    value: f64,
    error: f64,
}

/// The bounds below are of the first order; this is far more than the rest.
const SAFETY: f64 = 16.0;

impl Sample {
    /// Exact values between a half and one and a half, without a pattern.
    pub fn spread(first: usize, count: usize) -> Vec<Self> {
        (first..first + count).map(|index| Self { value: 0.5 + fraction(index), error: 0.0 }).collect()
    }

    /// The value of a formula at values of its parameters and definitions.
    pub fn of(formula: &Formula, parameters: &[Self], definitions: &[Self]) -> Self {
        let Ok(sample) = formula.fold(&Sampler { parameters, definitions });
        sample
    }

    fn rounded(value: f64, error: f64) -> Self {
        Self { value, error: error + f64::EPSILON * value.abs() }
    }

    /// The value alone, which is exact if nothing was rounded.
    ///
    /// # Errors
    /// If there is none.
    pub fn to_constant(self) -> Result<Constant, NoValue> {
        if !self.value.is_finite() {
            return Err(NoValue);
        }
        let size = Decimal::nearest(self.value.abs());
        let sign = if self.value < 0.0 { Term::minus } else { Term::plus };
        Constant::sum([sign(Constant::of_decimal(&size)?)])
    }

    /// This less a multiple of another one.
    pub fn minus_product(self, factor: Self, other: Self) -> Self {
        let error = factor.value.abs() * other.error + factor.error * other.value.abs();
        let product = Self::rounded(factor.value * other.value, error);
        Self::rounded(self.value - product.value, self.error + product.error)
    }

    /// Divided by one that is not zero.
    pub fn over(self, divisor: Self) -> Self {
        let quotient = self.value / divisor.value;
        Self::rounded(quotient, (self.error + quotient.abs() * divisor.error) / divisor.value.abs())
    }

    /// Whether there is a value at all.
    pub fn is_finite(self) -> bool {
        self.value.is_finite()
    }

    /// Whether it may be another one with the opposite sign, whatever rounding has done.
    pub fn is_perhaps_opposite_to(self, other: Self) -> bool {
        let sum = Self { value: self.value + other.value, error: self.error + other.error };
        let rounding = f64::EPSILON * (self.value.abs() + other.value.abs());
        !(sum.value.abs() > SAFETY * (sum.error + rounding) && sum.value.is_finite())
    }

    /// Whether it is another number than zero, whatever rounding has done.
    pub fn is_not_zero(self) -> bool {
        self.value.abs() > SAFETY * self.error && self.value.is_finite()
    }
}

/// Takes samples of formulas, with those of the parameters and definitions.
struct Sampler<'a> {
    parameters: &'a [Sample],
    definitions: &'a [Sample],
}

impl Algebra for Sampler<'_> {
    type Value = Sample;
    type Error = Infallible;

    fn number(&self, number: &Decimal) -> Result<Sample, Infallible> {
        Ok(Sample::rounded(number.to_f64(), 0.0))
    }

    fn pi(&self) -> Sample {
        Sample::rounded(std::f64::consts::PI, 0.0)
    }

    fn parameter(&self, index: usize) -> Sample {
        self.parameters[index]
    }

    fn definition(&self, index: usize) -> Sample {
        self.definitions[index]
    }

    fn sum(&self, mut terms: impl Values<Term<Sample>, Infallible>) -> Result<Sample, Infallible> {
        terms.try_fold(Sample { value: 0.0, error: 0.0 }, |sum, term| {
            let Term { negative, value: term } = term?;
            let value = if negative { sum.value - term.value } else { sum.value + term.value };
            Ok(Sample::rounded(value, sum.error + term.error))
        })
    }

    fn product(&self, mut factors: impl Values<Factor<Sample>, Infallible>) -> Result<Sample, Infallible> {
        factors.try_fold(Sample { value: 1.0, error: 0.0 }, |product, factor| {
            let Factor { inverse, value: factor } = factor?;
            let (value, slope) = match inverse {
                true => (product.value / factor.value, product.value / factor.value.powi(2)),
                false => (product.value * factor.value, product.value),
            };
            let share = if inverse { product.error / factor.value } else { product.error * factor.value };
            Ok(Sample::rounded(value, share.abs() + slope.abs() * factor.error))
        })
    }

    fn power(&self, Sample { value, error }: Sample, exponent: i32) -> Result<Sample, Infallible> {
        let slope = f64::from(exponent) * value.powi(exponent.saturating_sub(1));
        // A power is calculated by a multiplication for each binary digit of its exponent.
        let power = value.powi(exponent);
        Ok(Sample::rounded(power, slope.abs() * error + 32.0 * f64::EPSILON * power.abs()))
    }

    fn call(&self, function: Function, Sample { value, error }: Sample) -> Result<Sample, Infallible> {
        let (result, slope) = match function {
            Function::Sin => (value.sin(), value.cos()),
            Function::Cos => (value.cos(), value.sin()),
            Function::Tan => (value.tan(), 1.0 + value.tan().powi(2)),
            Function::Sqrt => (value.sqrt(), 0.5 / value.sqrt()),
        };
        // A slope of zero may have one beside it.
        Ok(Sample::rounded(result, (slope.abs() + error) * error))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn number(digits: &str) -> Formula {
        Formula::Number(Decimal { digits: digits.into(), exponent: 0 })
    }

    fn of(formula: &Formula) -> Sample {
        Sample::of(formula, &Sample::spread(0, 2), &[])
    }

    #[test]
    fn what_is_zero_but_for_rounding_is_not_taken_for_another_number() {
        let [x, y] = [0, 1].map(Formula::Parameter);
        let sum = Formula::Sum(vec![Term::plus(x.clone()), Term::plus(y.clone())]);
        for exponent in [2, 7, 64] {
            // (x + y)^n / y^n - (x/y + 1)^n
            let powers = [sum.clone(), y.clone()].map(|base| Formula::Power(Box::new(base), exponent));
            let [above, below] = powers;
            let quotient = Formula::Product(vec![Factor::times(x.clone()), Factor::over(y.clone())]);
            let same =
                Formula::Power(Box::new(Formula::Sum(vec![Term::plus(quotient), Term::plus(number("1"))])), exponent);
            let whole = Formula::Product(vec![Factor::times(above), Factor::over(below)]);
            let difference = Formula::Sum(vec![Term::plus(whole.clone()), Term::minus(same)]);
            assert!(!of(&difference).is_not_zero(), "{exponent}: {:?}", of(&difference));
            let other = Formula::Sum(vec![Term::plus(whole), Term::minus(number("1"))]);
            assert!(of(&other).is_not_zero());
        }
        let squares =
            [Function::Sin, Function::Cos].map(|f| Formula::Power(Box::new(Formula::Call(f, Box::new(x.clone()))), 2));
        let one = Term::minus(number("1"));
        let difference = Formula::Sum(squares.into_iter().map(Term::plus).chain([one]).collect());
        assert!(!of(&difference).is_not_zero());
    }

    /// The area of a triangle is zero for none whose corners are declared in order, however far apart.
    #[test]
    fn no_points_are_on_one_line() {
        for step in 1..40 {
            let points =
                [0, 1, 2].map(|corner| [corner * step, corner * step + 1].map(|index| Sample::spread(index, 1)[0]));
            let [[x, y], [x1, y1], [x2, y2]] = points.map(|point| point.map(|coordinate| coordinate.value));
            let area = (x1 - x) * (y2 - y) - (x2 - x) * (y1 - y);
            assert!(area.abs() > 1e-6, "{area} for a step of {step}");
        }
    }

    #[test]
    fn what_has_no_value_decides_nothing() {
        let zero = Formula::Sum(vec![Term::plus(Formula::Parameter(0)), Term::minus(Formula::Parameter(0))]);
        let infinite = Formula::Product(vec![Factor::times(number("1")), Factor::over(zero)]);
        assert!(!of(&infinite).is_not_zero());
        let imaginary = Formula::Call(Function::Sqrt, Box::new(Formula::Sum(vec![Term::minus(number("1"))])));
        assert!(!of(&imaginary).is_not_zero());
    }
}
