//! Names: where they are declared, where they are used, and what cannot be one.

use syn::ext::IdentExt;
use syn::parse::ParseStream;

use super::tokens::expected;
use crate::report::error;

/// What an identifier is, if no model can have it for a name: a word of Rust, in the edition that has the most of them,
/// or a raw one.
pub fn reserved(name: &str) -> Option<&'static str> {
    if name.starts_with("r#") {
        Some("a raw identifier")
    } else if name == "gen" || syn::parse_str::<syn::Ident>(name).is_err() {
        Some("a keyword of Rust")
    } else {
        None
    }
}

/// A name that is declared here. A reserved one is read too, unless a name follows, and refused later: then its uses are
/// no further mistakes.
pub fn parse_declared(input: ParseStream<'_>, what: &str) -> syn::Result<syn::Ident> {
    if input.peek(syn::Ident::peek_any) && !input.peek2(syn::Ident::peek_any) {
        return input.call(syn::Ident::parse_any);
    }
    parse_name(input, what)
}

/// A name of the user's, and not a word of Rust.
pub fn parse_name(input: ParseStream<'_>, what: &str) -> syn::Result<syn::Ident> {
    if !input.peek(syn::Ident::peek_any) {
        return Err(expected(input, what));
    }
    let ident = input.call(syn::Ident::parse_any)?;
    let text = ident.to_string();
    match reserved(&text) {
        Some(reserved) => Err(error(&ident, format!("`{text}` is {reserved}: expected {what}"))),
        None => Ok(ident),
    }
}

/// A name that is declared elsewhere, where a reserved one is refused.
pub fn parse_used(input: ParseStream<'_>, what: &str) -> syn::Result<syn::Ident> {
    if input.peek(syn::Ident::peek_any) { input.call(syn::Ident::parse_any) } else { Err(expected(input, what)) }
}
