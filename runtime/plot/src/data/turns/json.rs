//! Steady turns as JSON; its form is documented in `docs/simulate.md`, and stays.

use std::io::{Result, Write};

use carvallo::turns::Turn;
use carvallo_design::DisplayUnit;
use serde::Serialize;

use crate::analysis::simulation::Quantity;
use crate::analysis::turns::{Families, end, verdict};
use crate::data::head::Head;
use crate::data::layout::{Line, Members, Parts, write_document};

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    parameters: Members<Line<f64>>,
    /// Where they are not all those of the SI.
    #[serde(skip_serializing_if = "Option::is_none")]
    units: Option<Line<Shown>>,
    families: Vec<Curve>,
}

#[derive(Serialize)]
struct Shown {
    speed: String,
    radius: String,
    positions: Members<String>,
    rates: Members<String>,
}

#[derive(Serialize)]
struct Curve {
    /// Nothing for a curve that begins elsewhere.
    capsize_speed: Option<f64>,
    begin: String,
    end: String,
    turns: Vec<Line<OneTurn>>,
}

#[derive(Serialize)]
struct OneTurn {
    speed: f64,
    /// Nothing for straight running.
    radius: Option<f64>,
    positions: Members<f64>,
    rates: Members<f64>,
    verdict: &'static str,
    eigenvalues: Vec<Parts>,
}

/// In units that are shown by those that quantities are declared in.
///
/// # Errors
/// If it cannot be written.
pub fn write_json(families: &Families, shown: &dyn Fn(&str) -> DisplayUnit, output: &mut dyn Write) -> Result<()> {
    let (speed, length) = (shown("m/s"), shown("m"));
    let position = |told: &Quantity| shown(told.unit);
    let rate = |told: &Quantity| shown(&told.unit_per_time(1));
    let units = |told: &[(usize, Quantity)], unit: &dyn Fn(&Quantity) -> DisplayUnit| {
        Members(told.iter().map(|(_, told)| (told.name, unit(told).written)).collect())
    };
    let is_si = [&speed, &length].into_iter().all(DisplayUnit::is_declared)
        && families.positions.iter().all(|(_, told)| position(told).is_declared())
        && families.rates.iter().all(|(_, told)| rate(told).is_declared());
    let design = families.design;
    let parameters = design.info().parameters.iter().zip(&design.parameters);
    let turn = |turn: &Turn| {
        let named = |told: &[(usize, Quantity)], values: &[f64], unit: &dyn Fn(&Quantity) -> DisplayUnit| {
            // Adding zero turns -0 into 0.
            Members(told.iter().map(|(place, told)| (told.name, unit(told).value(values[*place]) + 0.0)).collect())
        };
        Line(OneTurn {
            speed: speed.value(turn.speed),
            radius: turn.radius.is_finite().then(|| length.value(turn.radius)),
            positions: named(&families.positions, &turn.positions, &position),
            rates: named(&families.rates, &turn.rates, &rate),
            verdict: verdict(turn),
            eigenvalues: turn.eigenvalues.iter().copied().map(Parts::from).collect(),
        })
    };
    let curves = families.families.iter().map(|family| Curve {
        capsize_speed: family.capsize.map(|capsize| speed.value(capsize)),
        begin: end(family.begin),
        end: end(family.end),
        turns: family.turns.iter().map(turn).collect(),
    });
    let document = Document {
        head: Head::of(design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        units: (!is_si).then(|| {
            Line(Shown {
                speed: speed.written.clone(),
                radius: length.written.clone(),
                positions: units(&families.positions, &position),
                rates: units(&families.rates, &rate),
            })
        }),
        families: curves.collect(),
    };
    write_document(&document, output)
}
