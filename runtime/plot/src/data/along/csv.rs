//! Stability along a parameter as comma-separated values.

use std::io::{Result, Write};

use crate::analysis::along::{AlongAnalysis, AtValue};
use crate::data::cells::{exact, write_rows};

/// One row a value, under a header with the units.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(analysis: &AlongAnalysis, rows: &[AtValue], output: &mut dyn Write) -> Result<()> {
    let numbers = 1..=rows.first().map_or(0, |row| row.eigenvalues.len());
    let names = numbers.flat_map(|k| [format!("eigenvalue {k} re (1/s)"), format!("eigenvalue {k} im (1/s)")]);
    let header = [format!("{} ({})", analysis.parameter.name, analysis.unit.written)]
        .into_iter()
        .chain(names)
        .chain(["verdict".to_owned()]);
    let lines = rows.iter().map(|row| {
        let values = row.eigenvalues.iter().flat_map(|value| [exact(value.re), exact(value.im)]);
        [exact(analysis.shown(row.value))].into_iter().chain(values).chain([row.verdict.to_string()]).collect()
    });
    write_rows([header.collect()].into_iter().chain(lines), output)
}
