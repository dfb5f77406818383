//! A motion as JSON; its form is documented in `docs/simulate.md`, and stays.

use std::io::{Result, Write};

use carvallo_design::DisplayUnit;
use carvallo_design::number::by_time;
use carvallo_design::units::Units;
use serde::Serialize;

use super::shown::{Shown, values};
use crate::analysis::simulation::{Motion, Row};
use crate::data::head::Head;
use crate::data::layout::{Line, Members, write_document};
use crate::data::parameters::other;

/// Units by the names of what is in them.
type Named<Name = &'static str> = Line<Members<String, Name>>;

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    parameters: Members<Line<f64>>,
    equations: &'static str,
    /// Of positions, where they are not all those of the SI; of rates and accelerations these by time, unless others are told.
    #[serde(skip_serializing_if = "Option::is_none")]
    units: Option<Named>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rate_units: Option<Named>,
    #[serde(skip_serializing_if = "Option::is_none")]
    acceleration_units: Option<Named>,
    /// Of forces by laws, on the ground, and of energies, where these are not those of the SI.
    #[serde(skip_serializing_if = "Option::is_none")]
    feedback_force_units: Option<Named<String>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    contact_force_unit: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    energy_unit: Option<String>,
    /// Why the motion ended before its time, if it did.
    #[serde(skip_serializing_if = "Option::is_none")]
    end: Option<&'a str>,
    rows: Vec<Line<AtTime>>,
}

#[derive(Serialize)]
struct AtTime {
    t: f64,
    positions: Members<f64>,
    rates: Members<f64>,
    accelerations: Members<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    energy: Option<Energy>,
    #[serde(skip_serializing_if = "Option::is_none")]
    feedback_forces: Option<Members<f64, String>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    contact_forces: Option<Members<[f64; 3]>>,
}

#[derive(Serialize)]
struct Energy {
    kinetic: f64,
    potential: f64,
}

/// # Errors
/// If it cannot be written.
pub fn write_json(motion: &Motion, units: &Units, output: &mut dyn Write) -> Result<()> {
    let shown = Shown::new(motion, units);
    let parameters = motion.design.info().parameters.iter().zip(&motion.design.parameters);
    let document = Document {
        head: Head::of(motion.design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        equations: if motion.is_linear { "linear" } else { "nonlinear" },
        units: of_positions(motion, &shown),
        rate_units: of_others(motion, &shown, &shown.rates, 1),
        acceleration_units: of_others(motion, &shown, &shown.accelerations, 2),
        feedback_force_units: shown.feedback.iter().any(|unit| !unit.is_declared()).then(|| {
            let laws = motion.feedback().into_iter().zip(&shown.feedback);
            Line(Members(laws.map(|((name, _), unit)| (name, unit.written.clone())).collect()))
        }),
        contact_force_unit: other(&shown.contact_forces),
        energy_unit: other(&shown.energy),
        end: motion.end.as_deref(),
        rows: motion.rows.iter().map(|row| Line(at_time(motion, row, &shown))).collect(),
    };
    write_document(&document, output)
}

fn of_positions(motion: &Motion, shown: &Shown) -> Option<Named> {
    let is_other = shown.positions.iter().any(|unit| !matches!(unit.written.as_str(), "rad" | "m" | "1" | ""));
    is_other.then(|| named(motion, &shown.positions))
}

/// Those of rates, or with `power` 2 of accelerations, if any is not that of its position by time.
fn of_others(motion: &Motion, shown: &Shown, own: &[DisplayUnit], power: u32) -> Option<Named> {
    let mut pairs = own.iter().zip(&shown.positions);
    let is_other = pairs.any(|(unit, position)| unit.written != by_time(&position.written, power));
    is_other.then(|| named(motion, own))
}

fn named(motion: &Motion, units: &[DisplayUnit]) -> Named {
    let units = motion.quantities.iter().zip(units);
    Line(Members(units.map(|(quantity, unit)| (quantity.name, unit.written.clone())).collect()))
}

fn at_time(motion: &Motion, row: &Row, shown: &Shown) -> AtTime {
    let named = |units: &[DisplayUnit], own: &[f64]| {
        let names = motion.quantities.iter().map(|quantity| quantity.name);
        Members(names.zip(values(units, own)).collect())
    };
    let forces = row.contact_forces.iter().map(|force| force.map(|part| shown.contact_forces.value(part)));
    AtTime {
        t: row.t,
        positions: named(&shown.positions, &row.positions),
        rates: named(&shown.rates, &row.rates),
        accelerations: named(&shown.accelerations, &row.accelerations),
        energy: row.energy.map(|energy| {
            let [kinetic, potential] = energy.map(|energy| shown.energy.value(energy));
            Energy { kinetic, potential }
        }),
        feedback_forces: (!row.feedback.is_empty()).then(|| {
            let names = motion.feedback().into_iter().map(|(name, _)| name);
            Members(names.zip(values(&shown.feedback, &row.feedback)).collect())
        }),
        contact_forces: (!motion.wheels.is_empty())
            .then(|| Members(motion.wheels.iter().copied().zip(forces).collect())),
    }
}
