//! The derivatives as JSON; its form is documented in `docs/sensitivity.md`, and stays.

use std::io::{Result, Write};

use carvallo::Complex;
use serde::Serialize;

use crate::analysis::name;
use crate::analysis::sensitivity::{Changes, Critical};
use crate::data::head::Head;
use crate::data::layout::{Line, Members, Parts, write_document};
use crate::data::matrices::{Matrix, matrices};
use crate::data::parameters::{Correlations, correlations, other};

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    parameters: Members<Line<Parameter>>,
    /// What all speeds are in, where that is not m/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    speed_unit: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    correlations: Option<Correlations>,
    critical_speeds: Vec<CriticalSpeed>,
    matrices: Members<Line<Vec<Vec<f64>>>>,
    matrix_standard_deviations: Option<Members<Line<Vec<Vec<f64>>>>>,
}

#[derive(Serialize)]
struct Parameter {
    value: f64,
    std: f64,
    one_percent: Option<f64>,
    /// Where it is not that of the SI.
    #[serde(skip_serializing_if = "Option::is_none")]
    unit: Option<String>,
}

/// Without derivatives all from them on are null, and the last one says why.
#[derive(Serialize)]
struct CriticalSpeed {
    kind: &'static str,
    speed: Line<f64>,
    eigenvalue: Line<Parts>,
    change: String,
    derivatives: Option<Members<Line<f64>>>,
    eigenvalue_derivatives: Option<Members<Line<Parts>>>,
    condition: Option<Line<f64>>,
    standard_deviation: Option<Line<f64>>,
    variance_shares: Option<Members<Line<f64>>>,
    not_differentiable: Option<String>,
}

/// # Errors
/// If it cannot be written.
pub fn write_json(changes: &Changes, output: &mut dyn Write) -> Result<()> {
    let design = &changes.design;
    let info = design.info();
    let parameters = design.parameters.iter().zip(&changes.steps).enumerate().map(|(index, (given, step))| {
        let unit = changes.of_parameter(index);
        Parameter {
            value: unit.value(given.value),
            std: unit.value(given.deviation.as_ref().map_or(0.0, |deviation| deviation.value)),
            one_percent: step.size().map(|step| positive_zero(unit.value(step))),
            unit: other(&unit),
        }
    });
    let matrix_deviations = changes.matrix_deviations.as_ref().map(|known| {
        let known = known.matrices().into_iter().filter(|(name, _)| info.matrices.contains(name));
        Members(known.map(|(name, rows)| (name.name(), Line(entries(rows)))).collect())
    });
    let document = Document {
        head: Head::of(design),
        parameters: by_parameter(changes, parameters),
        speed_unit: other(&changes.of_speeds()),
        correlations: correlations(design),
        critical_speeds: changes.critical_speeds.iter().map(|critical| critical_speed(changes, critical)).collect(),
        matrices: Members(
            matrices(design).into_iter().map(|Matrix { name, rows, .. }| (name, Line(entries(rows)))).collect(),
        ),
        matrix_standard_deviations: matrix_deviations,
    };
    write_document(&document, output)
}

fn critical_speed(changes: &Changes, Critical { speed, derivatives }: &Critical) -> CriticalSpeed {
    let known = derivatives.as_ref().ok();
    let unit = changes.of_speeds();
    let numbers = |values: &[f64]| by_parameter(changes, values.iter().copied().map(positive_zero));
    // By a parameter in its unit.
    let units: Vec<f64> = (0..changes.steps.len()).map(|index| changes.of_parameter(index).value(1.0)).collect();
    let derivatives_of_speed = |values: &[f64]| {
        let derivatives = values.iter().zip(&units).map(|(value, own)| positive_zero(unit.value(*value) / own));
        by_parameter(changes, derivatives)
    };
    let parts = |values: &[Complex<f64>]| {
        by_parameter(changes, values.iter().zip(&units).map(|(value, own)| positive_zeros(*value / *own)))
    };
    CriticalSpeed {
        kind: name(speed, changes.design.info()),
        speed: Line(unit.value(speed.speed)),
        eigenvalue: Line(positive_zeros(speed.eigenvalue)),
        change: speed.change.to_string(),
        derivatives: known.map(|known| derivatives_of_speed(&known.speed)),
        eigenvalue_derivatives: known.map(|known| parts(&known.eigenvalue)),
        condition: known.map(|known| Line(known.condition)),
        standard_deviation: known.and_then(|known| known.deviation).map(|own| Line(positive_zero(unit.value(own)))),
        variance_shares: known.and_then(|known| known.variance_shares.as_ref()).map(|shares| numbers(shares)),
        not_differentiable: derivatives.as_ref().err().map(ToString::to_string),
    }
}

/// An object with a member for each parameter.
fn by_parameter<T>(changes: &Changes, values: impl Iterator<Item = T>) -> Members<Line<T>> {
    let parameters = changes.design.info().parameters.iter();
    Members(parameters.zip(values).map(|(info, value)| (info.name, Line(value))).collect())
}

fn entries(rows: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    rows.into_iter().map(|row| row.into_iter().map(positive_zero).collect()).collect()
}

fn positive_zeros(value: Complex<f64>) -> Parts {
    Parts::from(Complex::new(positive_zero(value.re), positive_zero(value.im)))
}

/// Adding zero turns -0 into 0.
fn positive_zero(value: f64) -> f64 {
    value + 0.0
}
