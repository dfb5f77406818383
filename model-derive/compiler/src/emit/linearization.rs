//! What implements the runtime's traits of the nonlinear equations to first order.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::motion::{emit_values, rows};
use super::names::GeneratedNames;
use crate::model::Model;
use crate::motion::MotionModel;
use crate::nonlinear::{MotionPrograms, PartialPrograms};

/// Nothing for a model that does not ask for derivatives.
pub fn emit(
    model: &Model,
    names: &GeneratedNames,
    motion: &MotionModel,
    programs: Option<&MotionPrograms>,
) -> Option<TokenStream> {
    model.derivatives.as_ref().filter(|asked| asked.is_all(model))?;
    let GeneratedNames { runtime, motion: output, scalar, .. } = names;
    let allow = names.allow();
    let applied = model.kinematics.as_ref().map_or(0, |kinematics| kinematics.applied.len());
    let (positions, speeds) = (motion.layout.positions.len(), motion.layout.conditions.independent.len());
    let states = positions + speeds;
    let [p, n, s, f, k] = [positions, speeds, states, applied, model.parameters.len()].map(Literal::usize_unsuffixed);
    let arguments = ["positions", "speeds", "forces"].map(|name| names.variable(name));
    let partials = programs.and_then(|programs| Some((programs, programs.partials.as_ref()?)));
    let (linearize, by_parameters) = match partials {
        Some((programs, PartialPrograms { by_state, by_parameters })) => {
            let (statements, values) = emit_values(model, names, motion, by_state, programs, &arguments);
            let rows_of = |part: fn(&[TokenStream], usize) -> &[TokenStream], columns| {
                let part: Vec<TokenStream> =
                    values.chunks(states + applied).flat_map(|row| part(row, states)).cloned().collect();
                rows(&part, states, columns)
            };
            let a = rows_of(|row, states| &row[..states], states);
            let b = rows_of(|row, states| &row[states..], applied);
            let linearize = quote!(#statements (#a, #b));
            let (statements, values) = emit_values(model, names, motion, by_parameters, programs, &arguments);
            let all = rows(&values, states, model.parameters.len());
            (linearize, quote!(#statements #all))
        }
        // Beside a mistake in the declaration: nothing ever runs it.
        None => (quote!(loop {}), quote!(loop {})),
    };
    let [positions, speeds, forces] = &arguments;
    Some(quote! {
        #allow
        #[allow(unused_variables)]
        impl<#scalar: #runtime::Scalar> #runtime::motion::UncheckedPartials for #output<#scalar> {
            type State = [#scalar; #s];
            type ByState = [[#scalar; #s]; #s];
            type ByForces = [[#scalar; #f]; #s];
            type Parameters = [#scalar; #k];
            type ByParameters = [[#scalar; #k]; #s];

            fn linearize_unchecked(
                &self,
                #positions: &[#scalar; #p],
                #speeds: &[#scalar; #n],
                #forces: &[#scalar; #f],
            ) -> ([[#scalar; #s]; #s], [[#scalar; #f]; #s]) {
                #linearize
            }

            fn by_parameters_unchecked(
                &self,
                #positions: &[#scalar; #p],
                #speeds: &[#scalar; #n],
                #forces: &[#scalar; #f],
            ) -> [[#scalar; #k]; #s] {
                #by_parameters
            }
        }
    })
}

/// What code that takes any motion is given of it: of arrays of positions, speeds and forces of these lengths.
pub fn emit_written(names: &GeneratedNames, [p, n, f]: [Literal; 3]) -> TokenStream {
    let GeneratedNames { runtime, scalar, .. } = names;
    let [positions, speeds, forces, a, b, found] =
        ["positions", "speeds", "forces", "a", "b", "found"].map(|name| names.variable(name));
    let motion = quote!(#runtime::motion);
    quote! {
        fn linearize_into(
            &self,
            #positions: &[#scalar; #p],
            #speeds: &[#scalar; #n],
            #forces: &[#scalar; #f],
            #a: &mut [#scalar],
            #b: &mut [#scalar],
        ) -> ::core::option::Option<::core::result::Result<(), #motion::MotionError>> {
            let #found = #motion::Linearizable::linearize(self, #positions, #speeds, #forces);
            ::core::option::Option::Some(#found.map(|#found| #motion::Linearization::copy_into(&#found, #a, #b)))
        }
    }
}
