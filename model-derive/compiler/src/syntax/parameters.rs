//! Parameters with their units and domains, and coordinates.

use syn::Token;
use syn::parse::ParseStream;

use super::declaration::{Bound, Coordinate, Parameter, Relation};
use super::expression::{Expression, expression};
use super::tokens::{docs, expected, name, semicolon, text};
use super::unit::unit;
use crate::report::{Region, Report, error};

/// `lam "λ": rad, in (-pi/2, pi/2);`
///
/// One that cannot be read to its end is there all the same: what uses it is no further mistake.
pub fn parameter(input: ParseStream<'_>, parameters: &mut Vec<Parameter>, report: &mut Report) -> syn::Result<()> {
    let docs = docs(input, report)?;
    let name = name(input, "the name of a parameter")?;
    let unit = PURE_NUMBER.to_string();
    parameters.push(Parameter { docs, name, symbol: None, unit, bounds: Vec::new(), gravity: None, unused: None });
    let Some(parameter) = parameters.last_mut() else { return Ok(()) };
    after_name(input, parameter)
}

/// The unit of what has none that could be read.
const PURE_NUMBER: &str = "1";

fn after_name(input: ParseStream<'_>, parameter: &mut Parameter) -> syn::Result<()> {
    parameter.symbol = text(input)?;
    colon(input)?;
    parameter.unit = unit(input)?;
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
    semicolon(input, "`,` or `;`", "the parameter")
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

/// `phi "lean": rad;`, there all the same if it cannot be read to its end.
pub fn coordinate(input: ParseStream<'_>, coordinates: &mut Vec<Coordinate>, report: &mut Report) -> syn::Result<()> {
    let docs = docs(input, report)?;
    let name = name(input, "the name of a coordinate")?;
    coordinates.push(Coordinate { docs, name, label: None, unit: PURE_NUMBER.to_string() });
    let Some(coordinate) = coordinates.last_mut() else { return Ok(()) };
    coordinate.label = text(input)?;
    colon(input)?;
    coordinate.unit = unit(input)?;
    semicolon(input, "`;`", "the coordinate")
}
