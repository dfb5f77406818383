//! Small parsers that several statements share.

use proc_macro2::{Delimiter, Literal, Spacing, TokenStream, TokenTree};
use syn::Token;
use syn::buffer::Cursor;
use syn::ext::IdentExt;
use syn::parse::ParseStream;

use super::declaration::Doc;
use crate::formula::Decimal;
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
        // The mark before a lifetime is no operator.
        Some((TokenTree::Punct(punct), _)) if punct.as_char() != '\'' => {
            let (operator, region) = operator(input.cursor());
            error(region, format!("found `{operator}`: expected {what}"))
        }
        Some((token, _)) => syn::Error::new(token.span(), format!("found `{token}`: expected {what}")),
        None => syn::Error::new(input.span(), format!("found nothing more: expected {what}")),
    }
}

/// Operators of Rust that are written with several marks, longer ones first.
const OPERATORS: [&str; 21] = [
    "..=", "<<=", ">>=", "==", "!=", "<=", ">=", "&&", "||", "<<", ">>", "->", "=>", "..", "::", "+=", "-=", "*=",
    "/=", "^=", "%=",
];

/// The operator at a mark, with the marks that belong to it, and where it stands.
pub fn operator(mut cursor: Cursor<'_>) -> (String, Region) {
    let mut marks = Vec::new();
    while let Some((punct, after)) = cursor.punct() {
        let last = punct.spacing() == Spacing::Alone;
        marks.push(punct);
        cursor = after;
        if last {
            break;
        }
    }
    let text: String = marks.iter().map(|mark| mark.as_char()).collect();
    let known = OPERATORS.into_iter().find(|operator| text.starts_with(operator));
    let length = known.map_or(1, str::len).min(marks.len());
    let spans = marks[..length].iter().map(|mark| Region::from(mark.span()));
    let region = spans.reduce(Region::to).unwrap_or(cursor.span().into());
    (text.chars().take(length).collect(), region)
}

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
pub fn declared(input: ParseStream<'_>, what: &str) -> syn::Result<syn::Ident> {
    if input.peek(syn::Ident::peek_any) && !input.peek2(syn::Ident::peek_any) {
        return input.call(syn::Ident::parse_any);
    }
    name(input, what)
}

/// A name of the user's, and not a word of Rust.
pub fn name(input: ParseStream<'_>, what: &str) -> syn::Result<syn::Ident> {
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
pub fn used(input: ParseStream<'_>, what: &str) -> syn::Result<syn::Ident> {
    if input.peek(syn::Ident::peek_any) { input.call(syn::Ident::parse_any) } else { Err(expected(input, what)) }
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
    let region = minus.map_or(Region::from(literal.span()), |minus| Region::from(minus.span).to(literal.span().into()));
    let number = Decimal::from_literal(&literal).map_err(|message| error(literal.span(), message))?;
    let integer = number.to_integer().filter(|value| value.unsigned_abs() <= MAX_EXPONENT);
    let Some(value) = integer else {
        return Err(error(region, format!("found `{literal}`: expected {what}, at most {MAX_EXPONENT}")));
    };
    Ok((if minus.is_some() { -value } else { value }, region))
}

/// Larger exponents have no use in mechanics and would only make large programs.
const MAX_EXPONENT: u32 = 64;

/// Documentation comments before `what`; any other attribute is a mistake, and what it stands on is read all the same.
pub fn docs(input: ParseStream<'_>, what: &str, report: &mut Report) -> syn::Result<Doc> {
    let start = input.span();
    let mut lines = Vec::new();
    while input.peek(Token![#]) {
        let pound: Token![#] = input.parse()?;
        let inner = input.parse::<Option<Token![!]>>()?.is_some();
        let content;
        let brackets = syn::bracketed!(content in input);
        let region = Region::from(pound.span).to(brackets.span.close().into());
        let text = match content.parse() {
            Ok(syn::Meta::NameValue(meta)) if meta.path.is_ident("doc") => match meta.value {
                syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) => Some(text.value()),
                _ => None,
            },
            _ => {
                content.parse::<TokenStream>()?;
                None
            }
        };
        match text {
            Some(text) if !inner => lines.push(text.strip_prefix(' ').unwrap_or(&text).trim_end().to_string()),
            Some(_) => {
                report.error(region, "documentation from inside (`//!`): expected `/// …` before what it is about")
            }
            None => {
                report.error(region, "an attribute that is not supported here: expected documentation (`/// …`)");
            }
        }
    }
    if !lines.is_empty() && input.is_empty() {
        return Err(error(start, format!("documentation of nothing: expected {what} after it")));
    }
    Ok(lines.join("\n").trim_matches('\n').to_string())
}

/// An optional text in quotes.
pub fn text(input: ParseStream<'_>) -> syn::Result<Option<String>> {
    Ok(if input.peek(syn::LitStr) { Some(input.parse::<syn::LitStr>()?.value()) } else { None })
}

/// Skips what is left of a statement that could not be read: through the next `;` or brace, or up to where the next
/// one `starts`, for its predecessor may only lack a `;`.
///
/// `moved` says whether the failed attempt took any token; if not, at least one is skipped.
pub fn skip_statement(input: ParseStream<'_>, mut moved: bool, starts: fn(ParseStream<'_>) -> bool) {
    while let Some((token, _)) = input.cursor().token_tree() {
        if moved && starts(input) {
            return;
        }
        moved = true;
        let semicolon = matches!(&token, TokenTree::Punct(punct) if punct.as_char() == ';');
        let brace = matches!(&token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
        if input.parse::<TokenTree>().is_err() || semicolon {
            return;
        }
        // `let a = if b { c } else { d };` and `let a = B { c }*d;` go on behind their braces.
        let mark = input.cursor().punct().is_some_and(|(punct, _)| punct.as_char() != '#');
        if brace && !mark && !input.peek(Token![else]) {
            return;
        }
    }
}
