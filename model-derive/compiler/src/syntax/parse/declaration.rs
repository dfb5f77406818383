//! A whole declaration: its documentation, its name, and the braces around its statements.

use proc_macro2::TokenStream;
use syn::ext::IdentExt;
use syn::parse::ParseStream;

use super::blocks::parse_statements;
use super::docs::{Supported, parse_rust_attributes};
use super::names::parse_name;
use super::statements::{parse_statement, starts_statement};
use super::tokens::expected;
use crate::report::Report;
use crate::syntax::tree::Declaration;

/// `/// docs  pub model Name { statements }`
pub fn parse_declaration(input: ParseStream<'_>, report: &mut Report) -> syn::Result<Declaration> {
    let (docs, rust_attributes) = parse_rust_attributes(input, MODEL, Supported::Rust, report)?;
    let visibility = parse_visibility(input)?;
    if !input.peek(syn::Ident::peek_any) || input.fork().call(syn::Ident::parse_any)? != "model" {
        return Err(expected(input, MODEL));
    }
    input.call(syn::Ident::parse_any)?;
    let name = parse_name(input, "the name of the model")?;
    if !input.peek(syn::token::Brace) {
        return Err(expected(input, "`{` and the statements of the model"));
    }
    let content;
    syn::braced!(content in input);
    let mut declaration = Declaration {
        docs,
        rust_attributes,
        visibility,
        name,
        source: None,
        parameters: Vec::new(),
        speed: None,
        definitions: Vec::new(),
        requirements: Vec::new(),
        assertions: Vec::new(),
        asserted: Vec::new(),
        sets: Vec::new(),
        coordinates: Vec::new(),
        matrices: Vec::new(),
        wholes: Vec::new(),
        mechanism: None,
        added: Vec::new(),
        feedback: Vec::new(),
        compared: Vec::new(),
        derivatives: None,
        nonlinear: None,
        unread: Vec::new(),
    };
    parse_statements(&content, report, starts_statement, |input, report| {
        parse_statement(input, &mut declaration, report)
    });
    if !input.is_empty() {
        report.push(expected(input, "nothing after the model: one `model!` declares one model"));
        input.parse::<TokenStream>()?;
    }
    Ok(declaration)
}

const MODEL: &str = "`model Name { … }`, with `pub` before it if it is public";

fn parse_visibility(input: ParseStream<'_>) -> syn::Result<TokenStream> {
    let visibility: syn::Visibility = input.parse()?;
    Ok(quote::quote!(#visibility))
}
