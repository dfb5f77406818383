//! Parameters with their units and domains, and coordinates.

use proc_macro2::Span;
use syn::Token;
use syn::parse::ParseStream;

use super::declaration::{Bound, Coordinate, Direction, Parameter, Relation, Value};
use super::expression::expression;
use super::tokens::{declared, docs, expected, reserved, semicolon, text};
use super::unit::{unit, unit_after_value};
use crate::report::{Region, Report, error};

/// `lam "λ": rad, in (-pi/2, pi/2);`
///
/// One that cannot be read to its end is there all the same: what uses it is no further mistake.
pub fn parameter(
    input: ParseStream<'_>,
    parameters: &mut Vec<Parameter>,
    unread: &mut Vec<syn::Ident>,
    report: &mut Report,
) -> syn::Result<()> {
    let what = "the name of a parameter";
    let docs = docs(input, what, report)?;
    let name = declared(input, what)?;
    let reserved = reserved(&name.to_string());
    let bounds = Vec::new();
    let mut parameter =
        Parameter { docs, name, symbol: None, unit: None, bounds, direction: None, gravity: None, unused: None };
    // Of one that is only half read nothing should follow.
    let read = after_name(input, &mut parameter).inspect_err(|_| parameter.unit = None);
    match reserved {
        None => parameters.push(parameter),
        // It could not become a field.
        Some(what) => {
            report.error(&parameter.name, format!("`{}` is {what}: expected another name", parameter.name));
            unread.push(parameter.name);
        }
    }
    read
}

fn after_name(input: ParseStream<'_>, parameter: &mut Parameter) -> syn::Result<()> {
    parameter.symbol = text(input)?;
    colon(input)?;
    parameter.unit = Some(unit(input)?);
    while input.parse::<Option<Token![,]>>()?.is_some() {
        if let Some(bound) = comparison(input)? {
            parameter.bounds.push(bound);
        } else if input.peek(Token![in]) {
            parameter.bounds.extend(interval(input)?);
        } else if let Some((span, direction)) = direction(input)? {
            once(&mut parameter.direction, direction, span)?;
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
    let plain = parameter.bounds.is_empty() && parameter.direction.is_none();
    semicolon(input, if plain { "`*`, `/`, `,` or `;`" } else { "`,` or `;`" }, "the parameter")
}

const AFTER_UNIT: &str = "a domain (`> 0`, `>= 0`, `!= 0`, `in (a, b)`, `in [a, b]`), a direction (`along x`, `about y`), \
                          `gravity` or `unused`";

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
    } else if input.parse::<Option<Token![!=]>>()?.is_some() {
        Relation::NotEqual
    } else {
        return Ok(None);
    };
    let value = value(input)?;
    let region = Region::from(span).to(value.region());
    Ok(Some(Bound { relation, value, region }))
}

/// A constant, and a unit behind it if there is one.
pub fn value(input: ParseStream<'_>) -> syn::Result<Value> {
    Ok(Value { number: expression(input)?, unit: unit_after_value(input)? })
}

/// `along x`, `along x*z`, `about y`, if it stands here.
fn direction(input: ParseStream<'_>) -> syn::Result<Option<(Span, Direction)>> {
    let Some((word, _)) = input.cursor().ident().filter(|(word, _)| word == "along" || word == "about") else {
        return Ok(None);
    };
    input.parse::<syn::Ident>()?;
    let first = axis(input)?;
    if word == "about" {
        return Ok(Some((word.span(), Direction::About(first))));
    }
    let mut odd = [false; 3];
    odd[first] = true;
    while input.parse::<Option<Token![*]>>()?.is_some() {
        let next = axis(input)?;
        odd[next] = !odd[next];
    }
    Ok(Some((word.span(), Direction::Along(odd))))
}

/// The position of an axis among x, y and z.
fn axis(input: ParseStream<'_>) -> syn::Result<usize> {
    let found = input.cursor().ident().and_then(|(word, _)| AXES.iter().position(|axis| word == axis));
    match found {
        Some(axis) => input.parse::<syn::Ident>().map(|_| axis),
        None => Err(expected(input, "an axis: `x`, `y` or `z`")),
    }
}

const AXES: [&str; 3] = ["x", "y", "z"];

fn once(place: &mut Option<Direction>, direction: Direction, span: Span) -> syn::Result<()> {
    match place.replace(direction) {
        Some(_) => Err(error(span, "a second direction: expected one, such as `along x*z`")),
        None => Ok(()),
    }
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
    let low = value(&content)?;
    if content.parse::<Option<Token![,]>>()?.is_none() {
        return Err(expected(&content, "`,` and the upper end of the interval"));
    }
    let high = value(&content)?;
    if !content.is_empty() {
        return Err(expected(&content, "the end of the interval"));
    }
    let bound = |relation, value: Value| Bound { relation, region: value.region(), value };
    Ok([bound(relations[0], low), bound(relations[1], high)])
}

/// `phi "lean": rad, about x;`, there all the same if it cannot be read to its end.
pub fn coordinate(input: ParseStream<'_>, coordinates: &mut Vec<Coordinate>, report: &mut Report) -> syn::Result<()> {
    let what = "the name of a coordinate";
    let docs = docs(input, what, report)?;
    let name = declared(input, what)?;
    coordinates.push(Coordinate { docs, name, label: None, unit: None, direction: None });
    let Some(coordinate) = coordinates.last_mut() else { return Ok(()) };
    after_coordinate(input, coordinate).inspect_err(|_| coordinate.unit = None)
}

fn after_coordinate(input: ParseStream<'_>, coordinate: &mut Coordinate) -> syn::Result<()> {
    coordinate.label = text(input)?;
    colon(input)?;
    coordinate.unit = Some(unit(input)?);
    while input.parse::<Option<Token![,]>>()?.is_some() {
        let Some((span, direction)) = direction(input)? else {
            return Err(expected(input, "a direction (`along y`, `about x`)"));
        };
        once(&mut coordinate.direction, direction, span)?;
    }
    semicolon(input, "`,` or `;`", "the coordinate")
}

/// Whether a parameter or a coordinate starts here.
pub fn starts(input: ParseStream<'_>) -> bool {
    input.peek(syn::Ident)
        && (input.peek2(Token![:]) && !input.peek2(Token![::]) || input.peek2(syn::LitStr) && input.peek3(Token![:]))
}
