//! The values of formulas.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::names::{Function, Name, Resolved};
use crate::number::{Exact, Real};

/// What formulas are evaluated in.
pub trait Value:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The number nearest to a decimal.
    fn decimal(text: &str) -> Self;
    fn pi() -> Self;
    fn call(self, function: Function) -> Self;
    /// The sign of it, zero among them.
    fn sign(self) -> i8;
}

impl Value for f64 {
    fn decimal(text: &str) -> Self {
        text.parse().unwrap_or(f64::NAN)
    }
    fn pi() -> Self {
        std::f64::consts::PI
    }
    fn call(self, function: Function) -> Self {
        match function {
            Function::Sin => self.sin(),
            Function::Cos => self.cos(),
            Function::Tan => self.tan(),
            Function::Sqrt => self.sqrt(),
        }
    }
    fn sign(self) -> i8 {
        i8::from(self > 0.0) - i8::from(self < 0.0)
    }
}

impl Value for Exact {
    fn decimal(text: &str) -> Self {
        Self::given(Real::parse(text))
    }
    fn pi() -> Self {
        Self::given(Real::pi())
    }
    fn call(self, function: Function) -> Self {
        use carvallo::Number;
        match function {
            Function::Sin => Number::sin(self),
            Function::Cos => Number::cos(self),
            Function::Tan => Number::tan(self),
            Function::Sqrt => Number::sqrt(self),
        }
    }
    fn sign(self) -> i8 {
        let zero = Real::from(0.0);
        i8::from(self.value > zero) - i8::from(self.value < zero)
    }
}

impl Resolved {
    /// The value at parameters and definitions; nothing where it has none, as a quotient whose divisor is zero.
    pub fn evaluate<T: Value>(&self, parameters: &[T], definitions: &[T]) -> Option<T> {
        let value = |formula: &Self| formula.evaluate(parameters, definitions);
        match self {
            Self::Number(digits) => Some(T::decimal(digits)),
            Self::Name(Name::Pi) => Some(T::pi()),
            Self::Name(Name::Parameter(index)) => Some(parameters[*index]),
            Self::Name(Name::Definition(index)) => Some(definitions[*index]),
            Self::Sum(terms) => {
                let mut sum: Option<T> = None;
                for (negative, term) in terms {
                    let term = value(term)?;
                    sum = Some(match (sum, negative) {
                        (None, false) => term,
                        (None, true) => -term,
                        (Some(sum), false) => sum + term,
                        (Some(sum), true) => sum - term,
                    });
                }
                sum
            }
            Self::Product(factors) => {
                let mut product: Option<T> = None;
                for (inverse, factor) in factors {
                    let factor = value(factor)?;
                    product = Some(match (product, inverse) {
                        (None, false) => factor,
                        (None, true) => quotient(T::decimal("1"), factor)?,
                        (Some(product), false) => product * factor,
                        (Some(product), true) => quotient(product, factor)?,
                    });
                }
                product
            }
            Self::Power(base, exponent) => {
                let base = value(base)?;
                let power = (1..exponent.unsigned_abs()).fold(base, |power, _| power * base);
                match exponent {
                    0 => Some(T::decimal("1")),
                    ..0 => quotient(T::decimal("1"), power),
                    _ => Some(power),
                }
            }
            Self::Call(function, argument) => {
                let argument = value(argument)?;
                (*function != Function::Sqrt || argument.sign() >= 0).then(|| argument.call(*function))
            }
        }
    }
}

fn quotient<T: Value>(dividend: T, divisor: T) -> Option<T> {
    (divisor.sign() != 0).then(|| dividend / divisor)
}

#[cfg(test)]
mod tests {
    use super::*;
    use carvallo::Formula;

    fn at(text: &str, a: f64, b: f64) -> Option<f64> {
        let find = |name: &str| match name {
            "a" => Some(Name::Parameter(0)),
            "b" => Some(Name::Parameter(1)),
            "pi" => Some(Name::Pi),
            _ => None,
        };
        let formula = Resolved::new(&Formula::parse(text).expect("a formula"), find).expect("names that are known");
        let exact = formula.evaluate(&[Exact::from(a), Exact::from(b)], &[]).map(|exact| exact.value.to_f64());
        let double = formula.evaluate(&[a, b], &[]);
        assert!(exact.is_none() == double.is_none());
        if let (Some(exact), Some(double)) = (exact, double) {
            assert!((exact - double).abs() <= 1e-14 * exact.abs(), "{text}: {exact}, {double}");
        }
        exact
    }

    #[test]
    fn formulas_have_their_values() {
        let cases = [
            ("a - (b - 1)", 2.0),
            ("-a^2 + b", -7.0),
            ("1/a*b", 2.0 / 3.0),
            ("a^-1*b^0", 1.0 / 3.0),
            ("sqrt(a + 2*b + 2)", 3.0),
            ("2 [cm]*a", 0.06),
            ("90 [deg]/pi", 0.5),
            ("36 [km/h]", 10.0),
            ("3 [g*mm^2]", 3e-9),
            ("sin(pi/6) + cos(pi/3) + tan(pi/4)", 2.0),
        ];
        for (text, expected) in cases {
            let found = at(text, 3.0, 2.0).expect("a value");
            assert!((found - expected).abs() <= 1e-15 * expected.abs(), "{text}: {found}");
        }
    }

    #[test]
    fn what_has_no_value_has_none() {
        assert_eq!(at("1/(a - b)", 2.0, 2.0), None);
        assert_eq!(at("sqrt(a - b)", 1.0, 2.0), None);
        assert_eq!(at("(a - b)^-2", 2.0, 2.0), None);
    }
}
