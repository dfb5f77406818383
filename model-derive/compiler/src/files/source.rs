//! One model source: a file that holds one call of `carvallo::model!`.

use std::fmt::Write as _;
use std::hash::Hasher as _;
use std::path::PathBuf;

use proc_macro2::{Delimiter, Ident, Span, TokenStream, TokenTree};
use quote::quote;

use super::layout;
use crate::emit::{self, Driver, c};
use crate::pipeline::Compiled;

/// A file with a declaration.
pub struct Source {
    pub path: PathBuf,
    /// Its path in messages.
    pub shown: String,
}

/// A source that is compiled, and not yet written in a language.
pub struct CompiledSource {
    /// The name of the file, without its extension.
    pub module: String,
    compiled: Compiled,
    /// What every file says that is made of it.
    header: [String; 3],
    shown: String,
}

/// Compiles sources, which `command` does as well.
///
/// # Errors
/// Every mistake of all of them, as `path:line:column: error: …` with the line and a mark below it.
pub fn compile_all(sources: &[Source], command: &str) -> Result<Vec<CompiledSource>, String> {
    let mut all = Vec::new();
    let mut errors = Vec::new();
    for source in sources {
        match source.compile(command) {
            Ok(compiled) => all.push(compiled),
            Err(error) => errors.push(error),
        }
    }
    if errors.is_empty() { Ok(all) } else { Err(errors.join("\n")) }
}

impl CompiledSource {
    /// The name of the model.
    pub fn model(&self) -> String {
        self.compiled.model.name.to_string()
    }

    /// The text of a Rust file, in which the model has an attribute beside those of its source.
    ///
    /// # Errors
    /// If it is no Rust.
    pub fn write_rust(&mut self, attribute: Option<&TokenStream>) -> Result<String, String> {
        let Self { compiled, header, shown, .. } = self;
        if compiled.model.visibility.is_empty() {
            // What is private where it is declared is for the module around its file.
            compiled.model.visibility = quote!(pub(super));
        }
        compiled.model.rust_attributes.extend(attribute.cloned());
        let rust = layout::lay_out(&emit::emit_sections(compiled, &Driver::File));
        let rust = rust.map_err(|error| format!("error: {shown}: the generated code is wrong: {error}"))?;
        let header: String = header.iter().map(|line| format!("// {line}\n")).collect();
        Ok(format!("{header}\n{rust}"))
    }

    /// The names and texts of two files of C.
    pub fn write_c(&self) -> [(String, String); 2] {
        let header = self.header.join("\n * ");
        c::emit(&self.compiled, &self.module).map(|file| (file.name, format!("/* {header}\n */\n\n{}", file.text)))
    }
}

impl Source {
    fn compile(&self, command: &str) -> Result<CompiledSource, String> {
        let Self { path, shown } = self;
        let module = self.module()?;
        let text = std::fs::read_to_string(path).map_err(|error| format!("error: {shown}: {error}"))?;
        let tokens = declaration(&text).map_err(|error| render(&error, shown, &text))?;
        let compiled = crate::compile(tokens).map_err(|error| render(&error, shown, &text))?;
        Ok(CompiledSource { module, compiled, header: header(shown, &text, command), shown: shown.clone() })
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

fn header(shown: &str, text: &str, command: &str) -> [String; 3] {
    [
        format!("@generated from {shown} by carvallo-compiler {}; do not edit.", env!("CARGO_PKG_VERSION")),
        format!("To write it anew: {command}"),
        format!("Hash of the source: {:016x}", hash(text)),
    ]
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
