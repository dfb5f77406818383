//! Modal measures as JSON; its form is documented in `docs/control.md`, and stays.

use std::io::{Result, Write};

use serde::Serialize;

use crate::analysis::controllability::{AtSpeed, Controllability, LostTo};
use crate::data::head::Head;
use crate::data::layout::{Line, Members, write_document};
use crate::data::signals::{Named, Told};

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    parameters: Members<Line<f64>>,
    /// Where speeds are not in m/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    speed_unit: Option<&'a str>,
    inputs: Vec<Line<Told<'a>>>,
    outputs: Vec<Line<Told<'a>>>,
    lost: Vec<Line<LostMode<'a>>>,
    rows: Vec<Line<OneMode<'a>>>,
}

/// By its name an input or an output.
#[derive(Serialize)]
struct LostMode<'a> {
    #[serde(skip_serializing_if = "Option::is_none")]
    input: Option<&'a str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    output: Option<&'a str>,
    speed: f64,
    re: f64,
    im: f64,
}

#[derive(Serialize)]
struct OneMode<'a> {
    /// Nothing where nothing depends on it.
    speed: Option<f64>,
    mode: String,
    re: f64,
    im: f64,
    controllability: Named<'a>,
    observability: Named<'a>,
}

/// # Errors
/// If it cannot be written.
pub fn write_json(
    controllability: &Controllability,
    lost: &[LostTo],
    rows: &[AtSpeed],
    output: &mut dyn Write,
) -> Result<()> {
    let Controllability { analysis, inputs, outputs, .. } = controllability;
    let design = &analysis.design;
    let parameters = design.info().parameters.iter().zip(&design.parameters);
    let unit = &controllability.analysis.unit;
    let moves = design.model.depends_on_speed();
    let modes = rows.iter().flat_map(|row| {
        row.modes.iter().map(move |(mode, measures)| {
            Line(OneMode {
                speed: moves.then(|| unit.value(row.speed)),
                mode: mode.mode.to_string(),
                re: mode.value.re,
                im: mode.value.im,
                controllability: Named::new(inputs, measures.controllability.iter().copied()),
                observability: Named::new(outputs, measures.observability.iter().copied()),
            })
        })
    });
    let each = lost.iter().flat_map(|of| {
        let name = |is_wanted: bool| is_wanted.then_some(of.name.as_str());
        of.lost.iter().map(move |lost| {
            let (input, output) = (name(of.is_input), name(!of.is_input));
            Line(LostMode {
                input,
                output,
                speed: unit.value(lost.speed),
                re: lost.eigenvalue.re,
                im: lost.eigenvalue.im,
            })
        })
    });
    let document = Document {
        head: Head::of(design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        speed_unit: (!unit.is_declared()).then_some(unit.written.as_str()),
        inputs: Told::all(inputs),
        outputs: Told::all(outputs),
        lost: each.collect(),
        rows: modes.collect(),
    };
    write_document(&document, output)
}
