//! One model source: a file that holds one call of `carvallo::model!`.

use std::fmt::Write as _;
use std::hash::Hasher as _;
use std::path::PathBuf;

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};
use quote::quote;

use super::layout;
use crate::emit::{self, Driver};

/// A file with a declaration.
pub struct Source {
    pub path: PathBuf,
    /// Its path in messages.
    pub shown: String,
}

/// What a source is compiled to.
pub struct Generated {
    /// The name of the file, without its extension.
    pub module: String,
    /// The name of the model.
    pub model: String,
    /// The text of a Rust file.
    pub text: String,
}

/// Compiles sources, which `command` does as well, and gives each model an attribute beside those in its source.
///
/// # Errors
/// Every mistake of all of them, as `path:line:column: error: …` with the line and a mark below it.
pub fn compile_all(
    sources: &[Source],
    command: &str,
    attribute: Option<&TokenStream>,
) -> Result<Vec<Generated>, String> {
    let mut generated = Vec::new();
    let mut errors = Vec::new();
    for source in sources {
        match source.compile(command, attribute) {
            Ok(compiled) => generated.push(compiled),
            Err(error) => errors.push(error),
        }
    }
    if errors.is_empty() { Ok(generated) } else { Err(errors.join("\n")) }
}

impl Source {
    fn compile(&self, command: &str, attribute: Option<&TokenStream>) -> Result<Generated, String> {
        let Self { path, shown } = self;
        let module = self.module()?;
        let text = std::fs::read_to_string(path).map_err(|error| format!("error: {shown}: {error}"))?;
        let tokens = declaration(&text).map_err(|error| render(&error, shown, &text))?;
        let mut compiled = crate::compile(tokens).map_err(|error| render(&error, shown, &text))?;
        if compiled.model.visibility.is_empty() {
            // What is private where it is declared is for the module around its file.
            compiled.model.visibility = quote!(pub(super));
        }
        compiled.model.rust_attributes.extend(attribute.cloned());
        let rust = layout::lay_out(&emit::emit_sections(&compiled, &Driver::File));
        let rust = rust.map_err(|error| format!("error: {shown}: the generated code is wrong: {error}"))?;
        let text = format!("{}\n{rust}", header(shown, &text, command));
        Ok(Generated { module, model: compiled.model.name.to_string(), text })
    }

    /// The module that the file becomes.
    fn module(&self) -> Result<String, String> {
        let name = self.path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if name == "mod" || syn::parse_str::<Ident>(&name).is_err() {
            let shown = &self.shown;
            return Err(format!("error: {shown}: expected a file named like a module, such as `my_bicycle.rs`"));
        }
        Ok(name)
    }
}

fn header(shown: &str, text: &str, command: &str) -> String {
    format!(
        "// @generated from {shown} by carvallo-compiler {}; do not edit.\n\
         // To write it anew: {command}\n\
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
