//! Units as people write them: `m`, `kg*m^2`, `N/(m/s)`, `1`.

use proc_macro2::Literal;
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::ParseStream;

use super::tokens::{expected, parse_signed_integer};
use crate::report::Region;
use crate::syntax::tree::Unit;

/// What is said to be expected where no unit stands.
const WHAT: &str = "a unit such as `m`, `kg*m^2`, `N/kg`, or `1` for a pure number";

/// Parses a unit up to the first token that cannot continue one.
pub fn parse_unit(input: ParseStream<'_>) -> syn::Result<Unit> {
    parse_product(input, true)
}

/// Units with `*` and `/` between them.
fn parse_product(input: ParseStream<'_>, parentheses: bool) -> syn::Result<Unit> {
    let mut unit = parse_factor(input, parentheses)?;
    loop {
        let sign = if input.parse::<Option<Token![*]>>()?.is_some() {
            '*'
        } else if input.parse::<Option<Token![/]>>()?.is_some() {
            '/'
        } else {
            return Ok(unit);
        };
        let next = parse_factor(input, parentheses)?;
        unit.text.push(sign);
        unit.text.push_str(&next.text);
        unit.region = unit.region.to(next.region);
        unit.factors.extend(next.factors.into_iter().map(|(name, n)| (name, if sign == '/' { -n } else { n })));
    }
}

/// A unit behind a value, if there is one, `1/s` among them; a name before `=`, `:` or a text begins the next statement.
pub fn parse_unit_after_value(input: ParseStream<'_>) -> syn::Result<Option<Unit>> {
    let next = input.peek2(Token![=]) || input.peek2(Token![:]) || input.peek2(syn::LitStr);
    let named = input.peek(syn::Ident) && !next;
    let inverse = input.peek(syn::LitInt) && input.peek2(Token![/]);
    if named || inverse { parse_unit(input).map(Some) } else { Ok(None) }
}

/// One name with its exponent, or a product in parentheses, which need not nest.
fn parse_factor(input: ParseStream<'_>, parentheses: bool) -> syn::Result<Unit> {
    if parentheses && input.peek(syn::token::Paren) {
        let content;
        let parentheses = syn::parenthesized!(content in input);
        let inner = parse_product(&content, false)?;
        if !content.is_empty() {
            return Err(expected(&content, "`*`, `/` or `)`"));
        }
        let region = Region::from(parentheses.span.open()).to(parentheses.span.close().into());
        return Ok(Unit { text: format!("({})", inner.text), region, ..inner });
    }
    if input.peek(syn::LitInt) {
        let literal: Literal = input.parse()?;
        let text = literal.to_string();
        return match text.as_str() {
            "1" => Ok(Unit { text, factors: Vec::new(), region: literal.span().into() }),
            _ => Err(syn::Error::new(literal.span(), format!("found `{text}`: expected {WHAT}"))),
        };
    }
    if !input.peek(syn::Ident::peek_any) {
        return Err(expected(input, WHAT));
    }
    let name = input.call(syn::Ident::parse_any)?;
    let region = Region::from(&name);
    if input.parse::<Option<Token![^]>>()?.is_none() {
        return Ok(Unit { text: name.to_string(), factors: vec![(name, 1)], region });
    }
    let (power, end) = parse_signed_integer(input)?;
    Ok(Unit { text: format!("{name}^{power}"), factors: vec![(name, power)], region: region.to(end) })
}
