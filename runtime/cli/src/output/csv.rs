//! Eigenvalues as comma-separated values.

use std::io::{Result, Write};

use carvallo::Complex;

use super::cells::{exact, write_rows};
use crate::analysis::{Analysis, Rows};

/// One row a speed, under a header with the units. Each mode that has two eigenvalues has numbered columns; without names
/// of modes all eigenvalues have numbers, and the last column tells whether the motion is stable.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(analysis: &Analysis, rows: &Rows, output: &mut dyn Write) -> Result<()> {
    let mut lines: Vec<Vec<String>> = Vec::new();
    match rows {
        Rows::Modes(rows) => {
            let names = ["castering", "capsize", "weave 1", "weave 2"].map(str::to_owned);
            lines.push([vec!["speed (m/s)".to_owned()], header(names)].concat());
            for row in rows {
                lines.push([vec![exact(row.speed)], columns(row.values.iter().map(|mode| mode.value))].concat());
            }
        }
        Rows::Sorted(rows) => {
            // Where nothing depends on the speed there is no column for it.
            let speed = |text: String| if analysis.design.model.depends_on_speed() { vec![text] } else { Vec::new() };
            let names = (1..=2 * analysis.design.info().coordinates.len()).map(|index| format!("eigenvalue {index}"));
            lines.push([speed("speed (m/s)".to_owned()), header(names), vec!["verdict".to_owned()]].concat());
            for row in rows {
                let verdict = vec![row.values.verdict.to_string()];
                lines.push([speed(exact(row.speed)), columns(row.values.values.iter().copied()), verdict].concat());
            }
        }
    }
    write_rows(lines, output)
}

fn header(names: impl IntoIterator<Item = String>) -> Vec<String> {
    names.into_iter().flat_map(|name| [format!("{name} re (1/s)"), format!("{name} im (1/s)")]).collect()
}

fn columns(values: impl Iterator<Item = Complex<f64>>) -> Vec<String> {
    values.flat_map(|value| [exact(value.re), exact(value.im)]).collect()
}
