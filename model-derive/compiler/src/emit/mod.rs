//! A checked model and its programs to Rust.

mod body;
mod by_attributes;
#[cfg(feature = "files")]
pub mod c;
mod compared;
mod conversions;
mod derivatives;
mod described;
mod documentation;
mod each_result;
mod evaluator;
mod fields;
mod info;
mod inputs;
mod kinematics;
mod lanes;
mod linearization;
mod motion;
mod names;
mod nesting;
mod outline;
mod references;
mod statements;
mod states;
mod structure;
mod trait_impl;
mod with_respect_to;

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use self::names::GeneratedNames;
#[cfg(feature = "files")]
pub use self::names::allowed;
pub use self::names::{DERIVATIVES, MATRICES, MOTION, find_defined_names};
use crate::model::Model;
use crate::pipeline::{Compiled, Programs};

/// The Rust of a model: one struct of its parameters, one of its matrices, one of the rates that follow from a
/// mechanism, and what they can do.
pub fn emit(compiled: &Compiled, driver: &Driver) -> TokenStream {
    emit_sections(compiled, driver).into_iter().map(|section| section.items).collect()
}

/// The same, for readers in parts: what the model computes first, and then what makes a library of it.
pub fn emit_sections(Compiled { model, programs }: &Compiled, driver: &Driver) -> Vec<Section> {
    emit_sections_with(model, Some(programs), driver)
}

/// Items that belong together.
pub struct Section {
    /// What they are, for a reader of a file.
    #[cfg_attr(not(feature = "files"), allow(dead_code))]
    pub title: &'static str,
    pub items: TokenStream,
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
    let sections = if model.parameters.is_empty() { Vec::new() } else { emit_sections_with(&model, None, driver) };
    sections.into_iter().map(|section| section.items).collect()
}

fn emit_sections_with(model: &Model, programs: Option<&Programs>, driver: &Driver) -> Vec<Section> {
    let computed = programs.and_then(|programs| programs.derivatives.as_ref());
    let names = GeneratedNames::new(model, computed, driver);
    // Without coordinates, which is a mistake, there is no size of the matrices.
    let sized = !model.coordinates.is_empty();
    let matrices = programs.map(|programs| &programs.matrices);
    let rates = programs.and_then(|programs| programs.kinematics.as_ref());
    let [evaluator, matrix_arrays, trait_impl, described, lanes] = [
        sized.then(|| evaluator::emit(model, &names, matrices)),
        sized.then(|| evaluator::emit_conversions(model, &names, matrices)),
        sized.then(|| trait_impl::emit(model, &names, programs)),
        sized.then(|| described::emit(model, &names)),
        sized.then(|| lanes::emit(model, &names, matrices)),
    ];
    let kinematics = if sized { kinematics::emit(model, &names, rates) } else { None };
    let motion = if sized { motion::emit(model, &names, programs) } else { None };
    let [derivatives, partials] =
        if sized { derivatives::emit(model, &names, computed, matrices) } else { [None, None] };
    let (structure, sets) = structure::emit(model, &names);
    let arrays = conversions::emit(model, &names);
    let compared = programs.and_then(|_| compared::emit(model));
    let references = names.among_items.then(|| references::emit(model, &names));
    let sections = [
        ("The parameters", Some(structure)),
        ("The coefficient matrices", evaluator),
        ("Rates and forces of the mechanism", kinematics),
        ("The nonlinear equations of motion", motion),
        ("The derivatives of the matrices", derivatives),
        ("Parameter sets", sets),
        ("Parameters and matrices as arrays", Some(quote!(#arrays #matrix_arrays))),
        ("What the runtime knows of the model", Some(quote!(#trait_impl #described #lanes))),
        ("Which derivatives there are", partials),
        ("Tests beside functions by hand", compared),
        ("What editors know of the declaration", references),
    ];
    sections.into_iter().filter_map(|(title, items)| Some(Section { title, items: items? })).collect()
}

/// What every struct of numbers derives.
fn derive() -> TokenStream {
    quote! {
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
    }
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
