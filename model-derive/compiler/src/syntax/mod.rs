//! Tokens to a syntax tree, spans kept: afterwards the declaration parses, and nothing is resolved.

mod attributes;
mod declaration;
mod display;
mod expression;
mod items;
mod mechanism;
mod parameters;
mod parts;
mod tokens;
mod unit;

pub use declaration::{
    Assertion, Bound, Coordinate, Declaration, Definition, Direction, Matrix, MatrixName, Parameter, ParameterSet,
    Printed, Published, Relation, Requirement, Value,
};
pub use expression::{Expression, Factor, Kind, Term, constant};
pub use parts::{Freedom, Inertia, JointKind, Mechanism, Vector};
pub use tokens::reserved;
pub use unit::Unit;

use proc_macro2::{Span, TokenStream, TokenTree};
use syn::parse::Parser;

use crate::report::Report;

/// Parses a declaration as far as it goes: every statement that cannot be read is noted in the report and left out.
///
/// Nothing is returned if not even the name of the model and its braces are there.
pub fn parse(tokens: TokenStream, report: &mut Report) -> Option<Declaration> {
    if let Some(span) = too_deep(&tokens) {
        report.error(span, format!("brackets nested too deeply: expected at most {MAX_BRACKETS} levels"));
        return None;
    }
    let mut declaration = None;
    let parser = |input: syn::parse::ParseStream<'_>| {
        declaration = Some(items::declaration(input, report)?);
        Ok(())
    };
    if let Err(error) = parser.parse2(tokens) {
        // After a statement that could not be read `syn` also notes what is left inside its brackets.
        if declaration.is_none() || report.is_empty() {
            report.push(error);
        }
    }
    declaration
}

/// Brackets within brackets; formulas have a lower limit of their own. `syn` would exhaust the stack of a thread at some
/// thousands.
const MAX_BRACKETS: usize = 256;

/// The first bracket that is nested too deeply.
fn too_deep(tokens: &TokenStream) -> Option<Span> {
    let mut open = vec![tokens.clone().into_iter()];
    while let Some(tokens) = open.last_mut() {
        match tokens.next() {
            Some(TokenTree::Group(group)) if open.len() > MAX_BRACKETS => return Some(group.span_open()),
            Some(TokenTree::Group(group)) => open.push(group.stream().into_iter()),
            Some(_) => {}
            None => {
                open.pop();
            }
        }
    }
    None
}
