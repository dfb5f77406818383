//! Eigenvalues as comma-separated values.

use carvallo::Complex;

use crate::analysis::{Analysis, Rows};

/// One row a speed, under a header with the units. Each mode that has two eigenvalues has numbered columns; without names
/// of modes all eigenvalues have numbers, and the last column tells whether the motion is stable.
pub fn csv(analysis: &Analysis, rows: &Rows) -> String {
    let mut lines: Vec<Vec<String>> = Vec::new();
    match rows {
        Rows::Modes(rows) => {
            let names = ["castering", "capsize", "weave 1", "weave 2"].map(str::to_owned);
            lines.push([vec!["speed (m/s)".to_owned()], header(names)].concat());
            for row in rows {
                lines.push([vec![number(row.speed)], columns(row.values.iter().map(|mode| mode.value))].concat());
            }
        }
        Rows::Sorted(rows) => {
            // Where nothing depends on the speed there is no column for it.
            let speed = |text: String| if analysis.design.model.depends_on_speed() { vec![text] } else { Vec::new() };
            let names = (1..=2 * analysis.design.info().coordinates.len()).map(|index| format!("eigenvalue {index}"));
            lines.push([speed("speed (m/s)".to_owned()), header(names), vec!["verdict".to_owned()]].concat());
            for row in rows {
                let verdict = vec![row.values.verdict.to_string()];
                lines.push([speed(number(row.speed)), columns(row.values.values.iter().copied()), verdict].concat());
            }
        }
    }
    lines.into_iter().map(|line| line.join(",") + "\n").collect()
}

fn header(names: impl IntoIterator<Item = String>) -> Vec<String> {
    names.into_iter().flat_map(|name| [format!("{name} re (1/s)"), format!("{name} im (1/s)")]).collect()
}

fn columns(values: impl Iterator<Item = Complex<f64>>) -> Vec<String> {
    values.flat_map(|value| [number(value.re), number(value.im)]).collect()
}

/// Digits that read back to the same double.
fn number(value: f64) -> String {
    format!("{value:?}")
}
