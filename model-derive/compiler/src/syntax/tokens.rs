//! Small parsers that several statements share.

use proc_macro2::{Delimiter, Literal, TokenTree};
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::spanned::Spanned;

use super::declaration::Doc;
use super::number::Decimal;
use crate::report::{Region, Report, error};

/// "expected `what`, found …" at the next token.
pub fn expected(input: ParseStream<'_>, what: &str) -> syn::Error {
    match input.cursor().token_tree() {
        Some((TokenTree::Group(group), _)) => {
            let open = match group.delimiter() {
                Delimiter::Parenthesis => "`(`",
                Delimiter::Bracket => "`[`",
                Delimiter::Brace => "`{`",
                Delimiter::None => "an expression",
            };
            syn::Error::new(group.span_open(), format!("found {open}: expected {what}"))
        }
        Some((token, _)) => syn::Error::new(token.span(), format!("found `{token}`: expected {what}")),
        None => syn::Error::new(input.span(), format!("found nothing more: expected {what}")),
    }
}

/// A name of the user's, and not a word of Rust.
pub fn name(input: ParseStream<'_>, what: &str) -> syn::Result<syn::Ident> {
    if !input.peek(syn::Ident::peek_any) {
        return Err(expected(input, what));
    }
    let ident = input.call(syn::Ident::parse_any)?;
    let text = ident.to_string();
    if text.starts_with("r#") {
        return Err(syn::Error::new(ident.span(), format!("raw identifiers are not supported: expected {what}")));
    }
    if syn::parse_str::<syn::Ident>(&text).is_err() {
        return Err(syn::Error::new(ident.span(), format!("`{text}` is a keyword of Rust: expected {what}")));
    }
    Ok(ident)
}

/// The `;` that ends a statement; `what` says what could stand in its place.
pub fn semicolon(input: ParseStream<'_>, what: &str, after: &str) -> syn::Result<()> {
    if input.peek(Token![;]) {
        input.parse::<Token![;]>()?;
        return Ok(());
    }
    Err(expected(input, &format!("{what} after {after}")))
}

/// An integer with an optional sign, as in an exponent, and where it stands.
pub fn signed_integer(input: ParseStream<'_>) -> syn::Result<(i32, Region)> {
    let what = "a whole number as the exponent";
    let minus = input.parse::<Option<Token![-]>>()?;
    let Some((TokenTree::Literal(_), _)) = input.cursor().token_tree() else {
        return Err(expected(input, what));
    };
    let literal: Literal = input.parse()?;
    let region =
        minus.map_or(Region::from(literal.span()), |minus| Region::from(minus.span()).to(literal.span().into()));
    let number = Decimal::from_literal(&literal).map_err(|message| error(literal.span(), message))?;
    let integer = number.to_integer().filter(|value| value.unsigned_abs() <= MAX_EXPONENT);
    let Some(value) = integer else {
        return Err(error(region, format!("found `{literal}`: expected {what}, at most {MAX_EXPONENT}")));
    };
    Ok((if minus.is_some() { -value } else { value }, region))
}

/// Larger exponents have no use in mechanics and would only make large programs.
const MAX_EXPONENT: u32 = 64;

/// Documentation comments; any other attribute is a mistake, and what it stands on is read all the same.
pub fn docs(input: ParseStream<'_>, report: &mut Report) -> syn::Result<Doc> {
    let mut lines = Vec::new();
    for attribute in input.call(syn::Attribute::parse_outer)? {
        let text = match &attribute.meta {
            syn::Meta::NameValue(meta) if meta.path.is_ident("doc") => match &meta.value {
                syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
                _ => None,
            },
            _ => None,
        };
        let Some(text) = text else {
            let region = Region::from(attribute.pound_token.span()).to(attribute.bracket_token.span.close().into());
            report.error(region, "an attribute that is not supported here: expected documentation (`/// …`)");
            continue;
        };
        lines.push(text.strip_prefix(' ').unwrap_or(&text).trim_end().to_string());
    }
    Ok(lines.join("\n").trim_matches('\n').to_string())
}

/// An optional text in quotes.
pub fn text(input: ParseStream<'_>) -> syn::Result<Option<String>> {
    Ok(if input.peek(syn::LitStr) { Some(input.parse::<syn::LitStr>()?.value()) } else { None })
}

/// Whether the next tokens look like the start of a statement whose predecessor lacks its `;`.
fn starts_statement(input: ParseStream<'_>) -> bool {
    let named = input.peek(syn::Ident) && !input.peek2(Token![==]) && !input.peek2(Token![::]);
    input.peek(Token![let]) || named && (input.peek2(Token![=]) || input.peek2(Token![:]) || input.peek2(syn::LitStr))
}

/// Skips what is left of a statement that could not be read: through the next `;` or brace, or up to the
/// start of another.
///
/// `moved` says whether the failed attempt took any token; if not, at least one is skipped.
pub fn skip_statement(input: ParseStream<'_>, mut moved: bool) {
    while let Some((token, _)) = input.cursor().token_tree() {
        if moved && starts_statement(input) {
            return;
        }
        moved = true;
        let semicolon = matches!(&token, TokenTree::Punct(punct) if punct.as_char() == ';');
        let brace = matches!(&token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
        if input.parse::<TokenTree>().is_err() || semicolon {
            return;
        }
        // `let a = if b { c };` ends behind its braces.
        if brace && !input.peek(Token![;]) {
            return;
        }
    }
}
