//! The struct of the derivatives, the function that computes them, and what implements the runtime's trait.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::body::{Body, Inputs};
use super::evaluator;
use super::names::GeneratedNames;
use super::with_respect_to::{matrix_with_respect_to, tell_asked, with_respect_to};
use super::{derive, docs, states};
use crate::derivatives::{Derivatives, Partial, entry_names};
use crate::model::Model;
use crate::program::{Counts, Program, Value};

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
    let functions = functions(model, names, computed, matrices_alone, &value_count);
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

/// The functions that compute all, and the one program that they share.
fn functions(
    model: &Model,
    names: &GeneratedNames,
    computed: Option<&Derivatives>,
    matrices_alone: Option<&Program>,
    value_count: &Literal,
) -> TokenStream {
    let GeneratedNames { runtime, model: name, matrices: all, derivatives, scalar, .. } = names;
    let allow = names.allow();
    let counts = computed.map(|computed| format!(":\n{}", Counts::of(&computed.program))).unwrap_or_default();
    let by_value = docs(&format!(
        "The coefficient matrices and their derivatives, from one straight-line program{counts}.\n\n\
         The parameters are not validated; at valid ones every derivative exists.\n\n\
         Where they are stored, [`Self::write_matrices_and_derivatives`] takes less time."
    ));
    let [put_entry, put_derivative] =
        ["put_entry", "put_derivative"].map(|name| names.variable_beside_values(name, model));
    let body = match (computed, matrices_alone) {
        (Some(computed), Some(matrices)) => body(model, names, computed, matrices, [&put_entry, &put_derivative]),
        // Beside a mistake in the declaration: nothing ever runs it.
        _ => quote!(loop {}),
    };
    let [matrices, values, zero, position, value, each_result] =
        ["matrices", "derivatives", "zero", "position", "value", "each_result"].map(|name| names.variable(name));
    let inputs = Inputs::of_model(model);
    let zero_call = names.call("like", &inputs.values[inputs.like], Some(&quote!(0.0)));
    let entries = Literal::usize_unsuffixed(model.matrices.len() * model.coordinates.len().pow(2));
    let functions = quote! {
        #allow
        impl<#scalar: #runtime::Number> #name<#scalar> {
            #by_value
            // Lanes are fast only inside the function that was compiled for them.
            #[inline(always)]
            #[must_use]
            pub fn matrices_and_derivatives(&self) -> (#all<#scalar>, #derivatives<#scalar>) {
                let #zero = #zero_call;
                let mut #matrices = #all::from_entries([#zero; #entries]);
                let mut #values = #derivatives { values: [#zero; #value_count] };
                self.#each_result(
                    #[inline(always)]
                    |#position, #value| #matrices.set_entry(#position, #value),
                    #[inline(always)]
                    |#position, #value| #values.values[#position] = #value,
                );
                (#matrices, #values)
            }

            /// Writes the coefficient matrices and their derivatives over others, each as soon as it is computed.
            ///
            /// They are those of [`Self::matrices_and_derivatives`], to the last bit. That function has more results than a
            /// processor has registers, and moves them twice.
            #[inline(always)]
            pub fn write_matrices_and_derivatives(
                &self,
                #matrices: &mut #all<#scalar>,
                #values: &mut #derivatives<#scalar>,
            ) {
                *#matrices = #all::from_entries([#zero_call; #entries]);
                self.#each_result(
                    #[inline(always)]
                    |#position, #value| {
                        #matrices.set_entry(#position, #value);
                        #runtime::write_now();
                    },
                    #[inline(always)]
                    |#position, #value| {
                        #values.values[#position] = #value;
                        #runtime::write_now();
                    },
                );
            }

            /// The program: gives each entry that differs, and each value of the derivatives, to a function with its position.
            #[inline(always)]
            fn #each_result(
                &self,
                mut #put_entry: impl ::core::ops::FnMut(::core::primitive::usize, #scalar),
                mut #put_derivative: impl ::core::ops::FnMut(::core::primitive::usize, #scalar),
            ) {
                #body
            }
        }
    };
    names.with_arguments(&["matrices", "derivatives"], functions)
}

fn body(
    model: &Model,
    names: &GeneratedNames,
    computed: &Derivatives,
    matrices_alone: &Program,
    [put_entry, put_derivative]: [&Ident; 2],
) -> TokenStream {
    let program = &computed.program;
    let entries = model.matrices.len() * model.coordinates.len().pow(2);
    let mut results = evaluator::results(model, program);
    let entry_names = entry_names(model);
    for Partial { entry, parameter, value, .. } in computed.partials.iter().filter(|partial| !partial.negative) {
        let name = format!("{}_{}", entry_names[*entry], model.parameters[*parameter].name);
        results.push((program.outputs[entries + value], name));
    }
    // Entries that are always zero are none of the results.
    let distinct = evaluator::entries(matrices_alone).into_iter().map(|(_, places)| program.outputs[places[0]]);
    let distinct: Vec<Value> = distinct.collect();
    let outputs = [&distinct, &program.outputs[entries..]].concat();
    let body = Body::new(&Program { outputs, ..program.clone() }, model, names, &results);
    let mut puts: Vec<(Value, TokenStream)> = Vec::new();
    let mut put = |function: &Ident, position: usize, value: Value| {
        let (position, expression) = (Literal::usize_unsuffixed(position), &body.values[value]);
        puts.push((value, quote!(#function(#position, #expression);)));
    };
    for (position, value) in distinct.iter().enumerate() {
        put(put_entry, position, *value);
    }
    for (position, value) in program.outputs[entries..].iter().enumerate() {
        put(put_derivative, position, *value);
    }
    let of = |value: Value| puts.iter().filter(move |(of, _)| *of == value).map(|(_, put)| put);
    let of_no_variable = puts.iter().filter(|(value, _)| !body.is_bound(*value)).map(|(_, put)| put);
    let statements = body.statements_with(|value| of(value).cloned().collect());
    quote! {
        #(#of_no_variable)*
        #statements
    }
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
