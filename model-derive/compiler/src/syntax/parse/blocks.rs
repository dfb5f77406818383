//! Statements one after the other, and how to go on behind one that cannot be read.

use proc_macro2::{Delimiter, Group, TokenTree};
use syn::Token;
use syn::parse::{ParseStream, Parser};

use super::tokens::expected;
use crate::report::Report;

/// Reads statements to the end; one that cannot be read is reported and skipped, up to where the next one `starts`.
pub fn parse_statements(
    input: ParseStream<'_>,
    report: &mut Report,
    starts: fn(ParseStream<'_>) -> bool,
    mut read: impl FnMut(ParseStream<'_>, &mut Report) -> syn::Result<()>,
) {
    while !input.is_empty() {
        let before = input.cursor();
        if let Err(error) = read(input, report) {
            report.push(error);
            skip_statement(input, input.cursor() != before, starts);
        }
    }
}

/// `{ statements }`, where `what` they are.
pub fn parse_block(
    input: ParseStream<'_>,
    what: &str,
    report: &mut Report,
    starts: fn(ParseStream<'_>) -> bool,
    mut read: impl FnMut(ParseStream<'_>, &mut Report) -> syn::Result<()>,
) -> syn::Result<()> {
    let expectation = format!("`{{` and {what}");
    // `parameters = { … }` and `parameters [ … ]` are read all the same, so that the names inside are known.
    if (input.peek(Token![=]) || input.peek(Token![:])) && input.peek2(syn::token::Brace) {
        report.push(expected(input, &expectation));
        input.parse::<TokenTree>()?;
    }
    if !input.peek(syn::token::Brace) {
        let error = expected(input, &expectation);
        let Ok(group) = input.parse::<Group>() else { return Err(error) };
        report.push(error);
        return (|content: ParseStream<'_>| {
            parse_statements(content, report, starts, &mut read);
            Ok(())
        })
        .parse2(group.stream());
    }
    let content;
    syn::braced!(content in input);
    parse_statements(&content, report, starts, read);
    Ok(())
}

/// Skips what is left of a statement that could not be read: through the next `;` or brace, or up to where the next
/// one `starts`, for its predecessor may only lack a `;`.
///
/// `moved` says whether the failed attempt took any token; if not, at least one is skipped.
fn skip_statement(input: ParseStream<'_>, mut moved: bool, starts: fn(ParseStream<'_>) -> bool) {
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
