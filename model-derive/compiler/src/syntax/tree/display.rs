//! Formulas of a declaration as text, for messages.

use std::fmt;

use super::expression::{Expression, Factor, Kind, Term};
use crate::formula::{self, Text};

impl Expression {
    fn text(&self) -> Text {
        match &self.kind {
            Kind::Number(number) => Text::single(number),
            Kind::Quantity(number, unit) => Text::single(format_args!("{number} [{}]", unit.text)),
            Kind::Name(name) => Text::single(name),
            Kind::Sum(terms) => Text::sum(
                terms
                    .iter()
                    .map(|Term { negative, value, .. }| formula::Term { negative: *negative, value: value.text() }),
            ),
            Kind::Product(factors) => Text::product(
                factors
                    .iter()
                    .map(|Factor { inverse, value }| formula::Factor { inverse: *inverse, value: value.text() }),
            ),
            Kind::Power(base, exponent) => base.text().power(*exponent),
            Kind::Call(name, argument) => argument.text().argument_of(name),
        }
    }
}

impl fmt::Display for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.text().fmt(f)
    }
}
