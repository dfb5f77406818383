//! A motion as JSON; its form is documented in `docs/simulate.md`, and stays.

use std::io::{Result, Write};

use serde::Serialize;

#[cfg(feature = "units")]
use crate::analysis::simulation::Quantity;
use crate::analysis::simulation::{Motion, Row};
use crate::data::head::Head;
use crate::data::layout::{Line, Members, write_document};

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    parameters: Members<Line<f64>>,
    equations: &'static str,
    /// Of positions, where they are not all those of the SI; of rates and accelerations these by time, unless others are told.
    #[serde(skip_serializing_if = "Option::is_none")]
    units: Option<Line<Members<&'static str>>>,
    #[cfg(feature = "units")]
    #[serde(skip_serializing_if = "Option::is_none")]
    rate_units: Option<Line<Members<String>>>,
    #[cfg(feature = "units")]
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
pub fn write_json(motion: &Motion, output: &mut dyn Write) -> Result<()> {
    let parameters = motion.design.info().parameters.iter().zip(&motion.design.parameters);
    let document = Document {
        head: Head::of(motion.design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        equations: if motion.is_linear { "linear" } else { "nonlinear" },
        units: units(motion),
        #[cfg(feature = "units")]
        rate_units: units_by_time(motion, 1),
        #[cfg(feature = "units")]
        acceleration_units: units_by_time(motion, 2),
        end: motion.end.as_deref(),
        rows: motion.rows.iter().map(|row| Line(at_time(motion, row))).collect(),
    };
    write_document(&document, output)
}

fn units(motion: &Motion) -> Option<Line<Members<&'static str>>> {
    let is_other = motion.quantities.iter().any(|quantity| !matches!(quantity.unit, "rad" | "m" | "1" | ""));
    is_other.then(|| Line(Members(motion.quantities.iter().map(|quantity| (quantity.name, quantity.unit)).collect())))
}

#[cfg(feature = "units")]
fn units_by_time(motion: &Motion, power: u32) -> Option<Line<Members<String>>> {
    let is_other = motion.quantities.iter().any(|quantity| quantity.by_time[power as usize - 1].is_some());
    let unit = |quantity: &Quantity| (quantity.name, quantity.unit_per_time(power));
    is_other.then(|| Line(Members(motion.quantities.iter().map(unit).collect())))
}

fn at_time(motion: &Motion, row: &Row) -> AtTime {
    let named = |values: &[f64]| {
        let names = motion.quantities.iter().map(|quantity| quantity.name);
        // Adding zero turns -0 into 0.
        Members(names.zip(values.iter().map(|value| value + 0.0)).collect())
    };
    let forces = motion.wheels.iter().copied().zip(row.contact_forces.iter().copied());
    AtTime {
        t: row.t,
        positions: named(&row.positions),
        rates: named(&row.rates),
        accelerations: named(&row.accelerations),
        energy: row.energy.map(|[kinetic, potential]| Energy { kinetic, potential }),
        feedback_forces: (!row.feedback.is_empty()).then(|| {
            let names = motion.feedback().into_iter().map(|(name, _)| name);
            Members(names.zip(row.feedback.iter().map(|force| force + 0.0)).collect())
        }),
        contact_forces: (!motion.wheels.is_empty()).then(|| Members(forces.collect())),
    }
}
