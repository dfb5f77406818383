//! The formulas of a model in exact fractions.

use carvallo_compiler::model::{Expr, Function, Model};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Pow, Zero};

/// The entries of the matrices of a model by name and position, exactly.
///
/// An angle stands for the tangent of its half, so that its sine and cosine are fractions; formulas must not use angles
/// but in these.
///
/// # Panics
/// If a formula uses a root, π or an angle otherwise.
pub fn matrices(model: &Model, parameters: &[BigRational]) -> Vec<(String, Vec<Vec<BigRational>>)> {
    let mut definitions = Vec::new();
    for (_, formula) in &model.definitions {
        let value = value(formula, parameters, &definitions);
        definitions.push(value);
    }
    let entry = |entry: &Expr| value(entry, parameters, &definitions);
    let rows = |rows: &[Vec<Expr>]| rows.iter().map(|row| row.iter().map(entry).collect()).collect();
    model.matrices.iter().map(|(name, matrix)| (name.name().to_owned(), rows(matrix))).collect()
}

fn value(formula: &Expr, parameters: &[BigRational], definitions: &[BigRational]) -> BigRational {
    let of = |formula: &Expr| value(formula, parameters, definitions);
    match formula {
        Expr::Number(number) => {
            let digits: BigInt = number.digits.parse().expect("decimal digits");
            BigRational::from(digits) * BigRational::from(BigInt::from(10)).pow(number.exponent)
        }
        Expr::Parameter(index) => parameters[*index].clone(),
        Expr::Definition(index) => definitions[*index].clone(),
        Expr::Sum(terms) => terms.iter().fold(BigRational::zero(), |sum, (minus, term)| match minus {
            true => sum - of(term),
            false => sum + of(term),
        }),
        Expr::Product(factors) => factors.iter().fold(BigRational::one(), |product, (divides, factor)| match divides {
            true => product / of(factor),
            false => product * of(factor),
        }),
        Expr::Power(base, exponent) => of(base).pow(*exponent),
        Expr::Call(function, argument) => {
            assert!(matches!(**argument, Expr::Parameter(_)), "the {} of {argument:?}", function.name());
            let half = of(argument);
            let square = &half * &half;
            match function {
                Function::Sin => (&half + &half) / (BigRational::one() + square),
                Function::Cos => (BigRational::one() - &square) / (BigRational::one() + square),
                Function::Tan | Function::Sqrt => panic!("no fraction: the {} of {argument:?}", function.name()),
            }
        }
        Expr::Pi => panic!("π is no fraction"),
    }
}
