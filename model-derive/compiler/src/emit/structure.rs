//! The struct of the parameters, its parameter sets, and conversions.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::documentation::{model_docs, parameter_docs, set_docs};
use super::names::GeneratedNames;
use super::{derive, docs, number};
use crate::model::{Model, ParameterSet};

/// The struct, its parameter sets if there are any, and the conversions.
pub fn emit(model: &Model, names: &GeneratedNames) -> (TokenStream, Option<TokenStream>, TokenStream) {
    let sets = (!model.sets.is_empty()).then(|| emit_sets(model, names));
    (emit_struct(model, names), sets, emit_conversions(model, names))
}

fn emit_struct(model: &Model, names: &GeneratedNames) -> TokenStream {
    let GeneratedNames { model: name, scalar, .. } = names;
    let Model { visibility, parameters, .. } = model;
    let (allow, derive) = (names.allow(), derive());
    let struct_docs = docs(&model_docs(model));
    let field_docs = parameters.iter().map(|parameter| docs(&parameter_docs(parameter)));
    let fields = fields(model);
    quote! {
        #struct_docs
        #allow
        #derive
        #visibility struct #name<#scalar = ::core::primitive::f64> {
            #(#field_docs pub #fields: #scalar,)*
        }
    }
}

/// All other conversions go by way of the array, so that the fields are listed once for each direction.
fn emit_conversions(model: &Model, names: &GeneratedNames) -> TokenStream {
    let GeneratedNames { runtime, model: name, scalar, other, .. } = names;
    let allow = names.allow();
    let fields = fields(model);
    let count = Literal::usize_unsuffixed(fields.len());
    let positions = (0..fields.len()).map(Literal::usize_unsuffixed);
    let (values, value) = (format_ident!("values"), names.variable("value"));
    let conversions = quote! {
        #allow
        impl<#scalar: #runtime::Number> #name<#scalar> {
            /// The parameters from an array in declared order.
            #[must_use]
            pub const fn from_array(#values: [#scalar; #count]) -> Self {
                Self { #(#fields: #values[#positions],)* }
            }

            /// The parameters as an array in declared order.
            #[must_use]
            pub const fn to_array(&self) -> [#scalar; #count] {
                [#(self.#fields,)*]
            }
        }

        #allow
        impl<#scalar: #runtime::Scalar> #name<#scalar> {
            /// The same parameters in another number type, each rounded to the nearest.
            #[must_use]
            pub fn cast<#other: #runtime::Scalar>(&self) -> #name<#other> {
                let #values = self.to_array();
                #name::from_array(#values.map(|#value| #runtime::Scalar::from_f64(#runtime::Scalar::to_f64(#value))))
            }
        }
    };
    names.with_arguments(&["values"], conversions)
}

fn fields(model: &Model) -> Vec<&Ident> {
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
    quote! {
        #allow
        impl #name<::core::primitive::f64> { #(#constants)* }
    }
}

/// The name of the constant that holds a parameter set.
pub fn constant(set: &ParameterSet) -> Ident {
    format_ident!("{}", set.name.to_string().to_uppercase(), span = set.name.span())
}
