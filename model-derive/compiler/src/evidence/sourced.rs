//! Formulas beside the syntax that they come from, for what messages say of them: where they stand, and how they read.

use crate::formula::{Formula, Names};
use crate::report::Region;
use crate::syntax::{Expression, Kind};

/// A formula and where it comes from.
#[derive(Clone, Copy, Debug)]
pub struct Sourced<'a> {
    pub formula: &'a Formula,
    pub source: Source<'a>,
}

/// Where a formula comes from.
#[derive(Clone, Copy, Debug)]
pub enum Source<'a> {
    /// It is written so in the declaration.
    Written(&'a Expression),
    /// It is derived from what stands here.
    Derived(Region),
}

impl<'a> Sourced<'a> {
    /// Where it stands.
    pub fn region(self) -> Region {
        match self.source {
            Source::Written(expression) => expression.region,
            Source::Derived(region) => region,
        }
    }

    /// As it is written, or as it would be.
    pub fn text(self, names: &Names) -> String {
        match self.source {
            Source::Written(expression) => expression.to_string(),
            Source::Derived(_) => names.text(self.formula).to_string(),
        }
    }

    /// The terms, factors, base or argument; nothing inside a number with a unit, which is a formula but reads as one
    /// number.
    pub fn parts(self) -> Vec<Self> {
        let formulas: Vec<&'a Formula> = match self.formula {
            Formula::Sum(terms) => terms.iter().map(|term| &term.value).collect(),
            Formula::Product(factors) => factors.iter().map(|factor| &factor.value).collect(),
            Formula::Power(inner, _) | Formula::Call(_, inner) => vec![&**inner],
            Formula::Number(_) | Formula::Pi | Formula::Parameter(_) | Formula::Definition(_) => Vec::new(),
        };
        let Source::Written(expression) = self.source else {
            return formulas.into_iter().map(|formula| Self { formula, source: self.source }).collect();
        };
        let written: Vec<&'a Expression> = match &expression.kind {
            Kind::Sum(terms) => terms.iter().map(|term| &term.value).collect(),
            Kind::Product(factors) => factors.iter().map(|factor| &factor.value).collect(),
            Kind::Power(inner, _) | Kind::Call(_, inner) => vec![&**inner],
            Kind::Number(_) | Kind::Quantity(..) | Kind::Name(_) => Vec::new(),
        };
        let sources = written.into_iter().map(Source::Written);
        formulas.into_iter().zip(sources).map(|(formula, source)| Self { formula, source }).collect()
    }
}
