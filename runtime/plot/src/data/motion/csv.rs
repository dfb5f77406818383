//! A motion as comma-separated values.

use std::io::{Result, Write};

#[cfg(feature = "units")]
use carvallo_design::{DisplayUnit, units::Units};

#[cfg(feature = "units")]
use super::shown::Shown;
use crate::analysis::simulation::{Motion, Row};
use crate::data::cells::{exact, write_rows};

/// One row a time, under a header with the units, in SI units throughout.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(motion: &Motion, output: &mut dyn Write) -> Result<()> {
    let cells = |row: &Row| numbers(row).map(exact).collect();
    write_rows(std::iter::once(header(motion)).chain(motion.rows.iter().map(cells)), output)
}

/// The same in units.
///
/// # Errors
/// If it cannot be written.
#[cfg(feature = "units")]
pub fn write_csv_in(motion: &Motion, units: &Units, output: &mut dyn Write) -> Result<()> {
    let columns = Shown::new(motion, units).columns();
    let heading = |(heading, unit): (String, &DisplayUnit)| {
        let name = heading.rsplit_once(" (").map_or(heading.as_str(), |(name, _)| name);
        format!("{name} ({})", unit.written)
    };
    let header = header(motion).into_iter().zip(&columns).map(heading).collect();
    let cells = |row: &Row| columns.iter().zip(numbers(row)).map(|(unit, value)| exact(unit.value(value))).collect();
    write_rows(std::iter::once(header).chain(motion.rows.iter().map(cells)), output)
}

fn header(motion: &Motion) -> Vec<String> {
    let quantities = || motion.quantities.iter();
    let mut header = vec!["t (s)".to_owned()];
    header.extend(quantities().map(|quantity| format!("{} ({})", quantity.name, quantity.unit)));
    header.extend(quantities().map(|quantity| format!("{}_rate ({})", quantity.name, quantity.unit_per_time(1))));
    header
        .extend(quantities().map(|quantity| format!("{}_acceleration ({})", quantity.name, quantity.unit_per_time(2))));
    if motion.rows.iter().any(|row| row.energy.is_some()) {
        header.extend(["kinetic_energy (J)", "potential_energy (J)"].map(str::to_owned));
    }
    header.extend(motion.feedback().iter().map(|(name, unit)| format!("{name} ({unit})")));
    for wheel in &motion.wheels {
        header.extend(["x", "y", "z"].map(|axis| format!("force_{wheel}_{axis} (N)")));
    }
    header
}

/// What is in a row, in the order of the header.
fn numbers(row: &Row) -> impl Iterator<Item = f64> {
    let energy = row.energy.iter().flatten();
    let forces = row.contact_forces.iter().flatten();
    let all = std::iter::once(&row.t).chain(&row.positions).chain(&row.rates).chain(&row.accelerations);
    // Adding zero turns -0 into 0.
    all.chain(energy).chain(&row.feedback).chain(forces).map(|value| value + 0.0)
}
