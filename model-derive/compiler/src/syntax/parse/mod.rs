//! From tokens to the syntax tree: one file for what is parsed by itself, and `tokens` for what they share.
//!
//! Every parser stands behind what it has read, and says in its error what it expected there.

mod attributes;
mod blocks;
mod compared;
mod declaration;
mod derivatives;
mod directions;
mod docs;
mod domains;
mod expressions;
mod feedback;
mod freedoms;
mod matrices;
mod mechanism;
mod names;
mod parameters;
mod parts;
mod rust_syntax;
mod sets;
mod statements;
mod tokens;
mod units;
mod vectors;

pub use self::expressions::constant;
pub use self::names::reserved;

use proc_macro2::{Span, TokenStream, TokenTree};
use syn::parse::{ParseStream, Parser};

use self::declaration::parse_declaration;
use crate::report::Report;
use crate::syntax::tree::Declaration;

/// Parses a declaration as far as it goes: every statement that cannot be read is noted in the report and left out.
///
/// Nothing is returned if not even the name of the model and its braces are there.
pub fn parse(tokens: TokenStream, report: &mut Report) -> Option<Declaration> {
    if let Some(span) = too_deep(&tokens) {
        report.error(span, format!("brackets nested too deeply: expected at most {MAX_BRACKETS} levels"));
        return None;
    }
    let mut declaration = None;
    let parser = |input: ParseStream<'_>| {
        declaration = Some(parse_declaration(input, report)?);
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
