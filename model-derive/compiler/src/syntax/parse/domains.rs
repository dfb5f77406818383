//! Domains of parameters, and the constants that bound them.

use syn::Token;
use syn::parse::ParseStream;

use super::expressions::parse_expression;
use super::tokens::expected;
use super::units::parse_unit_after_value;
use crate::report::Region;
use crate::syntax::tree::{Bound, Relation, Value};

/// `> 0`, if there is a comparison.
pub fn parse_comparison(input: ParseStream<'_>) -> syn::Result<Option<Bound>> {
    let span = input.span();
    let relation = if input.parse::<Option<Token![>=]>>()?.is_some() {
        Relation::GreaterEqual
    } else if input.parse::<Option<Token![<=]>>()?.is_some() {
        Relation::LessEqual
    } else if input.parse::<Option<Token![>]>>()?.is_some() {
        Relation::Greater
    } else if input.parse::<Option<Token![<]>>()?.is_some() {
        Relation::Less
    } else if input.parse::<Option<Token![!=]>>()?.is_some() {
        Relation::NotEqual
    } else {
        return Ok(None);
    };
    let value = parse_value(input)?;
    let region = Region::from(span).to(value.region());
    Ok(Some(Bound { relation, value, region }))
}

/// A constant, and a unit behind it if there is one.
pub fn parse_value(input: ParseStream<'_>) -> syn::Result<Value> {
    Ok(Value { number: parse_expression(input)?, unit: parse_unit_after_value(input)? })
}

/// `in (a, b)` without its ends, `in [a, b]` with them.
pub fn parse_interval(input: ParseStream<'_>) -> syn::Result<[Bound; 2]> {
    input.parse::<Token![in]>()?;
    let content;
    let relations = if input.peek(syn::token::Paren) {
        syn::parenthesized!(content in input);
        [Relation::Greater, Relation::Less]
    } else if input.peek(syn::token::Bracket) {
        syn::bracketed!(content in input);
        [Relation::GreaterEqual, Relation::LessEqual]
    } else {
        return Err(expected(input, "an interval: `(a, b)` without its ends or `[a, b]` with them"));
    };
    let low = parse_value(&content)?;
    if content.parse::<Option<Token![,]>>()?.is_none() {
        return Err(expected(&content, "`,` and the upper end of the interval"));
    }
    let high = parse_value(&content)?;
    if !content.is_empty() {
        return Err(expected(&content, "the end of the interval"));
    }
    let bound = |relation, value: Value| Bound { relation, region: value.region(), value };
    Ok([bound(relations[0], low), bound(relations[1], high)])
}
