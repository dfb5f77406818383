//! Tokens to a syntax tree, spans kept: afterwards the declaration parses, and nothing is resolved.

mod declaration;
mod expression;
mod items;
mod number;
mod tokens;
mod unit;

pub use declaration::{Bound, Declaration, MatrixName, ParameterSet, Relation};
pub use expression::{Expression, Kind};
pub use number::Decimal;

use proc_macro2::TokenStream;
use syn::parse::Parser;

use crate::report::Report;

/// Parses a declaration as far as it goes: every statement that cannot be read is noted in the report and left out.
///
/// Nothing is returned if not even the name of the model and its braces are there.
pub fn parse(tokens: TokenStream, report: &mut Report) -> Option<Declaration> {
    let parser = |input: syn::parse::ParseStream<'_>| items::declaration(input, report);
    match parser.parse2(tokens) {
        Ok(declaration) => Some(declaration),
        Err(error) => {
            report.push(error);
            None
        }
    }
}
