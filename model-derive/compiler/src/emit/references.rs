//! Code that is never run, by which editors lead from a use of a name in the declaration to where it is declared.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::docs;
use super::documentation::parameter_docs;
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
    let completions = (!model.references.unknown.is_empty()).then(|| emit_completions(model, names));
    quote! {
        #allow
        const _: () = {
            #completions
            #(#structs)*
            struct #declaration(#name<::core::primitive::f64>, #(#kinds),*);
            impl #declaration {
                fn uses(&self) { #(#uses)* }
            }
        };
    }
}

/// Names that are just being written, as reads of fields of what they may become: rust-analyzer offers those. Rustc, which
/// would have a second message of each, does not see them.
fn emit_completions(model: &Model, names: &GeneratedNames) -> TokenStream {
    let name = &names.model;
    let [offered, uses] = ["Offered", "Unknown"].map(|suffix| format_ident!("{name}{suffix}"));
    let targets = [Target::Parameter].into_iter().chain(KINDS.map(|(target, _)| target));
    let structs = targets.map(|target| {
        let kind = format_ident!("{offered}{target:?}");
        // Formulas may name both.
        let parameters = matches!(target, Target::Parameter | Target::Definition).then_some(&model.parameters);
        let parameters = parameters.into_iter().flatten().map(|parameter| {
            let (docs, name) = (docs(&parameter_docs(parameter)), &parameter.name);
            quote! { #docs #name: ::core::primitive::f64 }
        });
        let named = model.references.named.iter().filter(|named| named.target == target);
        let named = named.map(|Named { name, docs: text, .. }| {
            let docs = docs(text);
            quote! { #docs #name: ::core::primitive::f64 }
        });
        let fields = parameters.chain(named);
        quote! { struct #kind { #(#fields,)* } }
    });
    let reads = model.references.unknown.iter().map(|(target, unknown)| {
        let kind = format_ident!("{offered}{target:?}");
        quote!(fn #uses(offered: #kind) { let _ = offered.#unknown; })
    });
    quote! {
        #[allow(unexpected_cfgs)]
        const _: () = {
            #[cfg(rust_analyzer)]
            const _: () = {
                #(#structs)*
                #(const _: () = { #reads };)*
            };
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
