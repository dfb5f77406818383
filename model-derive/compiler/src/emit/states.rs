//! Which positions and rates are states.

use proc_macro2::TokenStream;
use quote::quote;

use super::names::GeneratedNames;
use crate::model::Model;
use crate::states::States;

/// What is a state of one coordinate.
pub fn emit(states: States, names: &GeneratedNames) -> TokenStream {
    let runtime = &names.runtime;
    match states {
        States::Both => quote!(#runtime::States::Both),
        States::Position => quote!(#runtime::States::Position),
        States::Rate => quote!(#runtime::States::Rate),
    }
}

/// Coefficients of which positions and rates of all coordinates are states, as those of the model.
pub fn complete(coefficients: TokenStream, model: &Model, names: &GeneratedNames) -> TokenStream {
    let all: Vec<States> = model.coordinates.iter().map(|coordinate| coordinate.states).collect();
    if all.iter().all(|states| *states == States::Both) {
        return coefficients;
    }
    let runtime = &names.runtime;
    let states = all.into_iter().map(|states| emit(states, names));
    quote!(#runtime::Coefficients { states: [#(#states),*], ..#coefficients })
}
