//! Transfer functions as JSON; its form is documented in `docs/control.md`, and stays.

use std::io::{Result, Write};

use carvallo::Complex;
use carvallo_control::{FrequencyResponse, GainMargin, PhaseMargin};
use serde::Serialize;

use crate::analysis::transfer::{Transfer, Transfers};
use crate::data::head::Head;
use crate::data::layout::{Line, Members, Parts, write_document};

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
    transfer_functions: Vec<Told<'a>>,
    /// Of all of them together; only where there are several.
    #[serde(skip_serializing_if = "Option::is_none")]
    transmission_zeros: Option<Line<Option<Vec<Parts>>>>,
    /// Where frequencies are asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    singular_values: Option<Vec<Line<Values<'a>>>>,
}

#[derive(Serialize)]
struct Values<'a> {
    frequency: f64,
    values: &'a [f64],
}

#[derive(Serialize)]
struct Told<'a> {
    input: &'a str,
    output: &'a str,
    unit: String,
    gain: f64,
    /// Nothing where a pole is zero.
    static_gain: Option<f64>,
    zeros: Line<Vec<Parts>>,
    poles: Line<Vec<Parts>>,
    cancelled: Line<Vec<Parts>>,
    numerator: Line<Vec<f64>>,
    denominator: Line<Vec<f64>>,
    gain_margins: Vec<Line<Gain>>,
    phase_margins: Vec<Line<Phase>>,
    closed_loop: String,
    /// Where it is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    frequency_response: Option<Vec<Line<Point>>>,
}

#[derive(Serialize)]
struct Gain {
    frequency: f64,
    factor: f64,
}

#[derive(Serialize)]
struct Phase {
    frequency: f64,
    angle: f64,
}

/// Nothing for the gain at a pole on the imaginary axis.
#[derive(Serialize)]
struct Point {
    frequency: f64,
    gain: Option<f64>,
    phase: Option<f64>,
}

/// With the frequency responses, if they are asked for.
///
/// # Errors
/// If it cannot be written.
pub fn write_json(transfers: &Transfers, responses: bool, output: &mut dyn Write) -> Result<()> {
    let design = transfers.design;
    let parameters = design.info().parameters.iter().zip(&design.parameters);
    let document = Document {
        head: Head::of(design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        speed: transfers.space.shown_speed(),
        speed_unit: (!transfers.space.speed_unit.is_declared()).then_some(transfers.space.speed_unit.written.as_str()),
        transfer_functions: transfers.channels.iter().map(|channel| told(channel, responses)).collect(),
        transmission_zeros: transfers.are_several().then(|| {
            let zeros = transfers.transmission_zeros.as_ref();
            Line(zeros.map(|zeros| zeros.iter().copied().map(Parts::from).collect()))
        }),
        singular_values: (transfers.are_several() && responses).then(|| {
            let values = transfers.singular_values.iter();
            values.map(|at| Line(Values { frequency: at.frequency, values: &at.values })).collect()
        }),
    };
    write_document(&document, output)
}

fn told(channel: &Transfer, responses: bool) -> Told<'_> {
    let Transfer { function, margins, response } = channel;
    let parts = |roots: &[Complex<f64>]| Line(roots.iter().copied().map(Parts::from).collect());
    let finite = |value: f64| value.is_finite().then_some(value);
    let point = |&FrequencyResponse { frequency, gain, phase }: &FrequencyResponse| {
        Line(Point { frequency, gain: finite(gain), phase: finite(phase) })
    };
    Told {
        input: &function.input.name,
        output: &function.output.name,
        unit: channel.unit(),
        gain: function.gain,
        static_gain: function.static_gain(),
        zeros: parts(&function.zeros),
        poles: parts(&function.poles),
        cancelled: parts(&function.cancelled()),
        numerator: Line(function.numerator()),
        denominator: Line(function.denominator()),
        gain_margins: margins
            .gain
            .iter()
            .map(|&GainMargin { frequency, factor }| Line(Gain { frequency, factor }))
            .collect(),
        phase_margins: margins
            .phase
            .iter()
            .map(|&PhaseMargin { frequency, angle }| Line(Phase { frequency, angle }))
            .collect(),
        closed_loop: margins.closed_loop.to_string(),
        frequency_response: responses.then(|| response.iter().map(point).collect()),
    }
}
