//! The struct of the rates and forces that follow from a mechanism, and the functions that compute them.

use std::collections::HashSet;

use super::body::Body;
use super::comment::{block, quoted};
use super::names::identifier;
use super::template::{fill, wrap};
use super::{Context, Precision, counts};
use crate::formula::Formula;
use crate::free_name::take_free_name;
use crate::kinematics::{Applied, Kinematics};
use crate::program::Program;

/// The structs and the functions; nothing for a model that has no motions and forces beside its coordinates.
pub fn declare(context: &Context, precision: Precision) -> String {
    let Some((kinematics, program)) = find(context) else { return String::new() };
    let name = format!("{}_{}", context.prefix.lower(), precision.name());
    let members = kinematics
        .rates
        .iter()
        .zip(fields(kinematics))
        .map(|(rate, field)| format!("{}    {name}_rate_t {field};\n", block(&quoted(&rate.docs), 4)));
    let members: String = members.collect();
    let forces = match kinematics.applied.len() {
        0 => String::new(),
        count => {
            let what = kinematics
                .applied
                .iter()
                .map(|Applied { name, label, unit, .. }| format!("`{name}` ({label}) in {unit}"));
            let what: Vec<String> = what.collect();
            let docs = format!(
                "The forces f on the coordinates that applied forces make: a row for each coordinate, a column for each of\n\
                 {}.",
                quoted(&what.join(", "))
            );
            format!("{}    {} forces[{}][{count}];\n", block(&docs, 4), precision.number(), context.size)
        }
    };
    let what = block("Rates and forces that follow from the coordinates, to first order and in SI units.", 0);
    let does = block(
        &format!(
            "Rates and forces that follow from the coordinates, from one straight-line program:\n{}.\n\n@param[in] p The \
             parameters, which are not validated.\n@param[out] kinematics The rates and forces.",
            counts(program)
        ),
        0,
    );
    let rate = fill(include_str!("templates/rate.h"), &values(context, precision, &name, &precision.literal(0.0)));
    format!(
        "{rate}{what}typedef struct {{\n{members}{forces}}} {name}_kinematics_t;\n\n{does}{};\n\n",
        signature(context, precision)
    )
}

/// The functions.
pub fn define(context: &Context, precision: Precision) -> String {
    let Some((kinematics, program)) = find(context) else { return String::new() };
    let name = format!("{}_{}", context.prefix.lower(), precision.name());
    let body = context.body(program, precision, &[], &["kinematics"]);
    let rate = fill(include_str!("templates/rate.c"), &values(context, precision, &name, &precision.literal(0.0)));
    let reads = if body.reads_parameters() { "" } else { "    (void)p;\n" };
    format!(
        "{rate}\n{}\n{{\n{reads}{}{}}}\n",
        signature(context, precision),
        body.statements(4),
        assign(kinematics, program, &body)
    )
}

fn values<'a>(
    context: &'a Context,
    precision: Precision,
    name: &'a str,
    zero: &'a str,
) -> [(&'static str, &'a str); 4] {
    [("N", &context.size), ("name", name), ("number", precision.number()), ("zero", zero)]
}

fn find<'a>(context: &'a Context) -> Option<(&'a Kinematics<Formula>, &'a Program)> {
    let kinematics = context.model.kinematics.as_ref().filter(|kinematics| !kinematics.is_empty())?;
    Some((kinematics, context.programs.kinematics.as_ref()?))
}

fn signature(context: &Context, precision: Precision) -> String {
    let name = context.name(precision, "kinematics");
    format!("void {name}(const {} *p, {name}_t *kinematics)", context.parameters(precision))
}

/// A member for each rate; of two with one name the later one is set apart.
fn fields(kinematics: &Kinematics<Formula>) -> Vec<String> {
    let mut taken = HashSet::from(["forces".to_string()]);
    kinematics.rates.iter().map(|rate| take_free_name(&identifier(&rate.name), &mut taken)).collect()
}

fn assign(kinematics: &Kinematics<Formula>, program: &Program, body: &Body) -> String {
    let mut values = program.outputs.iter().map(|value| body.values[*value].clone());
    let mut next = || values.next().unwrap_or_else(|| unreachable!("a value for each formula"));
    let found = kinematics.map(|_| next());
    let mut text = String::new();
    let mut set = |member: String, value: &str| text.push_str(&wrap(&format!("kinematics->{member} = {value};"), 4));
    for (rate, field) in found.rates.iter().zip(fields(kinematics)) {
        set(format!("{field}.speed"), &rate.speed);
        for (list, of) in [("rates", &rate.rates), ("coordinates", &rate.coordinates)] {
            of.iter().enumerate().for_each(|(i, value)| set(format!("{field}.{list}[{i}]"), value));
        }
        set(format!("{field}.heading"), &rate.heading);
    }
    for (row, forces) in found.forces.iter().enumerate() {
        forces.iter().enumerate().for_each(|(column, force)| set(format!("forces[{row}][{column}]"), force));
    }
    text
}
