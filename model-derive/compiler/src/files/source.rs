//! One model source: a file that holds one call of `carvallo::model!`.

use std::fmt::Write as _;
use std::hash::Hasher as _;
use std::path::Path;

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};

use super::layout;
use crate::emit::{self, Driver};

/// What a source is compiled to.
pub struct Generated {
    /// The name of the model.
    pub model: String,
    /// The text of a Rust file.
    pub text: String,
}

/// Compiles the source in `path`.
///
/// # Errors
/// Every mistake, as `path:line:column: error: …` with the line and a mark below it.
pub fn compile(path: &Path, shown: &str) -> Result<Generated, String> {
    let text = std::fs::read_to_string(path).map_err(|error| format!("error: {shown}: {error}"))?;
    let tokens = declaration(&text).map_err(|error| render(&error, shown, &text))?;
    let compiled = crate::compile(tokens).map_err(|error| render(&error, shown, &text))?;
    let rust = layout::lay_out(&emit::emit_sections(&compiled, &Driver::File));
    let rust = rust.map_err(|error| format!("error: {shown}: the generated code is wrong: {error}"))?;
    Ok(Generated { model: compiled.model.name.to_string(), text: format!("{}\n{rust}", header(shown, &text)) })
}

fn header(shown: &str, text: &str) -> String {
    format!(
        "// @generated from {shown} by carvallo-compiler {}; do not edit.\n\
         // To write it anew: cargo regenerate\n\
         // Hash of the source: {:016x}\n",
        env!("CARGO_PKG_VERSION"),
        hash(text),
    )
}

/// The same on every machine and in every checkout.
fn hash(text: &str) -> u64 {
    let mut hasher = fnv::FnvHasher::default();
    hasher.write(text.replace("\r\n", "\n").as_bytes());
    hasher.finish()
}

/// What stands between the braces of `carvallo::model! { … }`.
fn declaration(text: &str) -> syn::Result<TokenStream> {
    let tokens = text.parse::<TokenStream>().map_err(|error| unreadable(error.span(), text))?;
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let start: String = tokens.iter().take(5).map(ToString::to_string).collect();
    match &tokens[..] {
        [.., TokenTree::Group(group)]
            if tokens.len() == 6 && group.delimiter() == Delimiter::Brace && start == "carvallo::model!" =>
        {
            Ok(group.stream())
        }
        _ => {
            let span = tokens.first().map_or_else(Span::call_site, TokenTree::span);
            Err(syn::Error::new(span, "expected one `carvallo::model! { … }` and nothing else"))
        }
    }
}

/// What is wrong at a place where a text cannot be split into tokens.
fn unreadable(span: Span, text: &str) -> syn::Error {
    let line = text.lines().nth(span.start().line.saturating_sub(1)).unwrap_or_default();
    let mut rest = line.chars().skip(span.start().column);
    let message = match (rest.next(), rest.next()) {
        (Some(open @ ('(' | '[' | '{')), _) => format!("`{open}` is never closed: expected its other half"),
        (Some(close @ (')' | ']' | '}')), _) => {
            format!("`{close}` closes nothing: expected the other half of what is open")
        }
        (Some('"'), _) => "a text without an end: expected `\"`".into(),
        (Some('/'), Some('*')) => "a comment without an end: expected `*/`".into(),
        (found, _) => {
            format!("found `{}`: expected names, numbers, texts and signs of Rust", found.unwrap_or_default())
        }
    };
    syn::Error::new(span, message)
}

fn render(error: &syn::Error, shown: &str, text: &str) -> String {
    let mut out = String::new();
    for error in error.clone() {
        let (start, end) = (error.span().start(), error.span().end());
        let line = text.lines().nth(start.line.saturating_sub(1)).unwrap_or_default();
        let length = if end.line == start.line { end.column.saturating_sub(start.column).max(1) } else { 1 };
        let (pad, mark) = (" ".repeat(start.column), "^".repeat(length));
        let _ =
            write!(out, "{shown}:{}:{}: error: {error}\n  | {line}\n  | {pad}{mark}\n", start.line, start.column + 1);
    }
    out
}
