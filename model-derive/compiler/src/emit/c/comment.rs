//! Comments for Doxygen.

use super::super::or;
use crate::domain::Domain;
use crate::model::{Coordinate, Model, Origin, Parameter, ParameterSet, Requirement};
use crate::states::States;

/// Comments of one line go up to this column.
const WIDTH: usize = 110;

/// A block of documentation before what it is about, with so many spaces before each line.
pub fn block(text: &str, indent: usize) -> String {
    let space = " ".repeat(indent);
    let text = harmless(text);
    if !text.contains('\n') && indent + text.len() < WIDTH {
        return format!("{space}/** {text} */\n");
    }
    let mut comment = format!("{space}/**\n");
    for line in text.lines() {
        comment.push_str(format!("{space} * {line}").trim_end());
        comment.push('\n');
    }
    comment.push_str(&format!("{space} */\n"));
    comment
}

/// A text of a user's as a comment may have it: it ends no comment, begins none, and has no commands of Doxygen.
pub fn quoted(text: &str) -> String {
    text.replace('\\', "\\\\").replace('@', "@@")
}

/// What would end a comment, begin another or is a sign of an old keyboard, with a space in it.
fn harmless(text: &str) -> String {
    let mut harmless = text.to_string();
    for (signs, apart) in [("*/", "* /"), ("/*", "/ *"), ("//", "/ /"), ("??", "? ?")] {
        while harmless.contains(signs) {
            harmless = harmless.replace(signs, apart);
        }
    }
    harmless
}

/// A unit behind what has it; nothing for pure numbers.
pub fn in_unit(unit: &str) -> String {
    if matches!(unit, "" | "1") { String::new() } else { format!(" in {unit}") }
}

/// What a model is: the text of its declaration, its source, its equations and its coordinates.
pub fn of_model(model: &Model) -> String {
    let mut text = quoted(or(&model.docs, &format!("The model `{}`.", model.name)));
    if !model.source.is_empty() {
        text.push_str(&format!("\n\nSource: {}", quoted(&model.source)));
    }
    if let Some(kinematics) = &model.kinematics {
        text.push_str(&format!("\n\nDerived from a mechanism: {}.", kinematics.parts.join(", ")));
    }
    text.push_str(
        "\n\nThe linearized equations of motion at the forward speed v in m/s and gravity g in N/kg are\n\n    \
         M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f\n\nwith the generalized forces f and the \
         coordinates q, in the order of rows and columns:\n\n",
    );
    let coordinates: Vec<String> = model.coordinates.iter().map(of_coordinate).collect();
    text.push_str(&coordinates.join("\n"));
    text
}

fn of_coordinate(Coordinate { name, label, states, docs, unit }: &Coordinate) -> String {
    let label = if label == name { String::new() } else { format!(" ({label})") };
    let only = match states {
        States::Both => "",
        States::Position => "; of first order: only its position is a state",
        States::Rate => "; only its rate is a state",
    };
    let docs = if docs.is_empty() { String::new() } else { format!(": {}", quoted(docs).replace('\n', "\n  ")) };
    format!("- `{name}`{label}{}{only}{docs}", in_unit(unit))
}

/// What a parameter is, in which unit, and which values it may have.
pub fn of_parameter(parameter: &Parameter) -> String {
    let Parameter { symbol, docs, unit, domain, used, .. } = parameter;
    let name = parameter.name.to_string();
    let symbol = if *symbol == name { String::new() } else { format!(" {}", quoted(symbol)) };
    let docs = if docs.is_empty() { String::new() } else { format!("{} ", quoted(docs)) };
    let unit = if unit == "1" { "a pure number".to_string() } else { format!("in {unit}") };
    let unused = if *used { "" } else { " No matrix depends on it." };
    format!("{docs}`{name}`{symbol}, {unit}: {domain}.{unused}")
}

/// What is required of several parameters, and why.
pub fn of_requirement(Requirement { text, unit, domain, origin, .. }: &Requirement) -> String {
    let why = match (origin, domain.nonzero) {
        (Origin::Declared, _) => "",
        (Origin::Matrices, true) => ", since the matrices divide by it",
        (Origin::Matrices, false) => ", since the matrices take its root",
        (Origin::Requirements, true) => ", since a requirement divides by it",
        (Origin::Requirements, false) => ", since a requirement takes its root",
        (Origin::Mechanism(what), _) => &format!(", as {what}"),
    };
    format!("`{text}`{} must be {}{why}.", in_unit(unit), required(*domain))
}

/// What a value must be, as the end of a sentence.
pub fn required(domain: Domain) -> String {
    match domain.to_string() {
        text if text.starts_with("any") => "finite".to_string(),
        text => format!("finite and {text}"),
    }
}

/// What a parameter set is and where it comes from.
pub fn of_set(set: &ParameterSet) -> String {
    let mut text = quoted(or(&set.docs, &format!("The parameter set `{}`.", set.name)));
    if !set.source.is_empty() {
        text.push_str(&format!("\n\nSource: {}", quoted(&set.source)));
    }
    text
}
