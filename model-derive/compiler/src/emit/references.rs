//! Code that is never run, by which editors lead from a use of a name in the declaration to where it is declared.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::docs;
use super::names::GeneratedNames;
use crate::model::{Model, Named, Target};

/// What has a name as the fields of a struct for each kind, and every use of a name, at its span, as a read of a field:
/// fields alone cannot be taken for an item of the user's. All is private to an unnamed constant, and a place that nothing
/// is bound to costs the compiler next to nothing.
pub fn emit(model: &Model, names: &GeneratedNames) -> TokenStream {
    let allow = names.allow();
    let name = &names.model;
    let declaration = format_ident!("{name}Declaration");
    let kinds = KINDS.map(|(_, suffix)| format_ident!("{name}{suffix}"));
    let structs = KINDS.iter().zip(&kinds).map(|((target, _), kind)| {
        let named = model.references.named.iter().filter(|named| named.target == *target);
        let fields = named.map(|Named { name, docs: text, .. }| {
            let docs = docs(text);
            quote! { #docs #name: ::core::primitive::f64 }
        });
        quote! { struct #kind { #(#fields,)* } }
    });
    let uses = model.references.uses.iter().map(|(target, name)| {
        // Behind the model, whose fields are the parameters.
        let position = KINDS.iter().position(|(kind, _)| kind == target).map_or(0, |kind| kind + 1);
        let position = Literal::usize_unsuffixed(position);
        quote!(let _ = self.#position.#name;)
    });
    quote! {
        #allow
        const _: () = {
            #(#structs)*
            struct #declaration(#name<::core::primitive::f64>, #(#kinds),*);
            impl #declaration {
                fn uses(&self) { #(#uses)* }
            }
        };
    }
}

/// What is no field of the model itself.
const KINDS: [(Target, &str); 4] = [
    (Target::Definition, "Definitions"),
    (Target::Coordinate, "Coordinates"),
    (Target::Part, "Parts"),
    (Target::Unit, "Units"),
];
