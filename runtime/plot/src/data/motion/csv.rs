//! A motion as comma-separated values.

use std::io::{Result, Write};

use carvallo_design::DisplayUnit;

use super::{Shown, units_of};
use crate::analysis::simulation::{Motion, Row};
use crate::data::cells::{exact, write_rows};

/// One row a time, under a header with the units.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(motion: &Motion, shown: Shown, output: &mut dyn Write) -> Result<()> {
    let moving = units_of(motion, shown);
    let forces: Vec<DisplayUnit> = motion.feedback().iter().map(|(_, unit)| shown(unit, 0)).collect();
    let newton = shown("N", 0);
    let mut header = vec!["t (s)".to_owned()];
    for (units, what) in moving.iter().zip(["", "_rate", "_acceleration"]) {
        let named = motion.quantities.iter().zip(units);
        header.extend(named.map(|(quantity, unit)| format!("{}{what} ({})", quantity.name, unit.written)));
    }
    if motion.rows.iter().any(|row| row.energy.is_some()) {
        header.extend(["kinetic_energy (J)", "potential_energy (J)"].map(str::to_owned));
    }
    header.extend(motion.feedback().iter().zip(&forces).map(|((name, _), unit)| format!("{name} ({})", unit.written)));
    for wheel in &motion.wheels {
        header.extend(["x", "y", "z"].map(|axis| format!("force_{wheel}_{axis} ({})", newton.written)));
    }
    let row = |row: &Row| {
        let mut values = vec![row.t];
        for (own, units) in [&row.positions, &row.rates, &row.accelerations].into_iter().zip(&moving) {
            values.extend(own.iter().zip(units).map(|(value, unit)| unit.value(*value)));
        }
        values.extend(row.energy.iter().flatten());
        values.extend(row.feedback.iter().zip(&forces).map(|(value, unit)| unit.value(*value)));
        values.extend(row.contact_forces.iter().flatten().map(|value| newton.value(*value)));
        // Adding zero turns -0 into 0.
        values.into_iter().map(|value| exact(value + 0.0)).collect()
    };
    write_rows(std::iter::once(header).chain(motion.rows.iter().map(row)), output)
}
