//! The values that a formula can have.

use super::intervals::Interval;
use crate::model::{Bound, Domain, Expr, Function};
use crate::syntax::Decimal;

/// What is known of the values of parameters, definitions and other formulas.
#[derive(Debug)]
pub struct Ranges {
    /// How constants are read.
    constants: Constants,
    parameters: Vec<Interval>,
    /// Of the first definitions, in the order of the model.
    definitions: Vec<Interval>,
    /// Of formulas that requirements bound.
    facts: Vec<(Expr, Interval)>,
}

/// How constants are read.
#[derive(Clone, Copy, Debug)]
pub enum Constants {
    /// As the nearest `f64`: what the generated code computes with.
    Nearest,
    /// As an interval around the exact number.
    Exact,
}

impl Ranges {
    pub fn new(constants: Constants, parameters: Vec<Interval>) -> Self {
        Self { constants, parameters, definitions: Vec::new(), facts: Vec::new() }
    }

    /// Notes that a formula has no values but these.
    pub fn add_fact(&mut self, expr: &Expr, values: Interval) {
        self.facts.push((expr.clone(), values));
    }

    /// Takes in the next definition.
    pub fn push_definition(&mut self, expr: &Expr) {
        let values = self.of(expr);
        self.definitions.push(values);
    }

    /// Holds every value that a formula can have, where it has one.
    pub fn of(&self, expr: &Expr) -> Interval {
        let values = match expr {
            Expr::Number(number) => self.number(number),
            Expr::Pi => match self.constants {
                Constants::Nearest => Interval::point(std::f64::consts::PI),
                Constants::Exact => Interval::closed(std::f64::consts::PI, std::f64::consts::PI.next_up()),
            },
            Expr::Parameter(index) => self.parameters[*index],
            Expr::Definition(index) => self.definitions[*index],
            Expr::Sum(terms) => {
                terms.iter().map(|(minus, term)| if *minus { -self.of(term) } else { self.of(term) }).sum()
            }
            Expr::Product(factors) => powers(factors).iter().map(|(base, n)| self.of(base).power(*n)).product(),
            Expr::Power(base, exponent) => self.of(base).power(*exponent),
            Expr::Call(Function::Sin, argument) => self.of(argument).sin(),
            Expr::Call(Function::Cos, argument) => self.of(argument).cos(),
            Expr::Call(Function::Tan, argument) => self.of(argument).tan(),
            Expr::Call(Function::Sqrt, argument) => self.of(argument).sqrt(),
        };
        let facts = self.facts.iter().filter(|(known, _)| known == expr);
        facts.fold(values, |values, (_, fact)| values.intersection(*fact))
    }

    fn number(&self, number: &Decimal) -> Interval {
        let nearest = number.to_f64();
        match self.constants {
            Constants::Exact if number.to_integer().is_none() => {
                Interval::closed(nearest.next_down(), nearest.next_up())
            }
            _ => Interval::point(nearest),
        }
    }
}

/// Factors as powers, equal ones together, so that a square is not negative however it is written.
fn powers(factors: &[(bool, Expr)]) -> Vec<(&Expr, i32)> {
    let mut powers: Vec<(&Expr, i32)> = Vec::new();
    for (inverse, factor) in factors {
        let (base, exponent) = match factor {
            Expr::Power(base, exponent) => (&**base, *exponent),
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
