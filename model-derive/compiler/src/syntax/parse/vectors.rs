//! Vectors and moments of inertia, as attributes of parts give them.

use proc_macro2::Ident;
use syn::parse::ParseStream;

use super::expressions::parse_expression;
use super::tokens::{expected, parse_items, parse_list};
use crate::report::{Region, error};
use crate::syntax::tree::{Expression, Inertia, Kind, Vector};

/// `(x, y, z)`
pub fn parse_vector(input: ParseStream<'_>, word: &Ident) -> syn::Result<Vector> {
    if !input.peek(syn::token::Paren) {
        return Err(expected(input, &format!("`(x, y, z)` after `{word}`")));
    }
    let content;
    let parentheses = syn::parenthesized!(content in input);
    let region = Region::from(parentheses.span.open()).to(parentheses.span.close().into());
    let components = parse_items(&content, "`,` or `)`", parse_expression)?;
    let message = format!("{} components of `{word}`: expected three, `(x, y, z)`", components.len());
    let components = components.try_into().map_err(|_| error(region, message))?;
    Ok(Vector { components, region })
}

/// `[[…], […], […]]`, `[Ixx, Iyy, Izz]` or `0`
pub fn parse_inertia(input: ParseStream<'_>) -> syn::Result<Inertia> {
    if !input.peek(syn::token::Bracket) {
        let value = parse_expression(input)?;
        return match &value.kind {
            Kind::Number(number) if number.is_zero() => Ok(Inertia::None),
            _ => {
                let message =
                    "an inertia of one moment: expected `[Ixx, Iyy, Izz]`, `[[…], […], […]]`, or `0` for a point mass";
                Err(error(value.region, message))
            }
        };
    }
    let is_full = {
        let fork = input.fork();
        let content;
        syn::bracketed!(content in fork);
        content.peek(syn::token::Bracket)
    };
    if !is_full {
        let (region, moments) = parse_list(input, "the principal moments", parse_expression)?;
        let found = moments.len();
        let message = format!("{found} moments of inertia: expected three, `[Ixx, Iyy, Izz]`");
        let moments = moments.try_into().map_err(|_| error(region, message))?;
        return Ok(Inertia::Principal(Box::new(moments)));
    }
    let (region, rows) = parse_list(input, "the rows", |input| parse_list(input, "a row `[…]`", parse_expression))?;
    let rows: Option<Vec<[Expression; 3]>> = rows.into_iter().map(|(_, row)| row.try_into().ok()).collect();
    match rows.and_then(|rows| <[[Expression; 3]; 3]>::try_from(rows).ok()) {
        Some(rows) => Ok(Inertia::Full(Box::new(rows))),
        None => {
            let message = "an inertia matrix of another shape: expected 3 rows of 3 entries, \
                           `[[Ixx, Ixy, Ixz], [Ixy, Iyy, Iyz], [Ixz, Iyz, Izz]]`";
            Err(error(region, message))
        }
    }
}
