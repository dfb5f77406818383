//! A checked model and its programs to Rust.

mod evaluator;
mod info;
mod structure;
mod trait_impl;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::model::Model;
use crate::program::Program;

/// The Rust of a model: one struct of its parameters, one of its matrices, and what they can do.
pub fn emit(model: &Model, matrices: &Program, requirements: &Program) -> TokenStream {
    let names = Names::new(model);
    let structure = structure::emit(model, &names);
    let evaluator = evaluator::emit(model, &names, matrices);
    let trait_impl = trait_impl::emit(model, &names, requirements);
    quote! { #structure #evaluator #trait_impl }
}

/// The names that the parts share.
struct Names {
    model: Ident,
    matrices: Ident,
    /// The type parameter; another letter for a model that is called `T` itself.
    scalar: Ident,
}

impl Names {
    fn new(model: &Model) -> Self {
        let name = model.name.clone();
        Self {
            matrices: format_ident!("{name}Matrices", span = name.span()),
            scalar: if name == "T" { format_ident!("S") } else { format_ident!("T") },
            model: name,
        }
    }
}

/// What generated items are allowed: names as in the formulas, and parts that a crate does not use.
fn allow() -> TokenStream {
    quote! { #[allow(clippy::all, dead_code, non_snake_case)] }
}

/// A finite number as Rust writes it; negative ones need a sign before the literal.
fn number(value: f64) -> TokenStream {
    let literal = Literal::f64_unsuffixed(value.abs());
    if value.is_sign_negative() && value != 0.0 { quote!(-#literal) } else { quote!(#literal) }
}

/// Doc attributes, one for each line.
fn docs(text: &str) -> TokenStream {
    let lines = text.lines().map(|line| if line.is_empty() { String::new() } else { format!(" {line}") });
    quote! { #(#[doc = #lines])* }
}

/// The first of two texts that is not empty.
fn or<'a>(text: &'a str, default: &'a str) -> &'a str {
    if text.is_empty() { default } else { text }
}
