//! The formulas of a model in exact fractions.

use carvallo_compiler::formula::{Algebra, Decimal, Factor, Formula, Function, Term, Values};
use carvallo_compiler::model::Model;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Pow};

/// The entries of the matrices of a model by name and position, exactly.
///
/// An angle stands for the tangent of its half, so that its sine and cosine are fractions; formulas must not use angles
/// but in these.
///
/// # Panics
/// If a formula uses a root, π or an angle otherwise.
pub fn matrices(model: &Model, parameters: &[BigRational]) -> Vec<(String, Vec<Vec<BigRational>>)> {
    let mut fractions = Fractions { parameters, definitions: Vec::new() };
    for (_, formula) in &model.definitions {
        let value = fractions.of(formula);
        fractions.definitions.push(value);
    }
    let row = |row: &Vec<Formula>| row.iter().map(|entry| fractions.of(entry)).collect();
    let rows = |rows: &[Vec<Formula>]| rows.iter().map(row).collect();
    model.matrices.iter().map(|(name, matrix)| (name.name().to_owned(), rows(matrix))).collect()
}

struct Fractions<'a> {
    parameters: &'a [BigRational],
    definitions: Vec<BigRational>,
}

impl Fractions<'_> {
    fn of(&self, formula: &Formula) -> BigRational {
        formula.fold(self).unwrap_or_else(|why| panic!("{why}: {formula:?}"))
    }
}

impl Algebra for Fractions<'_> {
    type Value = BigRational;
    type Error = &'static str;

    fn number(&self, number: &Decimal) -> Result<BigRational, Self::Error> {
        let digits: BigInt = number.digits.parse().map_err(|_| "no decimal digits")?;
        Ok(BigRational::from(digits) * BigRational::from(BigInt::from(10)).pow(number.exponent))
    }

    fn pi(&self) -> BigRational {
        panic!("π is no fraction")
    }

    fn parameter(&self, index: usize) -> BigRational {
        self.parameters[index].clone()
    }

    fn definition(&self, index: usize) -> BigRational {
        self.definitions[index].clone()
    }

    fn sum(&self, terms: impl Values<Term<BigRational>, Self::Error>) -> Result<BigRational, Self::Error> {
        terms.map(|term| term.map(|Term { negative, value }| if negative { -value } else { value })).sum()
    }

    fn product(&self, factors: impl Values<Factor<BigRational>, Self::Error>) -> Result<BigRational, Self::Error> {
        factors
            .map(|factor| factor.map(|Factor { inverse, value }| if inverse { value.recip() } else { value }))
            .product()
    }

    fn power(&self, base: BigRational, exponent: i32) -> Result<BigRational, Self::Error> {
        Ok(base.pow(exponent))
    }

    fn call(&self, function: Function, half: BigRational) -> Result<BigRational, Self::Error> {
        let square = &half * &half;
        match function {
            Function::Sin => Ok((&half + &half) / (BigRational::one() + square)),
            Function::Cos => Ok((BigRational::one() - &square) / (BigRational::one() + square)),
            Function::Tan | Function::Sqrt => Err("a tangent or a root is no fraction"),
        }
    }

    /// The argument of a function is an angle only if it is a parameter.
    fn refine(&self, formula: &Formula, value: BigRational) -> BigRational {
        if let Formula::Call(_, argument) = formula {
            assert!(matches!(**argument, Formula::Parameter(_)), "a function of {argument:?}");
        }
        value
    }
}
