//! Documentation comments, where they belong and where they would be lost.

use proc_macro2::TokenStream;
use syn::Token;
use syn::parse::ParseStream;

use crate::report::{Region, Report, error};

/// What is said of documentation on anything but the model, its parameters, coordinates and sets.
pub const LOST: &str = "documentation that would be lost: expected a comment (`// …`), since only the model, its \
                        parameters, coordinates and sets are documented";

/// Documentation comments before `what`; any other attribute is a mistake, and what it stands on is read all the same.
pub fn parse_docs(input: ParseStream<'_>, what: &str, report: &mut Report) -> syn::Result<String> {
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

/// Notes documentation before `what`, which has none.
pub fn reject_docs(input: ParseStream<'_>, what: &str, report: &mut Report) -> syn::Result<()> {
    let start = input.span();
    if !parse_docs(input, what, report)?.is_empty() {
        report.error(start, LOST);
    }
    Ok(())
}
