//! Formulas at values that mean nothing: what is not zero there is zero nowhere near all parameters, and needs no proof.

use crate::model::{Expr, Function};

/// A value, and a bound on the error that rounding can have left in it.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    value: f64,
    error: f64,
}

/// The bounds below are of the first order; this is far more than the rest.
const SAFETY: f64 = 16.0;

impl Sample {
    /// Exact values between a half and one and a half, no two of them alike: multiples of the golden ratio spread evenly.
    pub fn spread(first: usize, count: usize) -> Vec<Self> {
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let value = |index: usize| 0.5 + (index as f64 * GOLDEN).fract();
        (first..first + count).map(|index| Self { value: value(index), error: 0.0 }).collect()
    }

    /// The value of a formula at values of its parameters and definitions.
    pub fn of(formula: &Expr, parameters: &[Self], definitions: &[Self]) -> Self {
        let of = |formula: &Expr| Self::of(formula, parameters, definitions);
        match formula {
            Expr::Number(number) => Self::rounded(number.to_f64(), 0.0),
            Expr::Pi => Self::rounded(std::f64::consts::PI, 0.0),
            Expr::Parameter(index) => parameters[*index],
            Expr::Definition(index) => definitions[*index],
            Expr::Sum(terms) => terms.iter().fold(Self { value: 0.0, error: 0.0 }, |sum, (minus, term)| {
                let term = of(term);
                let value = if *minus { sum.value - term.value } else { sum.value + term.value };
                Self::rounded(value, sum.error + term.error)
            }),
            Expr::Product(factors) => {
                factors.iter().fold(Self { value: 1.0, error: 0.0 }, |product, (divides, factor)| {
                    let factor = of(factor);
                    let (value, slope) = match divides {
                        true => (product.value / factor.value, product.value / factor.value.powi(2)),
                        false => (product.value * factor.value, product.value),
                    };
                    let share = if *divides { product.error / factor.value } else { product.error * factor.value };
                    Self::rounded(value, share.abs() + slope.abs() * factor.error)
                })
            }
            Expr::Power(base, exponent) => {
                let Self { value, error } = of(base);
                let slope = f64::from(*exponent) * value.powi(exponent.saturating_sub(1));
                // A power is calculated by a multiplication for each binary digit of its exponent.
                let power = value.powi(*exponent);
                Self::rounded(power, slope.abs() * error + 32.0 * f64::EPSILON * power.abs())
            }
            Expr::Call(function, argument) => {
                let Self { value, error } = of(argument);
                let (result, slope) = match function {
                    Function::Sin => (value.sin(), value.cos()),
                    Function::Cos => (value.cos(), value.sin()),
                    Function::Tan => (value.tan(), 1.0 + value.tan().powi(2)),
                    Function::Sqrt => (value.sqrt(), 0.5 / value.sqrt()),
                };
                // A slope of zero may have one beside it.
                Self::rounded(result, (slope.abs() + error) * error)
            }
        }
    }

    fn rounded(value: f64, error: f64) -> Self {
        Self { value, error: error + f64::EPSILON * value.abs() }
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

    /// Whether it is another number than zero, whatever rounding has done.
    pub fn is_not_zero(self) -> bool {
        self.value.abs() > SAFETY * self.error && self.value.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::Decimal;

    fn number(digits: &str) -> Expr {
        Expr::Number(Decimal { digits: digits.into(), exponent: 0 })
    }

    fn of(formula: &Expr) -> Sample {
        Sample::of(formula, &Sample::spread(0, 2), &[])
    }

    #[test]
    fn what_is_zero_but_for_rounding_is_not_taken_for_another_number() {
        let [x, y] = [0, 1].map(Expr::Parameter);
        let sum = Expr::Sum(vec![(false, x.clone()), (false, y.clone())]);
        for exponent in [2, 7, 64] {
            // (x + y)^n / y^n - (x/y + 1)^n
            let powers = [sum.clone(), y.clone()].map(|base| Expr::Power(Box::new(base), exponent));
            let [above, below] = powers;
            let quotient = Expr::Product(vec![(false, x.clone()), (true, y.clone())]);
            let same = Expr::Power(Box::new(Expr::Sum(vec![(false, quotient), (false, number("1"))])), exponent);
            let whole = Expr::Product(vec![(false, above), (true, below)]);
            let difference = Expr::Sum(vec![(false, whole.clone()), (true, same)]);
            assert!(!of(&difference).is_not_zero(), "{exponent}: {:?}", of(&difference));
            let other = Expr::Sum(vec![(false, whole), (true, number("1"))]);
            assert!(of(&other).is_not_zero());
        }
        let squares =
            [Function::Sin, Function::Cos].map(|f| Expr::Power(Box::new(Expr::Call(f, Box::new(x.clone()))), 2));
        let one = (true, number("1"));
        let difference = Expr::Sum(squares.into_iter().map(|square| (false, square)).chain([one]).collect());
        assert!(!of(&difference).is_not_zero());
    }

    #[test]
    fn what_has_no_value_decides_nothing() {
        let zero = Expr::Sum(vec![(false, Expr::Parameter(0)), (true, Expr::Parameter(0))]);
        let infinite = Expr::Product(vec![(false, number("1")), (true, zero)]);
        assert!(!of(&infinite).is_not_zero());
        let imaginary = Expr::Call(Function::Sqrt, Box::new(Expr::Sum(vec![(true, number("1"))])));
        assert!(!of(&imaginary).is_not_zero());
    }
}
