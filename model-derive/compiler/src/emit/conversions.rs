//! Parameters to and from arrays, and in other kinds of numbers.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::names::GeneratedNames;
use super::structure::fields;
use crate::model::Model;

/// All other conversions go by way of the array, so that the fields are listed once for each direction.
pub fn emit(model: &Model, names: &GeneratedNames) -> TokenStream {
    let GeneratedNames { runtime, model: name, scalar, other, .. } = names;
    let allow = names.allow();
    let fields = fields(model);
    let count = Literal::usize_unsuffixed(fields.len());
    let positions = (0..fields.len()).map(Literal::usize_unsuffixed);
    let (values, value) = (format_ident!("values"), names.variable("value"));
    let parameters = names.variable("parameters");
    let [single, double] = [quote!(::core::primitive::f32), quote!(::core::primitive::f64)];
    let conversions = quote! {
        #allow
        impl<#scalar: #runtime::Number> #name<#scalar> {
            /// The parameters from an array in declared order.
            #[must_use]
            pub const fn from_array(#values: [#scalar; #count]) -> Self {
                Self { #(#fields: #values[#positions],)* }
            }

            /// The parameters as an array in declared order.
            // Batches read some of them at a time, straight from where they lie.
            #[inline(always)]
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

        #allow
        impl #name<#double> {
            /// The same parameters in `f32`, each rounded to the nearest; in constants, too.
            #[must_use]
            pub const fn to_f32(&self) -> #name<#single> {
                #name::from_array(#runtime::to_f32(self.to_array()))
            }
        }

        /// The same parameters, exactly.
        #allow
        impl ::core::convert::From<#name<#single>> for #name<#double> {
            fn from(#parameters: #name<#single>) -> Self {
                #name::cast(&#parameters)
            }
        }
    };
    names.with_arguments(&["values"], conversions)
}
