//! Steady turns as comma-separated values.

use std::io::{Result, Write};

use carvallo_design::DisplayUnit;

use crate::analysis::turns::{Families, growth, verdict};
use crate::data::cells::{exact, write_rows};

/// One row a turn, under a header with the units, which are shown by those that quantities are declared in.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(
    Families { positions, rates, families, .. }: &Families,
    shown: &dyn Fn(&str) -> DisplayUnit,
    output: &mut dyn Write,
) -> Result<()> {
    let (speed, length) = (shown("m/s"), shown("m"));
    let of_positions: Vec<DisplayUnit> = positions.iter().map(|(_, told)| shown(told.unit)).collect();
    let of_rates: Vec<DisplayUnit> = rates.iter().map(|(_, told)| shown(&told.unit_per_time(1))).collect();
    let mut header = vec![
        format!("capsize_speed ({})", speed.written),
        format!("speed ({})", speed.written),
        format!("radius ({})", length.written),
    ];
    let own = positions.iter().zip(&of_positions);
    header.extend(own.map(|((_, told), unit)| format!("{} ({})", told.name, unit.written)));
    let own = rates.iter().zip(&of_rates);
    header.extend(own.map(|((_, told), unit)| format!("{}_rate ({})", told.name, unit.written)));
    header.extend(["growth (1/s)", "verdict"].map(str::to_owned));
    let turns = families.iter().flat_map(|family| family.turns.iter().map(move |turn| (family.capsize, turn)));
    let rows = turns.map(|(capsize, turn)| {
        // Straight running has no radius.
        let radius = if turn.radius.is_finite() { exact(length.value(turn.radius)) } else { String::new() };
        let mut row = vec![
            capsize.map(|capsize| exact(speed.value(capsize))).unwrap_or_default(),
            exact(speed.value(turn.speed)),
            radius,
        ];
        let own = positions.iter().zip(&of_positions);
        row.extend(own.map(|((place, _), unit)| exact(unit.value(turn.positions[*place]) + 0.0)));
        let own = rates.iter().zip(&of_rates);
        row.extend(own.map(|((place, _), unit)| exact(unit.value(turn.rates[*place]) + 0.0)));
        row.extend([exact(growth(turn)), verdict(turn).to_owned()]);
        row
    });
    write_rows(std::iter::once(header).chain(rows), output)
}
