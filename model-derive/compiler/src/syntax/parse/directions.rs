//! How a parameter or a coordinate lies in the axes.

use proc_macro2::Span;
use syn::Token;
use syn::parse::ParseStream;

use super::tokens::expected;
use crate::report::error;
use crate::syntax::tree::Direction;

/// `along x`, `along x*z`, `about y`, if it stands here.
pub fn parse_direction(input: ParseStream<'_>) -> syn::Result<Option<(Span, Direction)>> {
    let Some((word, _)) = input.cursor().ident().filter(|(word, _)| word == "along" || word == "about") else {
        return Ok(None);
    };
    input.parse::<syn::Ident>()?;
    let first = parse_axis(input)?;
    if word == "about" {
        return Ok(Some((word.span(), Direction::About(first))));
    }
    let mut odd = [false; 3];
    odd[first] = true;
    while input.parse::<Option<Token![*]>>()?.is_some() {
        let next = parse_axis(input)?;
        odd[next] = !odd[next];
    }
    Ok(Some((word.span(), Direction::Along(odd))))
}

/// The position of an axis among x, y and z.
fn parse_axis(input: ParseStream<'_>) -> syn::Result<usize> {
    let found = input.cursor().ident().and_then(|(word, _)| AXES.iter().position(|axis| word == axis));
    match found {
        Some(axis) => input.parse::<syn::Ident>().map(|_| axis),
        None => Err(expected(input, "an axis: `x`, `y` or `z`")),
    }
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// Sets a direction at its first word, unless one is given already.
pub fn set_once(place: &mut Option<Direction>, direction: Direction, span: Span) -> syn::Result<()> {
    match place.replace(direction) {
        Some(_) => Err(error(span, "a second direction: expected one, such as `along x*z`")),
        None => Ok(()),
    }
}
