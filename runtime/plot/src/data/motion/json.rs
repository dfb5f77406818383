//! A motion as JSON; its form is documented in `docs/simulate.md`, and stays.

use std::io::{Result, Write};

use carvallo_design::DisplayUnit;
use serde::Serialize;

use super::{Shown, units_of};
use crate::analysis::simulation::{Motion, Row};
use crate::data::head::Head;
use crate::data::layout::{Line, Members, write_document};

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    parameters: Members<Line<f64>>,
    equations: &'static str,
    /// Of positions, where they are not all those of the SI.
    #[serde(skip_serializing_if = "Option::is_none")]
    units: Option<Line<Members<String>>>,
    /// The same of rates and accelerations, where they are not these by time.
    #[serde(skip_serializing_if = "Option::is_none")]
    rate_units: Option<Line<Members<String>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    acceleration_units: Option<Line<Members<String>>>,
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
pub fn write_json(motion: &Motion, shown: Shown, output: &mut dyn Write) -> Result<()> {
    let units = units_of(motion, shown);
    let [positions, rates, accelerations] = &units;
    let told = |own: &[DisplayUnit], is_told: bool| {
        let names = motion.quantities.iter().map(|quantity| quantity.name);
        is_told.then(|| Line(Members(names.zip(own.iter().map(|unit| unit.written.clone())).collect())))
    };
    let differ = |own: &[DisplayUnit], time: &str| {
        let is_own = |(unit, of): (&DisplayUnit, &DisplayUnit)| {
            let position = if of.written.is_empty() { "1" } else { &of.written };
            unit.written != format!("{position}{time}")
        };
        own.iter().zip(positions).any(is_own)
    };
    let parameters = motion.design.info().parameters.iter().zip(&motion.design.parameters);
    let document = Document {
        head: Head::of(motion.design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        equations: if motion.is_linear { "linear" } else { "nonlinear" },
        units: told(positions, positions.iter().any(|unit| !unit.is_declared())),
        rate_units: told(rates, differ(rates, "/s")),
        acceleration_units: told(accelerations, differ(accelerations, "/s^2")),
        end: motion.end.as_deref(),
        rows: motion.rows.iter().map(|row| Line(at_time(motion, &units, row))).collect(),
    };
    write_document(&document, output)
}

fn at_time(motion: &Motion, [positions, rates, accelerations]: &[Vec<DisplayUnit>; 3], row: &Row) -> AtTime {
    let named = |values: &[f64], units: &[DisplayUnit]| {
        let names = motion.quantities.iter().map(|quantity| quantity.name);
        // Adding zero turns -0 into 0.
        Members(names.zip(values.iter().zip(units).map(|(value, unit)| unit.value(*value) + 0.0)).collect())
    };
    let forces = motion.wheels.iter().copied().zip(row.contact_forces.iter().copied());
    AtTime {
        t: row.t,
        positions: named(&row.positions, positions),
        rates: named(&row.rates, rates),
        accelerations: named(&row.accelerations, accelerations),
        energy: row.energy.map(|[kinetic, potential]| Energy { kinetic, potential }),
        feedback_forces: (!row.feedback.is_empty()).then(|| {
            let names = motion.feedback().into_iter().map(|(name, _)| name);
            Members(names.zip(row.feedback.iter().map(|force| force + 0.0)).collect())
        }),
        contact_forces: (!motion.wheels.is_empty()).then(|| Members(forces.collect())),
    }
}
