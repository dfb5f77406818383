//! Scheduled gains as JSON; its form is documented in `docs/control.md`, and stays.

use std::io::{Result, Write};

use carvallo::nalgebra::DMatrix;
use carvallo_control::{Ports, Regulator, Schedule, Weights};
use carvallo_design::Design;
use serde::Serialize;

use crate::data::head::Head;
use crate::data::layout::{Line, Members, Parts, write_document};
use crate::data::signals::Told;

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    parameters: Members<Line<f64>>,
    /// Where that is not m/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    speed_unit: Option<&'a str>,
    states: Vec<Line<Told<'a>>>,
    inputs: Vec<Line<Told<'a>>>,
    weights: Vec<Line<Weight>>,
    regulators: Vec<Line<Gains>>,
    unstable_between: Vec<Line<[f64; 2]>>,
}

#[derive(Serialize)]
struct Weight {
    of: String,
    value: f64,
}

#[derive(Serialize)]
struct Gains {
    /// Nothing where the equations do not depend on it.
    speed: Option<f64>,
    gains: Vec<Vec<f64>>,
    /// By parameter, where they are asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    sensitivities: Option<Members<Vec<Vec<f64>>>>,
    eigenvalues: Vec<Parts>,
    residual: f64,
}

/// With the derivatives of the gains of each regulator by parameter, if they are given.
///
/// # Errors
/// If it cannot be written.
pub fn write_json(
    design: &Design,
    schedule: &Schedule,
    weights: &Weights,
    sensitivities: Option<&[Vec<DMatrix<f64>>]>,
    output: &mut dyn Write,
) -> Result<()> {
    let (ports, space) = (Ports::of(design), &schedule.regulators[0].space);
    let of_outputs = weights.outputs.iter().map(|(output, value)| (ports.signal(*output).name, *value));
    let of_inputs = weights.inputs.iter().map(|(input, value)| (ports.inputs[*input].name.clone(), *value));
    let parameters = design.info().parameters.iter().zip(&design.parameters);
    let rows = |matrix: &DMatrix<f64>| -> Vec<Vec<f64>> {
        matrix.row_iter().map(|row| row.iter().map(|entry| entry + 0.0).collect()).collect()
    };
    let names = || design.info().parameters.iter().map(|parameter| parameter.name);
    let gains = |(place, own): (usize, &Regulator)| Gains {
        speed: own.space.shown_speed(),
        gains: rows(&own.gains),
        sensitivities: sensitivities.map(|of| Members(names().zip(of[place].iter().map(rows)).collect())),
        eigenvalues: own.eigenvalues.iter().copied().map(Parts::from).collect(),
        residual: own.residual,
    };
    let document = Document {
        head: Head::of(design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        speed_unit: (!space.speed_unit.is_declared()).then_some(space.speed_unit.written.as_str()),
        states: Told::all(&space.states),
        inputs: Told::all(&space.inputs),
        weights: of_outputs.chain(of_inputs).map(|(of, value)| Line(Weight { of, value })).collect(),
        regulators: schedule.regulators.iter().enumerate().map(gains).map(Line).collect(),
        unstable_between: schedule
            .unstable
            .iter()
            .map(|pair| Line(pair.map(|speed| space.speed_unit.value(speed))))
            .collect(),
    };
    write_document(&document, output)
}
