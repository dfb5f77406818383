//! Units as people write them: `m`, `kg*m^2`, `N/kg`, `1`.

use proc_macro2::Literal;
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::ParseStream;

use super::tokens::{expected, signed_integer};

/// A product of powers of unit names, in one canonical spelling.
pub fn unit(input: ParseStream<'_>) -> syn::Result<String> {
    let mut text = factor(input, true)?;
    loop {
        let sign = if input.parse::<Option<Token![*]>>()?.is_some() {
            '*'
        } else if input.parse::<Option<Token![/]>>()?.is_some() {
            '/'
        } else {
            return Ok(text);
        };
        text.push(sign);
        text.push_str(&factor(input, false)?);
    }
}

fn factor(input: ParseStream<'_>, first: bool) -> syn::Result<String> {
    let what = "a unit such as `m`, `kg*m^2`, `N/kg`, or `1` for a pure number";
    if first && input.peek(syn::LitInt) {
        let literal: Literal = input.parse()?;
        return match literal.to_string().as_str() {
            "1" => Ok("1".into()),
            _ => Err(syn::Error::new(literal.span(), format!("found `{literal}`: expected {what}"))),
        };
    }
    if !input.peek(syn::Ident::peek_any) {
        return Err(expected(input, what));
    }
    let name = input.call(syn::Ident::parse_any)?;
    if input.parse::<Option<Token![^]>>()?.is_none() {
        return Ok(name.to_string());
    }
    let (power, _) = signed_integer(input)?;
    Ok(format!("{name}^{power}"))
}
