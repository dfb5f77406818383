//! Functions by hand that are compared with the generated code.

use proc_macro2::Ident;
use quote::ToTokens;
use syn::Token;
use syn::ext::IdentExt;
use syn::parse::ParseStream;

use super::tokens::{expected, parse_semicolon};
use crate::report::Report;
use crate::syntax::tree::{Compared, Declaration};

/// `compare by_hand;` or `compare hand::matrices: f64;`, behind its first word.
pub fn parse_compared(input: ParseStream<'_>, model: &mut Declaration, report: &mut Report) -> syn::Result<()> {
    const WHAT: &str = "a function by hand that gives the matrices, such as `by_hand` or `crate::hand::matrices`";
    if !input.peek(Ident::peek_any) && !input.peek(Token![::]) {
        return Err(expected(input, WHAT));
    }
    let path = input.call(syn::Path::parse_mod_style)?;
    let Some(name) = path.segments.last().map(|segment| segment.ident.clone()) else {
        return Err(expected(input, WHAT));
    };
    let function = path.into_token_stream();
    let only_double = input.parse::<Option<Token![:]>>()?.is_some();
    if only_double {
        match input.call(Ident::parse_any) {
            Ok(scalar) if scalar == "f64" => {}
            Ok(scalar) => report.error(
                &scalar,
                format!("found `{scalar}`: expected `f64`, or no number type for a function of any `Number`"),
            ),
            Err(_) => return Err(expected(input, "`f64`")),
        }
    }
    if model.compared.iter().any(|other| other.function.to_string() == function.to_string()) {
        report.error(&name, format!("a second `compare` with `{name}`: expected one of each function"));
        return parse_semicolon(input, "`;`", "the function");
    }
    model.compared.push(Compared { function, name, only_double });
    parse_semicolon(input, if only_double { "`;`" } else { "`;` or `: f64`" }, "the function")
}
