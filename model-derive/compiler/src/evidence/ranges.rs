//! The values that a formula can have.

use std::convert::Infallible;
use std::f64::consts::PI;

use super::intervals::Interval;
use crate::domain::{Bound, Domain};
use crate::formula::{Algebra, Decimal, Factor, Formula, Function, Term, Values};

/// What is known of the values of parameters, definitions and other formulas.
#[derive(Debug)]
pub struct Ranges {
    /// How constants are read.
    reading: Reading,
    parameters: Vec<Interval>,
    /// Of the first definitions, in the order of the model.
    definitions: Vec<Interval>,
    /// Of formulas that requirements bound.
    facts: Vec<(Formula, Interval)>,
}

/// How constants are read.
#[derive(Clone, Copy, Debug)]
pub enum Reading {
    /// As the nearest `f64`: what the generated code computes with.
    Nearest,
    /// As an interval around the exact number.
    Exact,
}

impl Ranges {
    pub fn new(reading: Reading, parameters: Vec<Interval>) -> Self {
        Self { reading, parameters, definitions: Vec::new(), facts: Vec::new() }
    }

    /// Notes that a formula has no values but these.
    pub fn add_fact(&mut self, formula: &Formula, values: Interval) {
        self.facts.push((formula.clone(), values));
    }

    /// Takes in the next definition.
    pub fn push_definition(&mut self, formula: &Formula) {
        let values = self.of(formula);
        self.definitions.push(values);
    }

    /// Holds every value that a formula can have, where it has one.
    pub fn of(&self, formula: &Formula) -> Interval {
        let Ok(values) = formula.fold(self);
        values
    }
}

impl Algebra for Ranges {
    type Value = Interval;
    type Error = Infallible;

    fn number(&self, number: &Decimal) -> Result<Interval, Infallible> {
        let nearest = number.to_f64();
        Ok(match self.reading {
            Reading::Exact if number.to_integer().is_none() => Interval::closed(nearest.next_down(), nearest.next_up()),
            _ => Interval::point(nearest),
        })
    }

    fn pi(&self) -> Interval {
        match self.reading {
            Reading::Nearest => Interval::point(PI),
            Reading::Exact => Interval::closed(PI, PI.next_up()),
        }
    }

    fn parameter(&self, index: usize) -> Interval {
        self.parameters[index]
    }

    fn definition(&self, index: usize) -> Interval {
        self.definitions[index]
    }

    fn sum(&self, terms: impl Values<Term<Interval>, Infallible>) -> Result<Interval, Infallible> {
        Ok(terms.map(|Ok(Term { negative, value })| if negative { -value } else { value }).sum())
    }

    fn product(&self, factors: impl Values<Factor<Interval>, Infallible>) -> Result<Interval, Infallible> {
        Ok(factors.map(|Ok(Factor { inverse, value })| if inverse { value.power(-1) } else { value }).product())
    }

    fn product_of(&self, factors: &[Factor]) -> Result<Interval, Infallible> {
        self.product(powers(factors).into_iter().map(|(base, n)| Ok(Factor::times(self.of(base).power(n)))))
    }

    fn power(&self, base: Interval, exponent: i32) -> Result<Interval, Infallible> {
        Ok(base.power(exponent))
    }

    fn call(&self, function: Function, argument: Interval) -> Result<Interval, Infallible> {
        Ok(match function {
            Function::Sin => argument.sin(),
            Function::Cos => argument.cos(),
            Function::Tan => argument.tan(),
            Function::Sqrt => argument.sqrt(),
        })
    }

    fn refine(&self, formula: &Formula, values: Interval) -> Interval {
        let facts = self.facts.iter().filter(|(known, _)| known == formula);
        facts.fold(values, |values, (_, fact)| values.intersection(*fact))
    }
}

/// Factors as powers, equal ones together, so that a square is not negative however it is written.
fn powers(factors: &[Factor]) -> Vec<(&Formula, i32)> {
    let mut powers: Vec<(&Formula, i32)> = Vec::new();
    for Factor { inverse, value } in factors {
        let (base, exponent) = match value {
            Formula::Power(base, exponent) => (&**base, *exponent),
            other => (other, 1),
        };
        let exponent = if *inverse { -exponent } else { exponent };
        match powers.iter_mut().find(|(known, _)| *known == base) {
            Some((_, sum)) => *sum += exponent,
            None => powers.push((base, exponent)),
        }
    }
    powers
}

impl From<Domain> for Interval {
    fn from(domain: Domain) -> Self {
        let end = |bound, infinite| match bound {
            Bound::Unbounded => (infinite, true),
            Bound::Open(value) => (value, true),
            Bound::Closed(value) => (value, false),
        };
        let ((lower, lower_open), (upper, upper_open)) =
            (end(domain.lower, f64::NEG_INFINITY), end(domain.upper, f64::INFINITY));
        let mut interval = Self::closed(lower, upper);
        if lower_open {
            interval = interval.without_lower();
        }
        if upper_open {
            interval = interval.without_upper();
        }
        if domain.nonzero { interval.without_zero() } else { interval }
    }
}
