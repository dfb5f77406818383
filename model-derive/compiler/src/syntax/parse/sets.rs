//! Parameter sets, with the matrices that are published for them.

use proc_macro2::TokenTree;
use syn::Token;
use syn::parse::ParseStream;
use syn::parse::discouraged::Speculative as _;

use super::blocks::parse_block;
use super::docs::reject_docs;
use super::domains::parse_value;
use super::matrices::{parse_name_behind, parse_rows, starts_minus_one};
use super::names::{parse_declared, parse_name};
use super::tokens::{expected, parse_equals, parse_semicolon, parse_text};
use crate::formula::Decimal;
use crate::report::{Region, Report, error};
use crate::syntax::tree::{Declaration, ParameterSet, Printed, Published, RustAttribute, SetValue};

/// `set benchmark "source" { w = 1.02; }`, behind its first word.
pub fn parse_set(
    input: ParseStream<'_>,
    (docs, attributes): (String, Vec<RustAttribute>),
    model: &mut Declaration,
    report: &mut Report,
) -> syn::Result<()> {
    let name = parse_name(input, "the name of a parameter set")?;
    let source = parse_text(input)?;
    let mut values = Vec::new();
    let mut published = Vec::new();
    let starts = |input: ParseStream<'_>| {
        let behind = input.fork();
        let numbered = behind.parse::<syn::Ident>().is_ok_and(|word| word == "C") && starts_minus_one(&behind);
        numbered || input.peek(syn::Ident) && input.peek2(Token![=]) && !input.peek2(Token![==])
    };
    parse_block(input, "the values of the set", report, starts, |input, report| {
        let what = "the name of a parameter";
        reject_docs(input, what, report)?;
        let name = parse_declared(input, what)?;
        let ahead = input.fork();
        if let Some(matrix) = parse_name_behind(&name.to_string(), &ahead)?
            && ahead.peek(Token![=])
            && ahead.peek2(syn::token::Bracket)
        {
            input.advance_to(&ahead);
            input.parse::<Token![=]>()?;
            let (region, rows) = parse_rows(input, parse_printed)?;
            published.push(Published { name: matrix, span: name.span(), rows, region });
            return parse_semicolon(input, "`;`", "the matrix");
        }
        let value = || {
            parse_equals(input, "`=` and a value")?;
            let value = parse_value(input)?;
            parse_semicolon(input, "an operator (`+ - * / ^`), a unit or `;`", "the value")?;
            Ok(value)
        };
        let value = value();
        values.push(SetValue { name, value: value.as_ref().ok().cloned() });
        value.map(|_| ())
    })?;
    // Nothing but `#[default]` is let through.
    let defaults = attributes.into_iter().map(|attribute| attribute.region).collect();
    model.sets.push(ParameterSet { docs, defaults, name, source, values, published });
    Ok(())
}

/// A decimal number as it was printed, with its sign.
fn parse_printed(input: ParseStream<'_>) -> syn::Result<Printed> {
    let minus = input.parse::<Option<Token![-]>>()?;
    let Some((TokenTree::Literal(literal), _)) = input.cursor().token_tree() else {
        return Err(expected(input, "a decimal number as it was printed"));
    };
    input.parse::<TokenTree>()?;
    Decimal::from_literal(&literal).map_err(|message| error(literal.span(), message))?;
    let region = Region::from(literal.span());
    let sign = if minus.is_some() { "-" } else { "" };
    let text = format!("{sign}{}", literal.to_string().replace('_', ""));
    Ok(Printed { text, region: minus.map_or(region, |minus| Region::from(minus.span).to(region)) })
}
