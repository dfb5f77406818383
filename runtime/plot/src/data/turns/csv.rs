//! Steady turns as comma-separated values.

use std::io::{Result, Write};

use crate::analysis::turns::{Families, growth, verdict};
use crate::data::cells::{exact, write_rows};

/// One row a turn, under a header with the units, in SI units throughout.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(Families { positions, rates, families, .. }: &Families, output: &mut dyn Write) -> Result<()> {
    let mut header = ["capsize_speed (m/s)", "speed (m/s)", "radius (m)"].map(str::to_owned).to_vec();
    header.extend(positions.iter().map(|(_, told)| format!("{} ({})", told.name, told.unit)));
    header.extend(rates.iter().map(|(_, told)| format!("{}_rate ({})", told.name, told.unit_per_time(1))));
    header.extend(["growth (1/s)", "verdict"].map(str::to_owned));
    let turns = families.iter().flat_map(|family| family.turns.iter().map(move |turn| (family.capsize, turn)));
    let rows = turns.map(|(capsize, turn)| {
        // Straight running has no radius.
        let radius = if turn.radius.is_finite() { exact(turn.radius) } else { String::new() };
        let mut row = vec![capsize.map(exact).unwrap_or_default(), exact(turn.speed), radius];
        row.extend(positions.iter().map(|(place, _)| exact(turn.positions[*place] + 0.0)));
        row.extend(rates.iter().map(|(place, _)| exact(turn.rates[*place] + 0.0)));
        row.extend([exact(growth(turn)), verdict(turn).to_owned()]);
        row
    });
    write_rows(std::iter::once(header).chain(rows), output)
}
