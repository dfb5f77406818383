//! Stability along a parameter: for people, as JSON, and as comma-separated values.

use std::fmt::Write as _;
use std::io::{Result, Write};

use carvallo::{Complex, CriticalKind, ParameterRange, Verdict};
use serde::Serialize;

use super::cells::{exact, write_rows};
use super::columns::width;
use super::head::Head;
use super::layout::{Line, Members, Parts, write_document};
use super::table::{effect, write_heading};
use super::{FAINT, GOOD, HEADING};
use crate::along::{AlongAnalysis, AtValue};
use crate::number::{fixed, shortest, unit, with_unit};

/// Writing to a string cannot fail, so that the results of `write!` are dropped throughout.
pub fn render_along(analysis: &AlongAnalysis, rows: &[AtValue]) -> String {
    let AlongAnalysis { design, parameter, speed, range, stability, .. } = analysis;
    let (name, in_unit) = (parameter.name, |value: f64| with_unit(value, parameter.unit));
    let mut text = String::new();
    write_heading(design, &mut text);
    let at = speed.map(|speed| format!(", at {} m/s", shortest(speed))).unwrap_or_default();
    let _ = writeln!(text, "\nAlong {name} from {} to {}{at}", in_unit(range[0]), in_unit(range[1]));
    let of = match unit(parameter.unit) {
        unit if unit.is_empty() => String::new(),
        unit => format!(" ({unit})"),
    };
    let _ = writeln!(text, "\n{HEADING}Critical values of {name}{HEADING:#}{of}");
    let values: Vec<String> = stability.critical_values.iter().map(|critical| shortest(critical.value)).collect();
    let columns = width(&values, 20);
    for (critical, value) in stability.critical_values.iter().zip(&values) {
        let at = match critical.kind {
            CriticalKind::Capsize => "0".to_owned(),
            _ => format!("±{} i", fixed(critical.eigenvalue.im, 4)),
        };
        let change = effect(critical.change, stability.verdicts_around(critical));
        let kind = analysis.name(critical).replace('_', " ");
        let _ = writeln!(text, "  {kind:<13}{value:<columns$}{FAINT}{change}, at λ = {at}{FAINT:#}");
    }
    if values.is_empty() {
        let _ = writeln!(text, "  none");
    }
    for ParameterRange { from, to } in &stability.undecided {
        let (from, to) = (shortest(*from), in_unit(*to));
        let _ = writeln!(text, "  from {from} to {to} one may be missing: rounding decides there");
    }
    for ParameterRange { from, to } in &stability.stable_ranges {
        let _ = writeln!(text, "  {GOOD}stable from {} to {}{GOOD:#}", shortest(*from), in_unit(*to));
    }
    if stability.stable_ranges.is_empty() {
        let _ = writeln!(text, "  stable at no value");
    }
    let _ = writeln!(text, "\n{HEADING}Eigenvalues{HEADING:#} (1/s)");
    let title = format!("{name}{of}");
    let values: Vec<String> = rows.iter().map(|row| shortest(row.value)).collect();
    let first = width(values.iter().chain([&title]), 9);
    let _ = writeln!(text, "{FAINT}{title:>first$}{FAINT:#}");
    for (row, value) in rows.iter().zip(&values) {
        let style = if row.verdict == Verdict::Stable { GOOD } else { anstyle::Style::new() };
        let entries = row.eigenvalues.iter().filter(|value| value.im <= 0.0).map(entry);
        let entries = entries.collect::<Vec<_>>().join(", ");
        let _ = writeln!(text, "{style}{value:>first$}  {:<9} {entries}{style:#}", row.verdict.to_string());
    }
    text
}

/// Pairs stand where their half with the negative imaginary part does.
fn entry(value: &Complex<f64>) -> String {
    let re = fixed(value.re, 4);
    if value.im < 0.0 { format!("{re} ± {} i", fixed(-value.im, 4)) } else { re }
}

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
pub fn write_along_json(analysis: &AlongAnalysis, rows: &[AtValue], output: &mut dyn Write) -> Result<()> {
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

/// One row a value, under a header with the units.
///
/// # Errors
/// If it cannot be written.
pub fn write_along_csv(analysis: &AlongAnalysis, rows: &[AtValue], output: &mut dyn Write) -> Result<()> {
    let info = analysis.parameter;
    let numbers = 1..=rows.first().map_or(0, |row| row.eigenvalues.len());
    let names = numbers.flat_map(|k| [format!("eigenvalue {k} re (1/s)"), format!("eigenvalue {k} im (1/s)")]);
    let header = [format!("{} ({})", info.name, info.unit)].into_iter().chain(names).chain(["verdict".to_owned()]);
    let lines = rows.iter().map(|row| {
        let values = row.eigenvalues.iter().flat_map(|value| [exact(value.re), exact(value.im)]);
        [exact(row.value)].into_iter().chain(values).chain([row.verdict.to_string()]).collect()
    });
    write_rows([header.collect()].into_iter().chain(lines), output)
}
