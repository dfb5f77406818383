//! Formulas without a source to formulas as if they were written in the declaration.

use proc_macro2::{Ident, Span};

use crate::formula::{self, Formula};
use crate::report::Region;
use crate::syntax::{Expression, Factor, Kind, Term};

/// What parameters and definitions are called.
pub struct Names {
    pub parameters: Vec<Ident>,
    pub definitions: Vec<Ident>,
    /// Where the formulas are said to stand.
    pub span: Span,
}

impl Names {
    pub fn expression(&self, expr: &Formula) -> Expression {
        let inner = |expr: &Formula| self.expression(expr);
        let kind = match expr {
            Formula::Number(number) => Kind::Number(number.clone()),
            Formula::Pi => Kind::Name(Ident::new("pi", self.span)),
            Formula::Parameter(index) => Kind::Name(self.parameters[*index].clone()),
            Formula::Definition(index) => Kind::Name(self.definitions[*index].clone()),
            Formula::Sum(terms) => {
                let term =
                    |term: &formula::Term| Term { negative: term.negative, operator: None, value: inner(&term.value) };
                Kind::Sum(terms.iter().map(term).collect())
            }
            Formula::Product(factors) => {
                let factor = |factor: &formula::Factor| Factor { inverse: factor.inverse, value: inner(&factor.value) };
                Kind::Product(factors.iter().map(factor).collect())
            }
            Formula::Power(base, exponent) => Kind::Power(Box::new(inner(base)), *exponent),
            Formula::Call(function, argument) => {
                Kind::Call(Ident::new(function.name(), self.span), Box::new(inner(argument)))
            }
        };
        Expression { kind, region: Region::from(self.span) }
    }
}
