//! The implementation of the runtime's trait for a model over any kind of number.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::evaluator::entries;
use super::names::GeneratedNames;
use crate::model::Model;
use crate::program::Program;

pub fn emit(model: &Model, names: &GeneratedNames, program: Option<&Program>) -> TokenStream {
    let GeneratedNames { runtime, model: name, matrices: all, scalar, .. } = names;
    let allow = names.allow();
    let n = model.coordinates.len();
    let fields: Vec<_> = model.parameters.iter().map(|parameter| &parameter.name).collect();
    let positions = (0..fields.len()).map(Literal::usize_unsuffixed);
    let size = Literal::usize_unsuffixed(n);
    let parameter = format_ident!("parameter");
    let count = Literal::usize_unsuffixed(program.map_or(0, |program| entries(program).len()));
    let implementation = quote! {
        #allow
        impl<#scalar: #runtime::Number> #runtime::Evaluator<#scalar, #size> for #name<#scalar> {
            type Entries = [#scalar; #count];

            #[inline(always)]
            fn from_parameters(mut #parameter: impl ::core::ops::FnMut(::core::primitive::usize) -> #scalar) -> Self {
                Self { #(#fields: #parameter(#positions),)* }
            }

            #[inline(always)]
            fn entries(&self) -> Self::Entries {
                #all::distinct_entries(&self.matrices())
            }

            #[inline(always)]
            fn rows(&self) -> [[[#scalar; #size]; #size]; 8] {
                #all::rows(&self.matrices())
            }
        }
    };
    names.with_arguments(&["parameter"], implementation)
}
