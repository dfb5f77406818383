//! The struct of the parameters, and its parameter sets.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::documentation::{model_docs, parameter_docs, set_docs};
use super::names::GeneratedNames;
use super::{derive, docs, number};
use crate::model::{Model, ParameterSet};

/// The struct, and its parameter sets if there are any.
pub fn emit(model: &Model, names: &GeneratedNames) -> (TokenStream, Option<TokenStream>) {
    let sets = (!model.sets.is_empty()).then(|| emit_sets(model, names));
    (emit_struct(model, names), sets)
}

fn emit_struct(model: &Model, names: &GeneratedNames) -> TokenStream {
    let GeneratedNames { model: name, scalar, .. } = names;
    let Model { visibility, rust_attributes, parameters, .. } = model;
    let (allow, derive) = (names.allow(), derive());
    let struct_docs = docs(&model_docs(model));
    let of_fields = parameters.iter().map(|parameter| &parameter.rust_attributes);
    let field_docs = parameters.iter().map(|parameter| docs(&parameter_docs(parameter)));
    let fields = fields(model);
    quote! {
        #struct_docs
        #allow
        #derive
        #(#[#rust_attributes])*
        #visibility struct #name<#scalar = ::core::primitive::f64> {
            #(#field_docs #(#[#of_fields])* pub #fields: #scalar,)*
        }
    }
}

/// The fields of the struct.
pub fn fields(model: &Model) -> Vec<&Ident> {
    model.parameters.iter().map(|parameter| &parameter.name).collect()
}

fn emit_sets(model: &Model, names: &GeneratedNames) -> TokenStream {
    let (name, allow, fields) = (&names.model, names.allow(), fields(model));
    let constants = model.sets.iter().map(|set| {
        let constant = constant(set);
        let text = docs(&set_docs(set, model));
        let values = set.values.iter().map(|value| number(*value));
        quote! { #text pub const #constant: Self = Self { #(#fields: #values,)* }; }
    });
    let default = model.sets.iter().find(|set| set.is_default).map(|set| emit_default(set, names));
    quote! {
        #allow
        impl #name<::core::primitive::f64> { #(#constants)* }
        #default
    }
}

/// For `f64` it is also an inherent function: `Name::default()` has one meaning then.
fn emit_default(set: &ParameterSet, names: &GeneratedNames) -> TokenStream {
    let GeneratedNames { runtime, model: name, scalar, .. } = names;
    let (allow, constant) = (names.allow(), constant(set));
    let text = docs(&format!("The parameter set `{}`.", set.name));
    quote! {
        #allow
        impl #name<::core::primitive::f64> {
            #text
            #[must_use]
            pub const fn default() -> Self {
                Self::#constant
            }
        }

        #text
        #allow
        impl<#scalar: #runtime::Scalar> ::core::default::Default for #name<#scalar> {
            fn default() -> Self {
                #name::cast(&#name::<::core::primitive::f64>::#constant)
            }
        }
    }
}

/// The name of the constant that holds a parameter set.
pub fn constant(set: &ParameterSet) -> Ident {
    format_ident!("{}", set.name.to_string().to_uppercase(), span = set.name.span())
}
