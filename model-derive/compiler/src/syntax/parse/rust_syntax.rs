//! What of Rust has no meaning in a formula, with words for it.

use proc_macro2::TokenTree;
use syn::Token;
use syn::parse::ParseStream;

use super::tokens::operator_at;
use crate::report::error;

/// What to say where a value should be and none is.
pub fn describe_expected(input: ParseStream<'_>) -> &'static str {
    if input.peek(Token![.]) && input.peek2(syn::LitInt) {
        "a digit before the point of a number, as in `0.5`"
    } else if input.peek(Token![&]) {
        "a formula, without references"
    } else if input.peek(Token![|]) {
        "a formula, without closures"
    } else if input.peek(Token![!]) {
        "a formula, without logic"
    } else if input.peek(syn::token::Brace) {
        "a formula, grouped by parentheses"
    } else {
        "a formula"
    }
}

/// Words that more than an operator would follow; other words of Rust are names that the check refuses.
pub fn starts_rust_statement(word: &str) -> bool {
    const WORDS: [&str; 12] =
        ["if", "match", "while", "for", "loop", "unsafe", "async", "move", "return", "break", "continue", "let"];
    WORDS.contains(&word)
}

/// Rust that may follow a value, but has no meaning in a formula.
pub fn reject_rust_syntax(input: ParseStream<'_>) -> syn::Result<()> {
    let what = if input.peek(Token![..]) {
        "ranges are"
    } else if input.peek(Token![.]) {
        "method calls and fields are"
    } else if input.peek(Token![::]) {
        "paths are"
    } else if input.peek(Token![?]) {
        "`?` is"
    } else if input.peek(Token![!]) && !input.peek(Token![!=]) {
        "macros are"
    } else if input.peek(Token![as]) {
        "casts are"
    } else if input.peek(Token![%]) {
        "`%` is"
    } else if input.peek(syn::token::Bracket) {
        "indexing is"
    } else if input.peek(Token![&]) || input.peek(Token![|]) {
        "logic is"
    } else {
        return Ok(());
    };
    let region = match input.cursor().token_tree() {
        Some((TokenTree::Punct(_), _)) => operator_at(input.cursor()).1,
        Some((token, _)) => token.span().into(),
        None => input.span().into(),
    };
    let instead = if what.starts_with("paths") { "a name alone, such as `pi`" } else { "an operator (`+ - * / ^`)" };
    Err(error(region, format!("{what} not supported in formulas: expected {instead}")))
}
