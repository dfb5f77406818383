//! A response as JSON; its form is documented in `docs/control.md`, and stays.

use std::io::{Result, Write};

use serde::Serialize;

use crate::analysis::excitation::Excitation;
use crate::analysis::response::Responses;
use crate::data::head::Head;
use crate::data::layout::{Line, Members, write_document};
use crate::data::signals::{Named, Told};

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
    excitation: Line<To<'a>>,
    outputs: Vec<Line<Told<'a>>>,
    /// Why it ended before its time, if it did.
    #[serde(skip_serializing_if = "Option::is_none")]
    end: Option<&'a str>,
    rows: Vec<Line<AtTime<'a>>>,
}

#[derive(Serialize)]
#[serde(rename_all = "snake_case")]
enum To<'a> {
    Step { input: &'a str, size: f64 },
    Impulse { input: &'a str, size: f64 },
    Initial(Named<'a>),
}

#[derive(Serialize)]
struct AtTime<'a> {
    t: f64,
    outputs: Named<'a>,
}

/// # Errors
/// If it cannot be written.
pub fn write_json(responses: &Responses, output: &mut dyn Write) -> Result<()> {
    let Responses { design, space, excitation, response, end } = responses;
    let parameters = design.info().parameters.iter().zip(&design.parameters);
    let name = |input: &usize| space.inputs[*input].name.as_str();
    let excitation = match excitation {
        Excitation::Step { input, size } => To::Step { input: name(input), size: *size },
        Excitation::Impulse { input, size } => To::Impulse { input: name(input), size: *size },
        Excitation::Initial(state) => To::Initial(Named::new(&space.states, state.iter().copied())),
    };
    let row = |(time, values): (&f64, &Vec<f64>)| {
        // Adding zero turns -0 into 0.
        let outputs = Named::new(&space.outputs, values.iter().map(|value| value + 0.0));
        Line(AtTime { t: *time, outputs })
    };
    let document = Document {
        head: Head::of(design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        speed: space.shown_speed(),
        speed_unit: (!space.speed_unit.is_declared()).then_some(space.speed_unit.written.as_str()),
        excitation: Line(excitation),
        outputs: Told::all(&space.outputs),
        end: end.as_deref(),
        rows: response.times.iter().zip(&response.outputs).map(row).collect(),
    };
    write_document(&document, output)
}
