//! What is written above the parameters of a model and above its parameter sets, for the pages of its documentation.

use super::or;
use crate::domain::Domain;
use crate::formula::Decimal;
use crate::model::{Feedback, Model, Origin, Parameter, ParameterSet, Requirement};
use crate::states::States;

/// The text of the declaration, then where the model comes from, its coordinates and its requirements.
pub fn model_docs(model: &Model) -> String {
    let mut text = or(&model.docs, &format!("The model `{}`.", model.name)).to_string();
    if !model.source.is_empty() {
        text.push_str(&format!("\n\nSource: {}", model.source));
    }
    if let Some(kinematics) = &model.kinematics {
        text.push_str(&format!("\n\nDerived from a mechanism: {}.", kinematics.parts.join(", ")));
    }
    let coordinates = model.coordinates.iter().map(|coordinate| {
        let label =
            if coordinate.label == coordinate.name { String::new() } else { format!(" ({})", coordinate.label) };
        let only = match coordinate.states {
            States::Both => "",
            States::Position => ", of first order: only its position is a state",
            States::Rate => ", of which only the rate is a state",
        };
        format!("`{}`{label} in `{}`{only}", coordinate.name, coordinate.unit)
    });
    let coordinates: Vec<String> = coordinates.collect();
    let has_only = model.coordinates.iter().any(|coordinate| coordinate.states != States::Both);
    text.push_str(&format!(
        "\n\nThe fields are the parameters. The coordinates are {}.",
        coordinates.join(if has_only { "; " } else { ", " })
    ));
    if !model.feedback.is_empty() {
        let feedback: Vec<String> = model.feedback.iter().map(feedback_docs).collect();
        text.push_str(&format!("\n\nIn the matrices is what follows from the motion:\n\n{}.", feedback.join(";\n")));
    }
    if !model.requirements.is_empty() {
        text.push_str("\n\nBeside what is said of each field, `validate` requires of them:\n\n");
        let requirements: Vec<String> = model.requirements.iter().map(requirement_docs).collect();
        text.push_str(&requirements.join(";\n"));
        text.push('.');
    }
    text.push_str(&equations(model));
    text
}

/// The formulas, folded.
fn equations(model: &Model) -> String {
    if model.formulas.is_empty() {
        return String::new();
    }
    let legend = match model.kinematics {
        Some(_) => DERIVED,
        None => "",
    };
    let formulas: Vec<String> = model.formulas.iter().map(ToString::to_string).collect();
    format!(
        "\n\n<details><summary>The formulas of its matrices</summary>\n\n{legend}```text\n{}\n```\n\n</details>",
        formulas.join("\n")
    )
}

/// What the names mean that derivations make.
const DERIVED: &str = "\
A name has behind it the joint that it belongs to, or `all` for the whole machine. `m` is the mass that the
joint moves, `S` its static moment and `J` its inertia about the point of the joint; `p` and `h` are the
momentum and the angular momentum at unit rate, `h_spin` is the spin momentum of a wheel divided by the speed,
and `load` the steady force of the ground on it along z, divided by gravity. `M` and `K` are entries of the
matrices of all joints, `P` and `W` of those projected on the motions that the wheels leave free, `a_by_b` is
the rate of a for that of b, and `a_per_v_b` that for the position of b, divided by the speed.

";

/// The item of a list.
fn feedback_docs(Feedback { name, label, on, unit, law }: &Feedback) -> String {
    let label = if label == name { String::new() } else { format!(" ({label})") };
    let unit = unit.map(|unit| format!(" in `{unit}`")).unwrap_or_default();
    format!("- `{name}`{label}{unit} on `{on}`: `{law}`")
}

/// The item of a list.
fn requirement_docs(Requirement { text, unit, domain, origin, .. }: &Requirement) -> String {
    let unit = if matches!(&**unit, "" | "1") { String::new() } else { format!(" in `{unit}`") };
    let why = match (origin, domain.nonzero) {
        (Origin::Declared, _) => "",
        (Origin::Matrices, true) => ", since the matrices divide by it",
        (Origin::Matrices, false) => ", since the matrices take its root",
        (Origin::Requirements, true) => ", since a requirement divides by it",
        (Origin::Requirements, false) => ", since a requirement takes its root",
        (Origin::Mechanism(what), _) => &format!(", as {what}"),
    };
    format!("- `{text}`{unit}: {}{why}", bounds(domain))
}

/// The text of the declaration, then symbol, unit and domain.
pub fn parameter_docs(parameter: &Parameter) -> String {
    let name = parameter.name.to_string();
    let unit = if parameter.unit == "1" { "a pure number".to_string() } else { format!("in `{}`", parameter.unit) };
    let mut facts = format!("`{name}`");
    if parameter.symbol != name {
        facts.push_str(&format!(", {},", parameter.symbol));
    }
    facts.push_str(&format!(" {unit}: {}.", bounds(&parameter.domain)));
    if !parameter.used {
        facts.push_str(" No matrix depends on it.");
    }
    if parameter.docs.is_empty() { facts } else { format!("{}\n\n{facts}", parameter.docs) }
}

/// A domain, with signs that Markdown leaves alone.
fn bounds(domain: &Domain) -> String {
    let text = domain.to_string();
    if text.starts_with(['<', '>']) { format!("`{text}`") } else { text }
}

/// The text of the declaration, then the source and the values.
pub fn set_docs(set: &ParameterSet, model: &Model) -> String {
    let mut text = or(&set.docs, &format!("The parameter set `{}`.", set.name)).to_string();
    if !set.source.is_empty() {
        text.push_str(&format!("\n\nSource: {}", set.source));
    }
    if set.is_default {
        text.push_str("\n\nIt is the default.");
    }
    text.push_str("\n\n| parameter | value | unit |\n| --- | ---: | --- |");
    for (Parameter { name, unit, .. }, value) in model.parameters.iter().zip(&set.values) {
        let sign = if *value < 0.0 { "-" } else { "" };
        let unit = if unit == "1" { String::new() } else { format!("`{unit}`") };
        text.push_str(&format!("\n| `{name}` | {sign}{} | {unit} |", Decimal::nearest(value.abs())));
    }
    text
}
