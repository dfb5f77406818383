//! A design along speed: its parameters, critical speeds and stable ranges, and the curves of its eigenvalues.

use carvallo::Mode;
use carvallo_design::number::shortest;
use carvallo_design::{Design, Failure};
use carvallo_plot::analysis::{Analysis, Rows, name};
use carvallo_plot::picture::{Color, Paint, Panel, Series, panels, samples};
use serde::Serialize;

use crate::catalogue::{Parameter, parameters};

/// What is known of a design.
#[derive(Serialize)]
pub struct Known {
    title: String,
    model: &'static str,
    kind: Option<String>,
    source: Option<String>,
    /// Those of the model, where that does not ship; matrices have a model of their own.
    parameters: Option<Vec<Parameter>>,
    values: Vec<f64>,
    written: Vec<String>,
    /// The names of the coordinates.
    coordinates: Vec<&'static str>,
    /// The laws of feedback, as they were written.
    feedback: Vec<String>,
    notes: Vec<String>,
    warnings: Vec<String>,
    /// Whether anything depends on the speed.
    moves: bool,
    /// From where to where the curves go, in m/s.
    range: [f64; 2],
    critical_speeds: Vec<Critical>,
    /// The upper end may be missing.
    stable_ranges: Vec<(f64, Option<f64>)>,
    panels: Vec<Graph>,
    /// The eigenvalues at each speed for a root locus: how many speeds, and how many eigenvalues at each. The numbers are
    /// speed by speed: it, and of each eigenvalue the real part, the imaginary part and which of the modes.
    locus: [usize; 2],
    modes: Vec<String>,
}

#[derive(Serialize)]
struct Critical {
    name: &'static str,
    speed: f64,
}

/// A graph of curves against speed.
#[derive(Serialize)]
struct Graph {
    label: &'static str,
    y: (f64, f64),
    series: Vec<Line>,
}

/// Curves of one name. The numbers have speed and value of each point, curve by curve.
#[derive(Serialize)]
struct Line {
    name: String,
    color: String,
    border: Option<String>,
    is_dashed: bool,
    has_label: bool,
    /// How many points each has.
    lengths: Vec<usize>,
}

/// An eigenvalue, in 1/s.
#[derive(Serialize)]
pub struct Eigenvalue {
    mode: String,
    re: f64,
    im: f64,
}

/// Everything about a design along speed; from the numbers first the points of all curves, then the root locus are read.
///
/// # Errors
/// That there is no answer.
pub fn tell(analysis: &Analysis, numbers: &mut Vec<f64>) -> Result<Known, Failure> {
    let moves = analysis.design.model.depends_on_speed();
    let (low, high) = (0.0, analysis.reach);
    let turns = analysis.critical_speeds().iter().map(|critical| critical.speed).chain(analysis.meetings());
    let rows = analysis.rows(&samples((low, high), turns))?;
    // Against what nothing depends on there is no graph.
    let panels = if moves { panels(&rows, None) } else { Vec::new() };
    let panels = panels.into_iter().map(|panel| graph(panel, numbers)).collect();
    let (locus, modes) = locus(&rows, numbers);
    let Design { kind, source, parameters: given, feedback, notes, warnings, .. } = &analysis.design;
    let info = analysis.design.info();
    let ships = carvallo_design::Shipped::called(info.name).is_ok();
    Ok(Known {
        title: analysis.design.title(),
        model: info.name,
        kind: kind.clone(),
        source: source.clone(),
        parameters: (!ships).then(|| parameters(info)),
        values: analysis.design.values(),
        written: given.iter().map(|given| written(&given.written, given.value)).collect(),
        coordinates: info.coordinates.iter().map(|coordinate| coordinate.name).collect(),
        feedback: feedback.iter().map(|law| law.written.clone()).collect(),
        notes: notes.clone(),
        warnings: warnings.clone(),
        moves,
        range: [low, high],
        critical_speeds: analysis
            .critical_speeds()
            .iter()
            .map(|critical| Critical { name: name(critical, info), speed: critical.speed })
            .collect(),
        stable_ranges: analysis.stable_ranges().iter().map(|range| (range.from, range.to)).collect(),
        panels,
        locus,
        modes,
    })
}

/// As it was written, or where nothing was, by its digits.
fn written(written: &str, value: f64) -> String {
    if written.is_empty() { shortest(value) } else { written.to_owned() }
}

fn graph(Panel { series, y, label, .. }: Panel, numbers: &mut Vec<f64>) -> Graph {
    Graph { label, y, series: series.into_iter().map(|series| line(series, numbers)).collect() }
}

fn line(Series { name, color, paint, border, has_label, curves }: Series, numbers: &mut Vec<f64>) -> Line {
    let lengths = curves.iter().map(Vec::len).collect();
    numbers.extend(curves.iter().flatten().flat_map(|&(speed, value)| [speed, value]));
    let is_dashed = matches!(paint, Paint::Stroke { dash: Some(_), .. });
    Line { name, color: hex(color), border: border.map(hex), is_dashed, has_label, lengths }
}

fn hex(Color(red, green, blue): Color) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

fn locus(rows: &Rows, numbers: &mut Vec<f64>) -> ([usize; 2], Vec<String>) {
    let mut modes: Vec<Mode> = Vec::new();
    let values = rows.values();
    for (speed, values) in &values {
        numbers.push(*speed);
        for value in *values {
            let place = modes.iter().position(|mode| *mode == value.mode).unwrap_or_else(|| {
                modes.push(value.mode);
                modes.len() - 1
            });
            numbers.extend([value.value.re, value.value.im, place as f64]);
        }
    }
    let count = values.first().map_or(0, |(_, values)| values.len());
    ([values.len(), count], modes.iter().map(Mode::to_string).collect())
}

/// The eigenvalues at one speed in m/s.
///
/// # Errors
/// That the speed is none, or that there is no answer.
pub fn at(analysis: &Analysis, speed: f64) -> Result<Vec<Eigenvalue>, Failure> {
    if !(speed >= 0.0 && speed.is_finite()) {
        return Err(Failure::usage(format!("the speed is {}; it must be >= 0", shortest(speed))));
    }
    let rows = analysis.rows(&[speed])?;
    let values = rows.values();
    let values = values.first().map(|(_, values)| *values).unwrap_or_default();
    let eigenvalue = |value: &carvallo::ModeValue| Eigenvalue {
        mode: value.mode.to_string(),
        re: value.value.re,
        im: value.value.im,
    };
    Ok(values.iter().map(eigenvalue).collect())
}
