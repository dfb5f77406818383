//! Stability along a parameter as JSON; its form is documented in `docs/json.md`, and stays.

use std::io::{Result, Write};

use carvallo::ParameterRange;
use serde::Serialize;

use crate::analysis::along::{AlongAnalysis, AtValue};
use crate::data::head::Head;
use crate::data::layout::{Line, Members, Parts, write_document};

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    parameters: Members<Line<f64>>,
    along: Line<Parameter<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    speed_unit: Option<&'a str>,
    speed: Option<f64>,
    range: Line<[f64; 2]>,
    critical_values: Vec<Line<Event>>,
    stable_ranges: Vec<Line<[f64; 2]>>,
    undecided_ranges: Vec<Line<[f64; 2]>>,
    eigenvalues: Vec<Line<Row>>,
}

#[derive(Serialize)]
struct Parameter<'a> {
    name: &'static str,
    unit: &'a str,
}

/// A critical value.
#[derive(Serialize)]
struct Event {
    kind: &'static str,
    value: f64,
    error: f64,
    eigenvalue: Parts,
    change: String,
    /// Just below and just above the value.
    verdicts: [String; 2],
}

#[derive(Serialize)]
struct Row {
    value: f64,
    verdict: String,
    values: Vec<Parts>,
}

/// # Errors
/// If it cannot be written.
pub fn write_json(analysis: &AlongAnalysis, rows: &[AtValue], output: &mut dyn Write) -> Result<()> {
    let AlongAnalysis { design, parameter, speed, range, stability, unit, speed_unit, .. } = analysis;
    let parameters = design.info().parameters.iter().zip(&design.parameters);
    let ranges = |ranges: &[ParameterRange]| {
        ranges.iter().map(|ParameterRange { from, to }| Line([*from, *to].map(|end| analysis.shown(end)))).collect()
    };
    let events = stability.critical_values.iter().map(|critical| Event {
        kind: analysis.name(critical),
        value: analysis.shown(critical.value),
        error: unit.value(critical.error),
        eigenvalue: critical.eigenvalue.into(),
        change: critical.change.to_string(),
        verdicts: stability.verdicts_around(critical).map(|verdict| verdict.to_string()),
    });
    let rows = rows.iter().map(|row| Row {
        value: analysis.shown(row.value),
        verdict: row.verdict.to_string(),
        values: row.eigenvalues.iter().copied().map(Parts::from).collect(),
    });
    let document = Document {
        head: Head::of(design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        along: Line(Parameter { name: parameter.name, unit: &unit.written }),
        speed_unit: (!speed_unit.is_declared()).then_some(speed_unit.written.as_str()),
        speed: speed.map(|speed| speed_unit.value(speed)),
        range: Line(range.map(|end| analysis.shown(end))),
        critical_values: events.map(Line).collect(),
        stable_ranges: ranges(&stability.stable_ranges),
        undecided_ranges: ranges(&stability.undecided),
        eigenvalues: rows.map(Line).collect(),
    };
    write_document(&document, output)
}
