//! The implementation of the runtime's trait.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::body::Body;
use super::info;
use super::names::GeneratedNames;
use super::states;
use crate::model::Model;
use crate::pipeline::Programs;
use crate::program::Program;

pub fn emit(model: &Model, names: &GeneratedNames, programs: Option<&Programs>) -> TokenStream {
    let GeneratedNames { runtime, model: name, matrices, scalar, other, .. } = names;
    let allow = names.allow();
    let n = Literal::usize_unsuffixed(model.coordinates.len());
    let count = Literal::usize_unsuffixed(model.parameters.len());
    let text = model.name.to_string();
    let description = info::emit(model, names, programs);
    let [position, info] = ["position", "info"].map(|name| names.variable(name));
    let [values, element] = ["values", "element"].map(|name| format_ident!("{name}"));
    let length_check = quote!(#runtime::LengthError::check(#text, #count, #values)?;);
    let gravity = match model.gravity {
        Some(index) => {
            let field = &model.parameters[index].name;
            quote!(::core::option::Option::Some(self.#field))
        }
        None => quote!(::core::option::Option::None),
    };
    let coefficients = quote!(#runtime::Coefficients::from_rows(#matrices::rows(&self.matrices())));
    let coefficients = states::complete(coefficients, model, names);
    let requirements = programs.map(|programs| &programs.requirements).filter(|_| !model.requirements.is_empty());
    let nonlinear = model.motion.is_some().then(|| {
        quote! {
            fn nonlinear(&self) -> ::core::option::Option<impl #runtime::motion::Motion<Scalar = Self::Scalar>> {
                ::core::option::Option::Some(self.motion())
            }
        }
    });
    let [force, row] = ["force", "row"].map(|name| names.variable(name));
    let applied = model.kinematics.as_ref().map_or(0, |kinematics| kinematics.applied.len());
    let shares = (applied > 0).then(|| {
        let applied = Literal::usize_unsuffixed(applied);
        quote! {
            fn shares(&self, #force: ::core::primitive::usize) -> ::core::option::Option<[#scalar; #n]> {
                (#force < #applied).then(|| self.kinematics().forces.map(|#row| #row[#force]))
            }
        }
    });
    let derivatives = model.derivatives.as_ref().filter(|asked| asked.is_all(model)).map(|_| {
        quote! {
            fn derivatives(&self) -> ::core::option::Option<#runtime::WithDerivatives<Self, #n>> {
                ::core::option::Option::Some(#runtime::Differentiable::coefficients_and_derivatives(self))
            }
        }
    });
    let requirements = requirements.map(|program| validate_requirements(model, names, &info, program));
    let implementation = quote! {
        #allow
        impl<#scalar: #runtime::Scalar> #runtime::Model<#n> for #name<#scalar> {
            type Scalar = #scalar;

            type Array<#other: ::core::marker::Copy> = [#other; #count];

            type Over<#other: #runtime::Number> = #name<#other>;

            const INFO: &'static #runtime::ModelInfo = #description;

            fn from_slice(#values: &[#scalar]) -> ::core::result::Result<Self, #runtime::LengthError> {
                #length_check
                ::core::result::Result::Ok(
                    <Self as #runtime::Evaluator<#scalar, #n>>::from_parameters(|#position| #values[#position])
                )
            }

            fn write_to(&self, #values: &mut [#scalar]) -> ::core::result::Result<(), #runtime::LengthError> {
                #length_check
                #values.copy_from_slice(&self.to_array());
                ::core::result::Result::Ok(())
            }

            #[inline(always)]
            fn array<#other: ::core::marker::Copy>(
                #element: impl ::core::ops::FnMut(::core::primitive::usize) -> #other,
            ) -> Self::Array<#other> {
                ::core::array::from_fn(#element)
            }

            #[inline(always)]
            fn parameters(&self) -> Self::Array<#scalar> {
                self.to_array()
            }

            fn validate(&self) -> ::core::result::Result<(), #runtime::ParameterError> {
                let #info = const { &<Self as #runtime::Model<#n>>::INFO.without_formulas() };
                #info.validate(&self.to_array().map(#runtime::Scalar::to_f64))?;
                #requirements
                ::core::result::Result::Ok(())
            }

            #[inline]
            fn coefficients(&self) -> #runtime::Coefficients<#scalar, #n> {
                #coefficients
            }

            #derivatives

            #nonlinear

            #shares

            fn gravity(&self) -> ::core::option::Option<#scalar> {
                #gravity
            }
        }
    };
    names.with_arguments(&["values", "element"], implementation)
}

fn validate_requirements(model: &Model, names: &GeneratedNames, info: &Ident, program: &Program) -> TokenStream {
    let runtime = &names.runtime;
    let body = Body::new(program, model, names, &[]);
    let statements = body.statements();
    let values = program.outputs.iter().map(|value| &body.values[*value]);
    quote! {
        #statements
        #info.validate_requirements(&[#(#runtime::Scalar::to_f64(#values)),*])?;
    }
}
