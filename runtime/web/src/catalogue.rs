//! What ships, for lists and for the labels of parameters.

use carvallo::{Bound, ModelInfo, ParameterInfo};
use carvallo_design::number::unit;
use carvallo_design::{MODELS, Shipped, input};
use serde::Serialize;

/// A model with its parameters and sets.
#[derive(Serialize)]
pub struct Model {
    name: &'static str,
    /// What it is, in a sentence.
    about: String,
    parameters: Vec<Parameter>,
    sets: Vec<Set>,
    moves: bool,
}

#[derive(Serialize)]
struct Set {
    name: &'static str,
    kind: Option<String>,
}

/// A parameter as people read it.
#[derive(Serialize)]
pub struct Parameter {
    name: &'static str,
    symbol: &'static str,
    about: &'static str,
    unit: String,
    /// The values that it must have, as the end of a sentence.
    required: String,
    /// The ends of its domain.
    bounds: [Option<f64>; 2],
    used: bool,
}

/// All models.
pub fn catalogue() -> Vec<Model> {
    let models = MODELS.iter().filter(|model| !input::names(model).is_empty());
    models.map(model).collect()
}

fn model(model: &Shipped) -> Model {
    let info = model.info;
    let set = |name: &&'static str| Set { name, kind: input::kind(model, name) };
    Model {
        name: info.name,
        about: first_sentence(info.docs),
        parameters: parameters(info),
        sets: input::names(model).iter().map(set).collect(),
        moves: model.depends_on_speed(),
    }
}

/// The parameters of a model.
pub fn parameters(info: &'static ModelInfo) -> Vec<Parameter> {
    info.parameters.iter().map(parameter).collect()
}

fn parameter(info: &'static ParameterInfo) -> Parameter {
    let bound = |bound: Bound| match bound {
        Bound::Unbounded => None,
        Bound::Open(value) | Bound::Closed(value) => Some(value),
    };
    Parameter {
        name: info.name,
        symbol: info.symbol,
        about: info.docs.trim(),
        unit: unit(info.unit),
        required: info.domain.to_string(),
        bounds: [bound(info.domain.lower), bound(info.domain.upper)],
        used: info.used,
    }
}

fn first_sentence(docs: &str) -> String {
    let paragraph = docs.trim().split("\n\n").next().unwrap_or_default();
    let text = paragraph.split_whitespace().collect::<Vec<_>>().join(" ");
    text.split_once(". ").map_or(text.clone(), |(first, _)| format!("{first}."))
}
