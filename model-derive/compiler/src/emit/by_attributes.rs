//! The nonlinear equations of motion by the attributes of a mechanism, as text.

use proc_macro2::TokenStream;
use quote::quote;

use super::names::GeneratedNames;
use super::statements;
use crate::model::Model;
use crate::nonlinear::AccelerationPrograms;

/// What the runtime's `ModelInfo` has of them; nothing of a model that does not ask for nonlinear equations.
pub fn emit(model: &Model, names: &GeneratedNames, programs: Option<&AccelerationPrograms>) -> TokenStream {
    let Some((programs, motion)) = programs.zip(model.motion.as_ref()) else {
        return quote!(::core::option::Option::None);
    };
    let runtime = &names.runtime;
    let AccelerationPrograms { constants, closure, accelerations } = programs;
    let parameters = model.parameters.len();
    let of_attributes = |index: usize| match index.checked_sub(parameters) {
        Some(attribute) => format!("A{attribute}"),
        None => format!("P{index}"),
    };
    let counts = [constants.outputs.len(), motion.layout.positions.len(), motion.speeds().len()];
    let of_state = |mut index: usize| {
        for (letter, count) in ["C", "Q", "U"].into_iter().zip(counts) {
            if index < count {
                return format!("{letter}{index}");
            }
            index -= count;
        }
        format!("F{index}")
    };
    let constants = statements::write(constants, of_attributes, 'C');
    let [closure, accelerations] = [closure, accelerations].map(|program| statements::write(program, of_state, 'R'));
    quote! {
        ::core::option::Option::Some(&#runtime::MotionFormulas {
            constants: &[#(#constants),*],
            closure: &[#(#closure),*],
            accelerations: &[#(#accelerations),*],
        })
    }
}
