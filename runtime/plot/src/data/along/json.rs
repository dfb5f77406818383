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
    along: Line<Parameter>,
    speed: Option<f64>,
    range: Line<[f64; 2]>,
    critical_values: Vec<Line<Event>>,
    stable_ranges: Vec<Line<[f64; 2]>>,
    undecided_ranges: Vec<Line<[f64; 2]>>,
    eigenvalues: Vec<Line<Row>>,
}

#[derive(Serialize)]
struct Parameter {
    name: &'static str,
    unit: &'static str,
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
    let AlongAnalysis { design, parameter, speed, range, stability, .. } = analysis;
    let parameters = design.info().parameters.iter().zip(&design.parameters);
    let ranges =
        |ranges: &[ParameterRange]| ranges.iter().map(|ParameterRange { from, to }| Line([*from, *to])).collect();
    let events = stability.critical_values.iter().map(|critical| Event {
        kind: analysis.name(critical),
        value: critical.value,
        error: critical.error,
        eigenvalue: critical.eigenvalue.into(),
        change: critical.change.to_string(),
        verdicts: stability.verdicts_around(critical).map(|verdict| verdict.to_string()),
    });
    let rows = rows.iter().map(|row| Row {
        value: row.value,
        verdict: row.verdict.to_string(),
        values: row.eigenvalues.iter().copied().map(Parts::from).collect(),
    });
    let document = Document {
        head: Head::of(design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        along: Line(Parameter { name: parameter.name, unit: parameter.unit }),
        speed: *speed,
        range: Line(*range),
        critical_values: events.map(Line).collect(),
        stable_ranges: ranges(&stability.stable_ranges),
        undecided_ranges: ranges(&stability.undecided),
        eigenvalues: rows.map(Line).collect(),
    };
    write_document(&document, output)
}
