//! An optimum as comma-separated values.

use std::io::{Result, Write};

use carvallo_design::units::Units;
use carvallo_optimize::{Optimum, Problem};

use super::json::end;
use crate::data::cells::{exact, write_rows};

/// One row for each parameter that was varied, under a header: its values before and after, its range, and at which end of that
/// it is, if at one.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(problem: &Problem, optimum: &Optimum, units: &Units, output: &mut dyn Write) -> Result<()> {
    let header = ["parameter", "unit", "before", "after", "low", "high", "at"].map(str::to_owned).to_vec();
    let rows = problem.ranges.iter().zip(&optimum.ends).enumerate().map(|(index, (range, at))| {
        let unit = units.of(range.parameter.unit);
        let shown = |value: f64| exact(unit.value(value));
        vec![
            range.parameter.name.to_owned(),
            unit.written.clone(),
            problem.before(index).map(shown).unwrap_or_default(),
            shown(optimum.varied[index]),
            shown(range.low),
            shown(range.high),
            end(*at).unwrap_or_default().to_owned(),
        ]
    });
    write_rows(std::iter::once(header).chain(rows), output)
}
