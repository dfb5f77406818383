//! The implementation of the runtime's trait.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::evaluator::Body;
use super::names::Names;
use super::{allow, info};
use crate::model::Model;
use crate::program::Program;
use crate::syntax::MatrixName;

pub fn emit(model: &Model, names: &Names, matrices: Option<&Program>, requirements: Option<&Program>) -> TokenStream {
    let Names { runtime, model: name, scalar, other, .. } = names;
    let allow = allow();
    let n = Literal::usize_unsuffixed(model.coordinates.len());
    let count = Literal::usize_unsuffixed(model.parameters.len());
    let text = model.name.to_string();
    let fields: Vec<_> = model.parameters.iter().map(|parameter| &parameter.name).collect();
    let positions: Vec<_> = (0..fields.len()).map(Literal::usize_unsuffixed).collect();
    let description = info::emit(model, names, matrices);
    let [values, info, matrices] = ["values", "info", "matrices"].map(|name| names.variable(name));
    let length = names.length(&values);
    let length_check = quote! {
        if #length != #count {
            return ::core::result::Result::Err(
                #runtime::LengthError { model: #text, expected: #count, found: #length },
            );
        }
    };
    let gravity = match model.gravity {
        Some(index) => {
            let field = fields[index];
            quote!(::core::option::Option::Some(self.#field))
        }
        None => quote!(::core::option::Option::None),
    };
    let requirements = requirements.map(|program| validate_requirements(model, names, &info, program));
    let zero = quote!([[<#scalar as #runtime::Scalar>::from_f64(0.0); #n]; #n]);
    let rows = all_matrices(model, &matrices, &zero);
    quote! {
        #allow
        impl<#scalar: #runtime::Scalar> #runtime::Model<#n> for #name<#scalar> {
            type Scalar = #scalar;

            type Array<#other: ::core::marker::Copy> = [#other; #count];

            type Over<#other: #runtime::Number> = #name<#other>;

            const INFO: &'static #runtime::ModelInfo = #description;

            fn from_slice(#values: &[#scalar]) -> ::core::result::Result<Self, #runtime::LengthError> {
                #length_check
                ::core::result::Result::Ok(Self { #(#fields: #values[#positions],)* })
            }

            fn write_to(&self, #values: &mut [#scalar]) -> ::core::result::Result<(), #runtime::LengthError> {
                #length_check
                #values.copy_from_slice(&self.to_array());
                ::core::result::Result::Ok(())
            }

            #[inline(always)]
            fn array<#other: ::core::marker::Copy>(
                element: impl ::core::ops::FnMut(::core::primitive::usize) -> #other,
            ) -> Self::Array<#other> {
                ::core::array::from_fn(element)
            }

            #[inline(always)]
            fn parameters(&self) -> Self::Array<#scalar> {
                self.to_array()
            }

            fn validate(&self) -> ::core::result::Result<(), #runtime::ParameterError> {
                let #info = <Self as #runtime::Model<#n>>::INFO;
                #info.validate(&[#(#runtime::Scalar::to_f64(self.#fields)),*])?;
                #requirements
                ::core::result::Result::Ok(())
            }

            #[inline]
            fn coefficients(&self) -> #runtime::Coefficients<#scalar, #n> {
                let #matrices = self.matrices();
                #runtime::Coefficients::from_rows([#(#rows),*])
            }

            fn gravity(&self) -> ::core::option::Option<#scalar> {
                #gravity
            }
        }
    }
}

/// The rows of each of the six matrices, from the struct of the declared ones.
pub fn all_matrices(model: &Model, matrices: &Ident, zero: &TokenStream) -> [TokenStream; 6] {
    MatrixName::ALL.map(|matrix| {
        let field = format_ident!("{}", matrix.field());
        let declared = model.matrices.iter().any(|(declared, _)| *declared == matrix);
        if declared { quote!(#matrices.#field) } else { zero.clone() }
    })
}

fn validate_requirements(model: &Model, names: &Names, info: &Ident, program: &Program) -> TokenStream {
    let runtime = &names.runtime;
    let body = Body::new(program, model, names);
    let statements = body.statements();
    let checks = model.requirements.iter().zip(&program.outputs).map(|(requirement, value)| {
        let value = &body.values[*value];
        let subject = &requirement.text;
        let domain = info::domain(requirement.domain, names);
        quote! {
            #info.require(#subject, #runtime::Scalar::to_f64(#value), "", #domain)?;
        }
    });
    quote! { #statements #(#checks)* }
}
