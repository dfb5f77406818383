//! One way through a formula, whatever is calculated with: doubles, intervals, exact numbers, the symbolic engine, text.

use std::convert::Infallible;

use super::{Decimal, Factor, Formula, Function, Term};

/// The values of the parts of a formula, in their order. They are not gathered: a formula in doubles is evaluated a thousand
/// times for one claim.
pub trait Values<V, E>: Iterator<Item = Result<V, E>> {}

impl<V, E, I: Iterator<Item = Result<V, E>>> Values<V, E> for I {}

/// What formulas are calculated with.
pub trait Algebra {
    /// The values of formulas.
    type Value;
    /// Why a formula has none.
    type Error;

    /// A decimal number.
    fn number(&self, number: &Decimal) -> Result<Self::Value, Self::Error>;
    /// The number π.
    fn pi(&self) -> Self::Value;
    /// The parameter at a position.
    fn parameter(&self, index: usize) -> Self::Value;
    /// The definition at a position.
    fn definition(&self, index: usize) -> Self::Value;
    /// A sum of terms, each with its value as soon as it is asked for.
    fn sum(&self, terms: impl Values<Term<Self::Value>, Self::Error>) -> Result<Self::Value, Self::Error>;
    /// A product of factors, each with its value as soon as it is asked for.
    fn product(&self, factors: impl Values<Factor<Self::Value>, Self::Error>) -> Result<Self::Value, Self::Error>;
    /// A whole power.
    fn power(&self, base: Self::Value, exponent: i32) -> Result<Self::Value, Self::Error>;
    /// A function of an argument.
    fn call(&self, function: Function, argument: Self::Value) -> Result<Self::Value, Self::Error>;

    /// A product by its factors as formulas, for what learns more from equal ones than from their values.
    fn product_of(&self, factors: &[Factor]) -> Result<Self::Value, Self::Error> {
        self.product(
            factors.iter().map(|Factor { inverse, value }| Ok(Factor { inverse: *inverse, value: value.fold(self)? })),
        )
    }

    /// The value of a formula with what else is known of it.
    fn refine(&self, _formula: &Formula, value: Self::Value) -> Self::Value {
        value
    }
}

impl Formula {
    /// The value of the formula in an algebra.
    ///
    /// # Errors
    /// As the algebra has them.
    pub fn fold<A: Algebra + ?Sized>(&self, algebra: &A) -> Result<A::Value, A::Error> {
        let value = match self {
            Self::Number(number) => algebra.number(number)?,
            Self::Pi => algebra.pi(),
            Self::Parameter(index) => algebra.parameter(*index),
            Self::Definition(index) => algebra.definition(*index),
            Self::Sum(terms) => {
                let fold =
                    |Term { negative, value }: &Term| Ok(Term { negative: *negative, value: value.fold(algebra)? });
                algebra.sum(terms.iter().map(fold))?
            }
            Self::Product(factors) => algebra.product_of(factors)?,
            Self::Power(base, exponent) => algebra.power(base.fold(algebra)?, *exponent)?,
            Self::Call(function, argument) => algebra.call(*function, argument.fold(algebra)?)?,
        };
        Ok(algebra.refine(self, value))
    }

    /// The value at given values of the parameters and definitions.
    pub fn evaluate(&self, parameters: &[f64], definitions: &[f64]) -> f64 {
        let Ok(value) = self.fold(&Doubles { parameters, definitions });
        value
    }
}

/// Doubles, as a program would calculate with them that follows the formula.
struct Doubles<'a> {
    parameters: &'a [f64],
    definitions: &'a [f64],
}

impl Algebra for Doubles<'_> {
    type Value = f64;
    type Error = Infallible;

    fn number(&self, number: &Decimal) -> Result<f64, Infallible> {
        Ok(number.to_f64())
    }

    fn pi(&self) -> f64 {
        std::f64::consts::PI
    }

    fn parameter(&self, index: usize) -> f64 {
        self.parameters[index]
    }

    fn definition(&self, index: usize) -> f64 {
        self.definitions[index]
    }

    // Loops, since in a build without optimization adapters of iterators take most of the time.
    fn sum(&self, terms: impl Values<Term<f64>, Infallible>) -> Result<f64, Infallible> {
        let mut sum = 0.0;
        for Ok(Term { negative, value }) in terms {
            sum += if negative { -value } else { value };
        }
        Ok(sum)
    }

    fn product(&self, factors: impl Values<Factor<f64>, Infallible>) -> Result<f64, Infallible> {
        let mut product = 1.0;
        for Ok(Factor { inverse, value }) in factors {
            product *= if inverse { value.recip() } else { value };
        }
        Ok(product)
    }

    fn power(&self, base: f64, exponent: i32) -> Result<f64, Infallible> {
        Ok(base.powi(exponent))
    }

    fn call(&self, function: Function, argument: f64) -> Result<f64, Infallible> {
        Ok(match function {
            Function::Sin => argument.sin(),
            Function::Cos => argument.cos(),
            Function::Tan => argument.tan(),
            Function::Sqrt => argument.sqrt(),
        })
    }
}
