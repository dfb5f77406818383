//! The functions that compute the matrices and their derivatives: together, or over others, by one program.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::body::{Body, Inputs};
use super::names::GeneratedNames;
use super::{docs, evaluator};
use crate::derivatives::{Derivatives, Partial, entry_names};
use crate::model::Model;
use crate::program::{Counts, Program, Value};

/// The functions that compute all, and the one program that they share.
pub fn emit(
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
    let [matrices, values] = ["matrices", "derivatives"].map(|name| format_ident!("{name}"));
    let [zero, position, value, each_result] =
        ["zero", "position", "value", "each_result"].map(|name| names.variable(name));
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
