//! Formulas as they are written, each with its place: names are not resolved.

use proc_macro2::{Ident, Span};

use super::unit::Unit;
use crate::formula::Decimal;
use crate::report::Region;

/// A formula with the stretch of source that it comes from.
#[derive(Clone, Debug)]
pub struct Expression {
    pub kind: Kind,
    pub region: Region,
}

impl Expression {
    /// Whether it is the number zero.
    pub fn is_zero(&self) -> bool {
        matches!(&self.kind, Kind::Number(number) if number.is_zero())
    }

    /// Calls `visit` with every name that is used as a value.
    pub fn names(&self, visit: &mut impl FnMut(&Ident)) {
        match &self.kind {
            Kind::Number(_) | Kind::Quantity(..) => {}
            Kind::Name(name) => visit(name),
            Kind::Sum(terms) => terms.iter().for_each(|term| term.value.names(visit)),
            Kind::Product(factors) => factors.iter().for_each(|factor| factor.value.names(visit)),
            Kind::Power(inner, _) | Kind::Call(_, inner) => inner.names(visit),
        }
    }

    /// Calls `visit` with every function and its argument.
    pub fn calls<'a>(&'a self, visit: &mut impl FnMut(&'a Ident, &'a Self)) {
        match &self.kind {
            Kind::Number(_) | Kind::Quantity(..) | Kind::Name(_) => {}
            Kind::Sum(terms) => terms.iter().for_each(|term| term.value.calls(visit)),
            Kind::Product(factors) => factors.iter().for_each(|factor| factor.value.calls(visit)),
            Kind::Power(inner, _) => inner.calls(visit),
            Kind::Call(name, argument) => {
                visit(name, argument);
                argument.calls(visit);
            }
        }
    }

    /// Calls `visit` with every unit.
    pub fn units<'a>(&'a self, visit: &mut impl FnMut(&'a Unit)) {
        match &self.kind {
            Kind::Number(_) | Kind::Name(_) => {}
            Kind::Quantity(_, unit) => visit(unit),
            Kind::Sum(terms) => terms.iter().for_each(|term| term.value.units(visit)),
            Kind::Product(factors) => factors.iter().for_each(|factor| factor.value.units(visit)),
            Kind::Power(inner, _) | Kind::Call(_, inner) => inner.units(visit),
        }
    }
}

/// What a formula is. Sums and products are flat, so that long ones do not nest deeply.
#[derive(Clone, Debug)]
pub enum Kind {
    Number(Decimal),
    /// `0.3 [m]`.
    Quantity(Decimal, Unit),
    Name(Ident),
    Sum(Vec<Term>),
    Product(Vec<Factor>),
    Power(Box<Expression>, i32),
    Call(Ident, Box<Expression>),
}

/// One term of a sum; `operator` is the sign before it, where one is written.
#[derive(Clone, Debug)]
pub struct Term {
    pub negative: bool,
    pub operator: Option<Span>,
    pub value: Expression,
}

/// One factor of a product.
#[derive(Clone, Debug)]
pub struct Factor {
    pub inverse: bool,
    pub value: Expression,
}
