//! Documentation comments and attributes of Rust, where they belong and where they would be lost.

use proc_macro2::TokenStream;
use syn::Token;
use syn::parse::ParseStream;

use crate::report::{Region, Report, error};
use crate::syntax::tree::RustAttribute;

/// What is said of documentation on anything but the model, its parameters, coordinates and sets.
pub const LOST: &str = "documentation that would be lost: expected a comment (`// …`), since only the model, its \
                        parameters, coordinates and sets are documented";

/// The attributes that a part of a declaration may have, beside documentation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Supported {
    Nothing,
    /// `#[default]`
    Default,
    /// Whatever Rust knows, for an item that is generated.
    Rust,
}

/// Documentation comments before `what`; any other attribute is a mistake, and what it stands on is read all the same.
pub fn parse_docs(input: ParseStream<'_>, what: &str, report: &mut Report) -> syn::Result<String> {
    parse_rust_attributes(input, what, Supported::Nothing, report).map(|(docs, _)| docs)
}

/// Documentation comments before `what`, and the attributes between them. Those that are not supported are mistakes, and
/// what they stand on is read all the same.
pub fn parse_rust_attributes(
    input: ParseStream<'_>,
    what: &str,
    supported: Supported,
    report: &mut Report,
) -> syn::Result<(String, Vec<RustAttribute>)> {
    let start = input.span();
    let (mut lines, mut attributes) = (Vec::new(), Vec::new());
    while input.peek(Token![#]) {
        let pound: Token![#] = input.parse()?;
        let inner = input.parse::<Option<Token![!]>>()?.is_some();
        let content;
        let brackets = syn::bracketed!(content in input);
        let region = Region::from(pound.span).to(brackets.span.close().into());
        let meta = content.parse::<syn::Meta>().ok().filter(|_| content.is_empty());
        content.parse::<TokenStream>()?;
        match (meta.as_ref().and_then(documentation), meta) {
            (Some(text), _) if !inner => lines.push(text.strip_prefix(' ').unwrap_or(&text).trim_end().to_string()),
            (Some(_), _) => {
                report.error(region, "documentation from inside (`//!`): expected `/// …` before what it is about");
            }
            (None, Some(meta)) if !inner && supported.includes(&meta) => {
                attributes.push(RustAttribute { meta, region })
            }
            (None, _) => report.error(region, supported.expectation(inner)),
        }
    }
    if !lines.is_empty() && input.is_empty() {
        return Err(error(start, format!("documentation of nothing: expected {what} after it")));
    }
    Ok((lines.join("\n").trim_matches('\n').to_string(), attributes))
}

/// The text of a documentation comment.
fn documentation(meta: &syn::Meta) -> Option<String> {
    match meta {
        syn::Meta::NameValue(syn::MetaNameValue {
            path,
            value: syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }),
            ..
        }) if path.is_ident("doc") => Some(text.value()),
        _ => None,
    }
}

impl Supported {
    fn includes(self, meta: &syn::Meta) -> bool {
        match self {
            Self::Nothing => false,
            Self::Default => matches!(meta, syn::Meta::Path(path) if path.is_ident("default")),
            Self::Rust => true,
        }
    }

    /// What is said of an attribute that is not included.
    fn expectation(self, inner: bool) -> &'static str {
        match (self, inner) {
            (Self::Nothing, _) => "an attribute that is not supported here: expected documentation (`/// …`)",
            (Self::Default, _) => {
                "an attribute that is not supported here: expected documentation (`/// …`) or `#[default]`"
            }
            (Self::Rust, true) => "an attribute from inside (`#![…]`): expected `#[…]` before what it is about",
            (Self::Rust, false) => "an attribute that Rust does not know: expected one such as `#[derive(…)]`",
        }
    }
}

/// The first word behind attributes, of which nothing is read.
pub fn peek_behind_attributes(input: ParseStream<'_>) -> Option<syn::Ident> {
    let mut cursor = input.cursor();
    while let Some((_, behind)) = cursor.punct().filter(|(sign, _)| matches!(sign.as_char(), '#' | '!')) {
        cursor = match behind.group(proc_macro2::Delimiter::Bracket) {
            Some((_, _, behind)) => behind,
            None => behind,
        };
    }
    cursor.ident().map(|(word, _)| word)
}

/// Notes documentation before `what`, which has none.
pub fn reject_docs(input: ParseStream<'_>, what: &str, report: &mut Report) -> syn::Result<()> {
    let start = input.span();
    if !parse_docs(input, what, report)?.is_empty() {
        report.error(start, LOST);
    }
    Ok(())
}
