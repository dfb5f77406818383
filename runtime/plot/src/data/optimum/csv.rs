//! An optimum as comma-separated values.

use std::io::{Result, Write};

use carvallo_optimize::{Optimum, Problem};

use super::json::end;
use crate::data::cells::{exact, write_rows};

/// One row for each parameter that was varied, under a header: its values before and after, its range, and at which end of that
/// it is, if at one.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(problem: &Problem, optimum: &Optimum, output: &mut dyn Write) -> Result<()> {
    let header = ["parameter", "unit", "before", "after", "low", "high", "at"].map(str::to_owned).to_vec();
    let rows = problem.ranges.iter().zip(&optimum.ends).enumerate().map(|(index, (range, at))| {
        vec![
            range.parameter.name.to_owned(),
            range.parameter.unit.to_owned(),
            problem.before(index).map(exact).unwrap_or_default(),
            exact(optimum.varied[index]),
            exact(range.low),
            exact(range.high),
            end(*at).unwrap_or_default().to_owned(),
        ]
    });
    write_rows(std::iter::once(header).chain(rows), output)
}
