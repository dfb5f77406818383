//! An analysis as JSON; its form is documented in `docs/json.md`, and stays.

use std::io::{Result, Write};

use carvallo::{Complex, CriticalSpeed, ModeValue, ModelInfo, Stability, StableRange, UndecidedRange};
use carvallo_design::{DisplayUnit, Shape};
use serde::Serialize;

use crate::analysis::{Analysis, Eigenvalues, ModeRow, Row, Rows, name};
use crate::data::head::Head;
use crate::data::layout::{Line, Members, Parts, write_document};
use crate::data::matrices::{Matrix, matrices};

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    /// What speeds are in, if not in m/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    speed_unit: Option<&'a str>,
    parameters: Members<Line<f64>>,
    matrices: Members<Line<Vec<Vec<f64>>>>,
    critical_speeds: Vec<Line<Event>>,
    stable_ranges: Vec<Line<Range>>,
    undecided_ranges: Vec<Line<(f64, f64)>>,
    eigenvalues: Vec<Line<AtSpeed>>,
}

/// The ends of a stable range; there may be no upper one.
pub type Range = (f64, Option<f64>);

/// A critical speed.
#[derive(Serialize)]
pub struct Event {
    kind: &'static str,
    speed: f64,
    eigenvalue: Parts,
    change: String,
    /// Just below and just above the speed.
    verdicts: [String; 2],
}

/// The eigenvalues at one speed, with the names of their modes, and but for bicycles with a verdict.
#[derive(Serialize)]
#[serde(untagged)]
enum AtSpeed {
    Modes { speed: f64, values: Vec<Named> },
    Sorted { speed: Option<f64>, verdict: String, values: Vec<Named> },
}

/// An eigenvalue whose mode has a name.
#[derive(Serialize)]
struct Named {
    re: f64,
    im: f64,
    mode: String,
    /// The eigenvectors, by coordinate, where they are asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    right: Option<Vec<Parts>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    left: Option<Vec<Parts>>,
}

/// With eigenvectors at each speed, if there are any.
///
/// # Errors
/// If it cannot be written.
pub fn write_json(
    analysis: &Analysis,
    rows: &Rows,
    shapes: Option<&[Vec<Shape>]>,
    output: &mut dyn Write,
) -> Result<()> {
    let Analysis { design, stability, unit, .. } = analysis;
    let info = design.info();
    let parameters = info.parameters.iter().zip(&design.parameters);
    let matrices = matrices(design).into_iter();
    let undecided = |UndecidedRange { from, to }: &UndecidedRange| Line((unit.value(*from), unit.value(*to)));
    let document = Document {
        head: Head::of(design),
        speed_unit: (!unit.is_declared()).then_some(unit.written.as_str()),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        matrices: Members(matrices.map(|Matrix { name, rows, .. }| (name, Line(rows))).collect()),
        critical_speeds: events(stability, info, unit),
        stable_ranges: ranges(stability, unit),
        undecided_ranges: stability.undecided.iter().map(undecided).collect(),
        eigenvalues: eigenvalues(rows, shapes, design.model.depends_on_speed(), unit),
    };
    write_document(&document, output)
}

/// All critical speeds.
pub fn events(stability: &Stability, info: &ModelInfo, unit: &DisplayUnit) -> Vec<Line<Event>> {
    let event = |critical: &CriticalSpeed| Event {
        kind: name(critical, info),
        speed: unit.value(critical.speed),
        eigenvalue: critical.eigenvalue.into(),
        change: critical.change.to_string(),
        verdicts: stability.verdicts_around(critical).map(|verdict| verdict.to_string()),
    };
    stability.critical_speeds.iter().map(event).map(Line).collect()
}

/// All stable ranges.
pub fn ranges(stability: &Stability, unit: &DisplayUnit) -> Vec<Line<Range>> {
    let range = |StableRange { from, to }: &StableRange| Line((unit.value(*from), to.map(|to| unit.value(to))));
    stability.stable_ranges.iter().map(range).collect()
}

/// Where nothing depends on the speed there is none.
fn eigenvalues(rows: &Rows, shapes: Option<&[Vec<Shape>]>, moves: bool, unit: &DisplayUnit) -> Vec<Line<AtSpeed>> {
    let named = |(row, (_, values)): (usize, (f64, &[ModeValue]))| -> Vec<Named> {
        let shape = |index: usize| shapes.map(|shapes| &shapes[row][index]);
        values.iter().enumerate().map(|(index, value)| named(value, shape(index))).collect()
    };
    let values = rows.values().into_iter().enumerate().map(named);
    match rows {
        Rows::Modes(rows) => {
            let at = |(row, values): (&ModeRow, _)| Line(AtSpeed::Modes { speed: unit.value(row.speed), values });
            rows.iter().zip(values).map(at).collect()
        }
        Rows::Branches(rows) | Rows::Sorted(rows) => {
            let at = |(row, values): (&Row<Eigenvalues>, _)| {
                let verdict = row.values.verdict.to_string();
                Line(AtSpeed::Sorted { speed: moves.then_some(unit.value(row.speed)), verdict, values })
            };
            rows.iter().zip(values).map(at).collect()
        }
    }
}

fn named(ModeValue { mode, value: Complex { re, im } }: &ModeValue, shape: Option<&Shape>) -> Named {
    let parts = |vector: &Vec<Complex<f64>>| vector.iter().copied().map(Parts::from).collect();
    let (right, left) = (shape.map(|shape| parts(&shape.right)), shape.map(|shape| parts(&shape.left)));
    Named { re: *re, im: *im, mode: mode.to_string(), right, left }
}
