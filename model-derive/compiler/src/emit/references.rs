//! Code that is never run, by which editors lead from a use of a name in the declaration to where it is declared.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::docs;
use super::names::GeneratedNames;
use crate::model::{Model, Target};

/// Definitions as the fields of a struct, and every use of a name, at its span, as a read of a field: fields alone
/// cannot be taken for an item of the user's. All is private to an unnamed constant, and a place that nothing is
/// bound to costs the compiler next to nothing.
pub fn emit(model: &Model, names: &GeneratedNames) -> TokenStream {
    let allow = names.allow();
    let name = &names.model;
    let [all, declaration] = ["Definitions", "Declaration"].map(|suffix| format_ident!("{name}{suffix}"));
    let definitions = model.references.definitions.iter().map(|(name, formula)| {
        let docs = docs(&format!("`{name}` = {formula}."));
        quote! { #docs #name: ::core::primitive::f64 }
    });
    let uses = model.references.uses.iter().map(|(target, name)| match target {
        Target::Parameter => quote!(let _ = self.0.#name;),
        Target::Definition => quote!(let _ = self.1.#name;),
    });
    quote! {
        #allow
        const _: () = {
            struct #all { #(#definitions,)* }
            struct #declaration(#name<::core::primitive::f64>, #all);
            impl #declaration {
                fn uses(&self) { #(#uses)* }
            }
        };
    }
}
