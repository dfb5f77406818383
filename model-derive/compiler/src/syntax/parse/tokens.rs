//! Small parsers that several statements share.

use proc_macro2::{Delimiter, Ident, Literal, Spacing, TokenTree};
use syn::Token;
use syn::buffer::Cursor;
use syn::parse::ParseStream;

use crate::formula::Decimal;
use crate::report::{Region, error};

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
            let (operator, region) = operator_at(input.cursor());
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
pub fn operator_at(mut cursor: Cursor<'_>) -> (String, Region) {
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

/// The `;` that ends a statement; `what` says what could stand in its place.
pub fn parse_semicolon(input: ParseStream<'_>, what: &str, after: &str) -> syn::Result<()> {
    if input.peek(Token![;]) {
        input.parse::<Token![;]>()?;
        return Ok(());
    }
    Err(expected(input, &format!("{what} after {after}")))
}

/// A `:`, which is not half of `::`; `what` says what it stands before.
pub fn parse_colon(input: ParseStream<'_>, what: &str) -> syn::Result<()> {
    if input.peek(Token![:]) && !input.peek(Token![::]) {
        input.parse::<Token![:]>()?;
        return Ok(());
    }
    Err(expected(input, what))
}

/// An `=`, which is not half of `==`; `what` says what it stands before.
pub fn parse_equals(input: ParseStream<'_>, what: &str) -> syn::Result<()> {
    if input.peek(Token![=]) && !input.peek(Token![==]) {
        input.parse::<Token![=]>()?;
        return Ok(());
    }
    Err(expected(input, what))
}

/// A word such as `to` between two names; `what` says what it stands before.
pub fn parse_word(input: ParseStream<'_>, word: &str, what: &str) -> syn::Result<()> {
    if input.cursor().ident().is_some_and(|(found, _)| found == word) {
        input.parse::<Ident>()?;
        return Ok(());
    }
    Err(expected(input, what))
}

/// An integer with an optional sign, as in an exponent, and where it stands.
pub fn parse_signed_integer(input: ParseStream<'_>) -> syn::Result<(i32, Region)> {
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
        // A power of ten below one is a fraction.
        let root = if number.exponent < 0 { "; a root is written `sqrt(x)`" } else { "" };
        return Err(error(region, format!("found `{literal}`: expected {what}, at most {MAX_EXPONENT}{root}")));
    };
    Ok((if minus.is_some() { -value } else { value }, region))
}

/// Larger exponents have no use in mechanics and would only make large programs.
const MAX_EXPONENT: u32 = 64;

/// An optional text in quotes.
pub fn parse_text(input: ParseStream<'_>) -> syn::Result<Option<String>> {
    Ok(if input.peek(syn::LitStr) { Some(input.parse::<syn::LitStr>()?.value()) } else { None })
}

/// A list in brackets, with where it stands.
pub fn parse_list<T>(
    input: ParseStream<'_>,
    what: &str,
    item: impl Fn(ParseStream<'_>) -> syn::Result<T>,
) -> syn::Result<(Region, Vec<T>)> {
    if !input.peek(syn::token::Bracket) {
        return Err(expected(input, what));
    }
    let content;
    let brackets = syn::bracketed!(content in input);
    let items = parse_items(&content, "`,` or `]`", item)?;
    Ok((Region::from(brackets.span.open()).to(brackets.span.close().into()), items))
}

/// Items with commas between them, and perhaps behind them, to the end; `what` says what could stand behind an item.
pub fn parse_items<T>(
    input: ParseStream<'_>,
    what: &str,
    item: impl Fn(ParseStream<'_>) -> syn::Result<T>,
) -> syn::Result<Vec<T>> {
    let mut items = Vec::new();
    while !input.is_empty() {
        items.push(item(input)?);
        if !input.is_empty() && input.parse::<Option<Token![,]>>()?.is_none() {
            return Err(expected(input, what));
        }
    }
    Ok(items)
}
