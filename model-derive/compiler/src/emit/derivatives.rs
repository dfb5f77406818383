//! The struct of the derivatives, which value is which derivative, and what implements the runtime's trait.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::names::GeneratedNames;
use super::with_respect_to::{matrix_with_respect_to, tell_asked, with_respect_to};
use super::{derive, docs, each_result, states};
use crate::derivatives::{Derivatives, Partial};
use crate::model::Model;
use crate::program::Program;

/// The struct and the function, and then which value is which derivative; nothing for a model that does not ask for
/// derivatives.
pub fn emit(
    model: &Model,
    names: &GeneratedNames,
    computed: Option<&Derivatives>,
    matrices_alone: Option<&Program>,
) -> [Option<TokenStream>; 2] {
    let Some(asked) = &model.derivatives else { return [None, None] };
    let GeneratedNames { runtime, model: name, derivatives, scalar, .. } = names;
    let visibility = &model.visibility;
    let (allow, derive) = (names.allow(), derive());
    let partials = computed.map_or(&[][..], |computed| &computed.partials);
    let value_count = Literal::usize_unsuffixed(partials.iter().map(|partial| partial.value + 1).max().unwrap_or(0));
    let count = Literal::usize_unsuffixed(partials.len());
    let table = table(model, partials, runtime);
    let struct_docs = docs(&format!(
        "The derivatives of the matrices of [`{name}`] with respect to its parameters,\nin SI units: those that are not \
         zero for all parameters.{}",
        tell_asked(model, asked)
    ));
    let functions = each_result::emit(model, names, computed, matrices_alone, &value_count);
    let with_respect_to = match asked.has_all_matrices(model) {
        true => with_respect_to(model, asked, names, partials.len()),
        false => matrix_with_respect_to(model, asked, names, partials.len()),
    };
    // What takes any model needs all derivatives.
    let differentiable = asked.is_all(model).then(|| differentiable(model, names, partials.len()));
    let computed = quote! {
        #struct_docs
        #allow
        #derive
        #visibility struct #derivatives<#scalar = ::core::primitive::f64> {
            /// Their values, each once: which derivative has which is said by [`Self::PARTIALS`].
            pub values: [#scalar; #value_count],
        }

        #functions
    };
    let with_respect_to = quote! {
        #allow
        impl<#scalar: #runtime::Scalar> #derivatives<#scalar> {
            #with_respect_to
        }
    };
    let with_respect_to = names.with_arguments(&["parameter"], with_respect_to);
    let assigned = quote! {
        #with_respect_to

        #differentiable

        #allow
        impl #derivatives {
            /// Which derivatives there are, by parameters.
            pub const PARTIALS: &'static [#runtime::Partial; #count] = &[#(#table),*];
        }
    };
    [Some(computed), Some(assigned)]
}

/// The entry and the parameter of each derivative.
fn table(model: &Model, partials: &[Partial], runtime: &TokenStream) -> Vec<TokenStream> {
    let n = model.coordinates.len();
    let partial = |&Partial { entry, parameter, value, negative }: &Partial| {
        let matrix = format_ident!("{}", model.matrices[entry / (n * n)].0.identifier());
        let [row, column, parameter, value] =
            [entry / n % n, entry % n, parameter, value].map(Literal::usize_unsuffixed);
        let negative = negative.then(|| quote!(.negative()));
        quote!(#runtime::Partial::new(#runtime::MatrixName::#matrix, #row, #column, #parameter, #value) #negative)
    };
    partials.iter().map(partial).collect()
}

fn differentiable(model: &Model, names: &GeneratedNames, partials: usize) -> TokenStream {
    let GeneratedNames { runtime, model: name, matrices: rows, derivatives, scalar, other, .. } = names;
    let allow = names.allow();
    let [n, parameters, count] =
        [model.coordinates.len(), model.parameters.len(), partials].map(Literal::usize_unsuffixed);
    let [put_entry, put_derivative, each_result] =
        ["put_entry", "put_derivative", "each_result"].map(|name| names.variable(name));
    let [matrices, values, all, position, zero] =
        ["matrices", "derivatives", "all", "position", "zero"].map(|name| names.variable(name));
    let coefficients = quote!(#runtime::Coefficients::from_rows(#rows::rows(&#matrices)));
    let coefficients = states::complete(coefficients, model, names);
    quote! {
        #allow
        impl<#scalar: #runtime::Scalar> #runtime::Differentiable<#n> for #name<#scalar> {
            type Derivatives = [#runtime::Coefficients<#scalar, #n>; #parameters];

            type WithDerivativesOver<#other: #runtime::Number> = #name<#other>;

            const PARTIALS: &'static [#runtime::Partial] = <#derivatives>::PARTIALS;

            fn coefficients_and_derivatives(&self) -> (#runtime::Coefficients<#scalar, #n>, Self::Derivatives) {
                let (#matrices, #values) = self.matrices_and_derivatives();
                let #zero = <#scalar as #runtime::Scalar>::from_f64(0.0);
                let mut #all = [#runtime::Coefficients::from_rows([[[#zero; #n]; #n]; 8]); #parameters];
                for #position in 0..#count {
                    #runtime::Partial::write(&<#derivatives>::PARTIALS[#position], &#values.values, &mut #all);
                }
                (#coefficients, #all)
            }
        }

        #allow
        impl<#scalar: #runtime::Number> #runtime::EvaluatorWithDerivatives<#scalar, #n> for #name<#scalar> {
            #[inline(always)]
            fn each_result(
                &self,
                #put_entry: impl ::core::ops::FnMut(::core::primitive::usize, #scalar),
                #put_derivative: impl ::core::ops::FnMut(::core::primitive::usize, #scalar),
            ) {
                self.#each_result(#put_entry, #put_derivative);
            }
        }
    }
}
