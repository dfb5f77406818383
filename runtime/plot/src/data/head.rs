//! What every JSON output begins with.

use carvallo::{CoordinateInfo, States};
use carvallo_design::Design;
use carvallo_design::matrices::NAME;
use serde::Serialize;

use super::layout::Line;

/// The model, and what the design is called.
#[derive(Serialize)]
pub struct Head<'a> {
    model: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    bicycle: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<&'a str>,
    /// The laws of feedback.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    feedback: Vec<&'a str>,
    /// Of given matrices, so that the output is such a file, too.
    #[serde(skip_serializing_if = "Option::is_none")]
    coordinates: Option<Vec<Line<Coordinate>>>,
}

/// A coordinate of given matrices.
#[derive(Serialize)]
struct Coordinate {
    name: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    only: Option<&'static str>,
}

impl<'a> Head<'a> {
    pub fn of(design: &'a Design) -> Self {
        let is_bicycle = design.model.is_whipple();
        let name = design.name.as_str();
        let info = design.info();
        Self {
            model: info.name,
            bicycle: is_bicycle.then_some(name),
            name: (!is_bicycle).then_some(name),
            feedback: design.feedback.iter().map(|law| law.written.as_str()).collect(),
            coordinates: (info.name == NAME).then(|| info.coordinates.iter().map(coordinate).map(Line).collect()),
        }
    }
}

fn coordinate(CoordinateInfo { name, states, .. }: &CoordinateInfo) -> Coordinate {
    let only = match states {
        States::Both => None,
        States::Position => Some("position"),
        States::Rate => Some("rate"),
    };
    Coordinate { name, only }
}
