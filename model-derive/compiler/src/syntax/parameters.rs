//! Parameters with their units and domains, and coordinates.

use syn::Token;
use syn::parse::ParseStream;

use super::declaration::{Bound, Coordinate, Doc, Parameter, Relation};
use super::expression::{Expression, expression};
use super::tokens::{declared, docs, expected, reserved, semicolon, text};
use super::unit::unit;
use crate::report::{Region, Report, error};

/// `lam "λ": rad, in (-pi/2, pi/2);`
pub fn parameter(
    input: ParseStream<'_>,
    parameters: &mut Vec<Parameter>,
    unread: &mut Vec<syn::Ident>,
    report: &mut Report,
) -> syn::Result<()> {
    let what = "the name of a parameter";
    let docs = docs(input, what, report)?;
    let name = declared(input, what)?;
    match parameter_after_name(input, docs, &name) {
        Ok(parameter) => match reserved(&name.to_string()) {
            None => parameters.push(parameter),
            // It could not become a field.
            Some(what) => {
                report.error(&name, format!("`{name}` is {what}: expected another name"));
                unread.push(name);
            }
        },
        Err(error) => {
            unread.push(name);
            return Err(error);
        }
    }
    Ok(())
}

fn parameter_after_name(input: ParseStream<'_>, docs: Doc, name: &syn::Ident) -> syn::Result<Parameter> {
    let symbol = text(input)?;
    colon(input)?;
    let unit = unit(input)?;
    let mut parameter =
        Parameter { docs, name: name.clone(), symbol, unit, bounds: Vec::new(), gravity: None, unused: None };
    while input.parse::<Option<Token![,]>>()?.is_some() {
        if let Some(bound) = comparison(input)? {
            parameter.bounds.push(bound);
        } else if input.peek(Token![in]) {
            parameter.bounds.extend(interval(input)?);
        } else if input.peek(syn::Ident) {
            let word: syn::Ident = input.parse()?;
            match word.to_string().as_str() {
                "gravity" => parameter.gravity = Some(word.span()),
                "unused" => parameter.unused = Some(word.span()),
                other => return Err(error(&word, format!("found `{other}`: expected {AFTER_UNIT}"))),
            }
        } else {
            return Err(expected(input, AFTER_UNIT));
        }
    }
    semicolon(input, "`,` or `;`", "the parameter")?;
    Ok(parameter)
}

const AFTER_UNIT: &str = "a domain (`> 0`, `>= 0`, `in (a, b)`, `in [a, b]`), `gravity` or `unused`";

fn colon(input: ParseStream<'_>) -> syn::Result<()> {
    if input.peek(Token![:]) && !input.peek(Token![::]) {
        input.parse::<Token![:]>()?;
        return Ok(());
    }
    Err(expected(input, "`:` and a unit"))
}

/// `> 0`, if there is a comparison.
pub fn comparison(input: ParseStream<'_>) -> syn::Result<Option<Bound>> {
    let span = input.span();
    let relation = if input.parse::<Option<Token![>=]>>()?.is_some() {
        Relation::GreaterEqual
    } else if input.parse::<Option<Token![<=]>>()?.is_some() {
        Relation::LessEqual
    } else if input.parse::<Option<Token![>]>>()?.is_some() {
        Relation::Greater
    } else if input.parse::<Option<Token![<]>>()?.is_some() {
        Relation::Less
    } else {
        return Ok(None);
    };
    let value = expression(input)?;
    let region = Region::from(span).to(value.region);
    Ok(Some(Bound { relation, value, region }))
}

/// `in (a, b)` without its ends, `in [a, b]` with them.
fn interval(input: ParseStream<'_>) -> syn::Result<[Bound; 2]> {
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
    let low = expression(&content)?;
    if content.parse::<Option<Token![,]>>()?.is_none() {
        return Err(expected(&content, "`,` and the upper end of the interval"));
    }
    let high = expression(&content)?;
    if !content.is_empty() {
        return Err(expected(&content, "the end of the interval"));
    }
    let bound = |relation, value: Expression| Bound { relation, region: value.region, value };
    Ok([bound(relations[0], low), bound(relations[1], high)])
}

pub fn coordinate(input: ParseStream<'_>, report: &mut Report) -> syn::Result<Coordinate> {
    let what = "the name of a coordinate";
    let docs = docs(input, what, report)?;
    let name = declared(input, what)?;
    let label = text(input)?;
    colon(input)?;
    let unit = unit(input)?;
    semicolon(input, "`;`", "the coordinate")?;
    Ok(Coordinate { docs, name, label, unit })
}

/// Whether a parameter or a coordinate starts here.
pub fn starts(input: ParseStream<'_>) -> bool {
    input.peek(syn::Ident)
        && (input.peek2(Token![:]) && !input.peek2(Token![::]) || input.peek2(syn::LitStr) && input.peek3(Token![:]))
}
