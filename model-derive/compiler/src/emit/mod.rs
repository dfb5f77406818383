//! A checked model and its programs to Rust.

mod evaluator;
mod info;
mod structure;
mod trait_impl;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::model::Model;
use crate::program::{Program, Value};

/// The Rust of a model: one struct of its parameters, one of its matrices, and what they can do.
pub fn emit(model: &Model, matrices: &Program, requirements: &Program, driver: Driver) -> TokenStream {
    let names = Names::new(model, driver);
    let structure = structure::emit(model, &names);
    let evaluator = evaluator::emit(model, &names, matrices);
    let trait_impl = trait_impl::emit(model, &names, requirements);
    quote! { #structure #evaluator #trait_impl }
}

/// For whom the code is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Driver {
    /// The macro: the code lands among a user's items, one of which could have the name of a definition and be a
    /// constant, which a `let` cannot shadow. So local variables are only numbered.
    Macro,
    /// A file of its own, for people to read: local variables that are definitions have their names.
    File,
}

/// The names that the parts share.
struct Names {
    driver: Driver,
    model: Ident,
    matrices: Ident,
    /// The type parameter; another letter for a model that is called `T` itself.
    scalar: Ident,
}

impl Names {
    fn new(model: &Model, driver: Driver) -> Self {
        let name = model.name.clone();
        Self {
            driver,
            matrices: format_ident!("{name}Matrices", span = name.span()),
            scalar: if name == "T" { format_ident!("S") } else { format_ident!("T") },
            model: name,
        }
    }

    /// The local variable that holds a value.
    fn local(&self, program: &Program, model: &Model, value: Value) -> Ident {
        let taken = |name: &str| model.definitions.iter().any(|(definition, _)| definition == name);
        let label = program.labels.iter().find(|(labelled, _)| *labelled == value);
        match (self.driver, label) {
            (Driver::File, Some((_, definition))) => model.definitions[*definition].0.clone(),
            (Driver::File, None) if taken(&format!("t{value}")) => format_ident!("t{value}_"),
            _ => format_ident!("t{value}"),
        }
    }
}

/// What generated items are allowed: names as in the formulas, and parts that a crate does not use.
fn allow() -> TokenStream {
    quote! { #[allow(clippy::all, dead_code, non_camel_case_types, non_snake_case)] }
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
