//! The nonlinear equations of motion to first order: the struct of A and B, and the functions that compute them and the
//! derivatives by parameters.

use super::comment::block;
use super::motion::{WITH_FORCES, applied, borrowed, compute, find, values};
use super::template::fill;
use super::{Context, Precision, counts};
use crate::nonlinear::PartialPrograms;

/// How many rows and columns there are; nothing for a model without these derivatives.
pub fn declare_sizes(context: &Context) -> String {
    if find_partials(context).is_none() {
        return String::new();
    }
    let upper = context.prefix.upper();
    let states = "How many states there are: all positions, and behind them the speeds.";
    let parameters = "How many parameters there are.";
    format!(
        "{}#define {upper}_STATES ({upper}_POSITIONS + {upper}_SPEEDS)\n\n{}#define {upper}_PARAMETERS {}U\n\n",
        block(states, 0),
        block(parameters, 0),
        context.model.parameters.len()
    )
}

/// The struct and the functions.
pub fn declare(context: &Context, precision: Precision) -> String {
    let Some(partials) = find_partials(context) else { return String::new() };
    let has_forces = applied(context).next().is_some();
    let by_forces = format!(
        "    /** The derivatives with respect to the forces, a column for each. */\n    {} b[{upper}_STATES][{upper}_FORCES];\n",
        precision.number(),
        upper = context.prefix.upper()
    );
    let of_declaration = [
        ("by_forces", if has_forces { by_forces } else { String::new() }),
        ("equation", if has_forces { "A (x - x0) + B (f - f0)" } else { "A (x - x0)" }.to_string()),
        ("matrices", if has_forces { "A and B" } else { "A" }.to_string()),
        ("count_linearize", counts(&partials.by_state)),
        ("count_by_parameters", counts(&partials.by_parameters)),
    ];
    fill_with(include_str!("templates/linearization.h"), context, precision, &of_declaration)
}

/// The functions.
pub fn define(context: &Context, precision: Precision) -> String {
    let Some(PartialPrograms { by_state, by_parameters }) = find_partials(context) else { return String::new() };
    let Some((motion, _)) = find(context) else { return String::new() };
    let states = motion.positions.len() + motion.speeds().len();
    let forces = applied(context).count();
    let parts = |row| [(format!("linearization->a[{row}]"), states), (format!("linearization->b[{row}]"), forces)];
    let linearization: Vec<(String, usize)> = (0..states).flat_map(parts).collect();
    let parameters = context.model.parameters.len();
    let derivatives: Vec<(String, usize)> =
        (0..states).map(|row| (format!("by_parameters[{row}]"), parameters)).collect();
    let body = |program, outputs: &[(String, usize)]| {
        let outputs: Vec<(&str, usize)> = outputs.iter().map(|(array, length)| (&**array, *length)).collect();
        compute(context, precision, program, WITH_FORCES, &outputs)
    };
    let b_finite = format!(
        " && carvallo_are_finite_{}(linearization->b[row], {}_FORCES)",
        precision.name(),
        context.prefix.upper()
    );
    let of_definition = [
        ("b_finite", if forces > 0 { b_finite } else { String::new() }),
        ("compute_linearization", body(by_state, &linearization)),
        ("compute_by_parameters", body(by_parameters, &derivatives)),
    ];
    fill_with(include_str!("templates/linearization.c"), context, precision, &of_definition)
}

fn find_partials<'a>(context: &'a Context) -> Option<&'a PartialPrograms> {
    find(context)?.1.partials.as_ref()
}

/// A template with places for what all functions of motion have, and for more.
fn fill_with(template: &str, context: &Context, precision: Precision, more: &[(&'static str, String)]) -> String {
    let Some((motion, programs)) = find(context) else { return String::new() };
    let all = [&values(context, precision, motion, programs)[..], more].concat();
    fill(template, &borrowed(&all))
}
