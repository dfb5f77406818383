//! A state space as JSON; its form is documented in `docs/control.md`, and stays.

use std::io::{Result, Write};

use carvallo::nalgebra::DMatrix;
use carvallo_control::StateSpace;
use carvallo_design::Design;
use serde::Serialize;

use crate::data::head::Head;
use crate::data::layout::{Line, Members, write_document};
use crate::data::signals::Told;

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    parameters: Members<Line<f64>>,
    /// Nothing where the equations do not depend on it.
    speed: Option<f64>,
    /// Where that is not m/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    speed_unit: Option<&'a str>,
    states: Vec<Line<Told<'a>>>,
    inputs: Vec<Line<Told<'a>>>,
    outputs: Vec<Line<Told<'a>>>,
    #[serde(rename = "A")]
    a: Line<Rows>,
    #[serde(rename = "B")]
    b: Line<Rows>,
    #[serde(rename = "C")]
    c: Line<Rows>,
    #[serde(rename = "D")]
    d: Line<Rows>,
}

type Rows = Vec<Vec<f64>>;

/// # Errors
/// If it cannot be written.
pub fn write_json(design: &Design, space: &StateSpace, output: &mut dyn Write) -> Result<()> {
    let parameters = design.info().parameters.iter().zip(&design.parameters);
    let rows = |matrix: &DMatrix<f64>| Line(matrix.row_iter().map(|row| row.iter().copied().collect()).collect());
    let document = Document {
        head: Head::of(design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        speed: space.shown_speed(),
        speed_unit: (!space.speed_unit.is_declared()).then_some(space.speed_unit.written.as_str()),
        states: Told::all(&space.states),
        inputs: Told::all(&space.inputs),
        outputs: Told::all(&space.outputs),
        a: rows(&space.a),
        b: rows(&space.b),
        c: rows(&space.c),
        d: rows(&space.d),
    };
    write_document(&document, output)
}
