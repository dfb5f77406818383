//! A checked model and its programs to Rust.

mod derivatives;
mod evaluator;
mod info;
mod kinematics;
mod lanes;
mod names;
mod outline;
mod references;
mod structure;
mod trait_impl;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use self::names::Names;
use crate::model::Model;
use crate::{Compiled, Programs};

/// The Rust of a model: one struct of its parameters, one of its matrices, one of the rates that follow from a
/// mechanism, and what they can do.
pub fn emit(Compiled { model, programs }: &Compiled, driver: &Driver) -> TokenStream {
    emit_with(model, Some(programs), driver)
}

/// For whom the code is written.
#[derive(Clone, Debug)]
pub enum Driver {
    /// The macro: the code lands among a user's items, one of which could have the name of a definition and be a
    /// constant, which a `let` cannot shadow. So local variables are only numbered.
    Macro {
        /// How the user's crate gets at the runtime, such as `$crate`.
        runtime: TokenStream,
    },
    /// A file of its own, for people to read: local variables that are definitions have their names.
    File,
}

/// What can be had of a model with mistakes, so that the rest of a file still has its types: all but the programs.
pub fn outline(model: Model, driver: &Driver) -> TokenStream {
    let model = outline::sound(model);
    // Nothing could be generic in the type of the parameters.
    if model.parameters.is_empty() { TokenStream::new() } else { emit_with(&model, None, driver) }
}

fn emit_with(model: &Model, programs: Option<&Programs>, driver: &Driver) -> TokenStream {
    let derivatives = programs.and_then(|programs| programs.derivatives.as_ref());
    let names = Names::new(model, derivatives, driver);
    let structure = structure::emit(model, &names);
    // Without coordinates, which is a mistake, there is no size of the matrices.
    let sized = !model.coordinates.is_empty();
    let matrices = programs.map(|programs| &programs.matrices);
    let evaluator = sized.then(|| evaluator::emit(model, &names, matrices));
    let kinematics = programs.and_then(|programs| programs.kinematics.as_ref());
    let kinematics = if sized { kinematics::emit(model, &names, kinematics) } else { None };
    let requirements = programs.map(|programs| &programs.requirements);
    let trait_impl = sized.then(|| trait_impl::emit(model, &names, matrices, requirements));
    let lanes = sized.then(|| lanes::emit(model, &names, matrices));
    let derivatives = if sized { derivatives::emit(model, &names, derivatives) } else { None };
    let references = names.among_items.then(|| references::emit(model, &names));
    quote! { #structure #evaluator #kinematics #trait_impl #lanes #derivatives #references }
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
