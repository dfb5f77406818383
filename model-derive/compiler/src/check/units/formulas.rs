//! The units of formulas whose names are resolved, and of the entries of matrices.

use std::convert::Infallible;

use super::declared::Dimensions;
use super::dimension::Dimension;
use super::entry_dimension;
use crate::formula::{Algebra, Decimal, Factor, Formula, Function, Term, Values};
use crate::matrix_name::MatrixName;
use crate::syntax::{Declaration, Expression, Kind};

/// What is known of the units of a model without mistakes.
#[derive(Clone, Debug)]
pub struct Units {
    dimensions: Dimensions,
    definitions: Vec<Option<Dimension>>,
    /// What a number is in: formulas no longer know which of them were written with a unit.
    number: Option<Dimension>,
}

impl Units {
    /// `definitions` are the dimensions of those of the declaration, in their order.
    pub fn new(declaration: &Declaration, dimensions: Dimensions, definitions: Vec<Option<Dimension>>) -> Self {
        let written = declaration.definitions.iter().map(|definition| &definition.value);
        let attributes = declaration.mechanism.iter().flat_map(|mechanism| mechanism.formulas());
        let has_quantities = written.chain(attributes).any(has_quantity);
        Self { dimensions, definitions, number: (!has_quantities).then_some(Dimension::NUMBER) }
    }

    /// The same with the definitions of a derivation, which stand behind those of the declaration.
    pub fn with_derived(&self, definitions: &[Formula]) -> Self {
        let mut units = self.clone();
        for definition in &definitions[self.definitions.len()..] {
            let Ok(dimension) = definition.fold(&units);
            units.definitions.push(dimension);
        }
        units
    }

    /// The unit of a formula; empty where it is not known.
    pub fn of(&self, formula: &Formula) -> String {
        let Ok(dimension) = formula.fold(self);
        text(dimension)
    }

    /// The unit of a definition; empty where it is not known.
    pub fn of_definition(&self, index: usize) -> String {
        text(self.definitions[index])
    }

    /// The unit of an entry of a matrix.
    pub fn of_entry(&self, matrix: MatrixName, row: usize, column: usize) -> String {
        let [row, column] = [row, column].map(|index| self.dimensions.coordinates[index]);
        text(row.zip(column).and_then(|(row, column)| entry_dimension(matrix, row, column)))
    }
}

fn text(dimension: Option<Dimension>) -> String {
    dimension.map(|dimension| dimension.to_string()).unwrap_or_default()
}

fn has_quantity(formula: &Expression) -> bool {
    match &formula.kind {
        Kind::Quantity(..) => true,
        Kind::Number(_) | Kind::Name(_) => false,
        Kind::Sum(terms) => terms.iter().any(|term| has_quantity(&term.value)),
        Kind::Product(factors) => factors.iter().any(|factor| has_quantity(&factor.value)),
        Kind::Power(inner, _) | Kind::Call(_, inner) => has_quantity(inner),
    }
}

impl Algebra for Units {
    type Value = Option<Dimension>;
    type Error = Infallible;

    fn number(&self, number: &Decimal) -> Result<Option<Dimension>, Infallible> {
        Ok(self.number.filter(|_| !number.is_zero()))
    }

    fn pi(&self) -> Option<Dimension> {
        Some(Dimension::NUMBER)
    }

    fn parameter(&self, index: usize) -> Option<Dimension> {
        self.dimensions.parameters[index]
    }

    fn definition(&self, index: usize) -> Option<Dimension> {
        self.definitions[index]
    }

    /// All terms are in the unit of one.
    fn sum(&self, terms: impl Values<Term<Option<Dimension>>, Infallible>) -> Result<Option<Dimension>, Infallible> {
        Ok(terms.fold(None, |known, Ok(term)| known.or(term.value)))
    }

    fn product(
        &self,
        factors: impl Values<Factor<Option<Dimension>>, Infallible>,
    ) -> Result<Option<Dimension>, Infallible> {
        let mut dimension = Some(Dimension::NUMBER);
        for Ok(Factor { inverse, value }) in factors {
            let value = if inverse { value.and_then(|value| value.power(-1)) } else { value };
            dimension = dimension.zip(value).and_then(|(product, value)| product.times(value));
        }
        Ok(dimension)
    }

    fn power(&self, base: Option<Dimension>, exponent: i32) -> Result<Option<Dimension>, Infallible> {
        Ok(base.and_then(|base| base.power(exponent)))
    }

    fn call(&self, function: Function, argument: Option<Dimension>) -> Result<Option<Dimension>, Infallible> {
        Ok(match function {
            Function::Sqrt => argument.and_then(Dimension::root),
            Function::Sin | Function::Cos | Function::Tan => Some(Dimension::NUMBER),
        })
    }
}
