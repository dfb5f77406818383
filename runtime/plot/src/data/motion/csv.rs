//! A motion as comma-separated values.

use std::io::{Result, Write};

use crate::analysis::simulation::{Motion, Row};
use crate::data::cells::{exact, write_rows};

/// One row a time, under a header with the units, in SI units throughout.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(motion: &Motion, output: &mut dyn Write) -> Result<()> {
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
    write_rows(std::iter::once(header).chain(motion.rows.iter().map(row)), output)
}

fn row(row: &Row) -> Vec<String> {
    let energy = row.energy.iter().flatten();
    let forces = row.contact_forces.iter().flatten();
    let all = std::iter::once(&row.t).chain(&row.positions).chain(&row.rates).chain(&row.accelerations);
    // Adding zero turns -0 into 0.
    all.chain(energy).chain(&row.feedback).chain(forces).map(|value| exact(value + 0.0)).collect()
}
