//! What a model tells by itself: its description and its parameter sets by name, for `f64` unless another number type is
//! asked for, and its parameters as text.
//!
//! What the trait has for every number type is found here for `f64` first, so that `Name::INFO` has one meaning.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::names::GeneratedNames;
use crate::model::Model;

pub fn emit(model: &Model, names: &GeneratedNames) -> TokenStream {
    let GeneratedNames { runtime, model: name, scalar, .. } = names;
    let allow = names.allow();
    let n = Literal::usize_unsuffixed(model.coordinates.len());
    let [info, formatter] = ["info", "formatter"].map(|name| names.variable(name));
    let argument = format_ident!("name");
    let set = (!model.sets.is_empty()).then(|| {
        quote! {
            /// The parameter set of this name, however it is spelt: upper and lower case, `_`, `-` and spaces make no
            /// difference. In `f32` it is had by the trait `Model`.
            #[must_use]
            pub fn set(#argument: &::core::primitive::str) -> ::core::option::Option<Self> {
                <Self as #runtime::Model<#n>>::set(#argument)
            }
        }
    });
    let inherent = quote! {
        #allow
        impl #name<::core::primitive::f64> {
            /// What the model tells about itself, the same for every number type.
            pub const INFO: &'static #runtime::ModelInfo = <Self as #runtime::Model<#n>>::INFO;

            #set
        }
    };
    let inherent = names.with_arguments(&["name"], inherent);
    quote! {
        #inherent

        /// The parameters, one a line with its unit, in the precision that is asked for; `{:#}` says what they are.
        #allow
        impl<#scalar: #runtime::Scalar> ::core::fmt::Display for #name<#scalar> {
            fn fmt(
                &self,
                #formatter: &mut ::core::fmt::Formatter<'_>,
            ) -> ::core::result::Result<(), ::core::fmt::Error> {
                let #info = const { &<Self as #runtime::Model<#n>>::INFO.without_formulas() };
                #info.write_parameters(&self.to_array(), #formatter)
            }
        }
    }
}
