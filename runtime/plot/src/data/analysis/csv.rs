//! Eigenvalues as comma-separated values.

use std::io::{Result, Write};

use carvallo::{Complex, Mode};

use crate::analysis::{Analysis, Rows};
use crate::data::cells::{exact, write_rows};

/// One row a speed, under a header with the units. Each mode that has two eigenvalues has numbered columns; what has no name
/// is in further columns, and cells are empty where no eigenvalue has the name. Of other models all eigenvalues have numbers,
/// each the same at all speeds, and the last column tells whether the motion is stable.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(analysis: &Analysis, rows: &Rows, output: &mut dyn Write) -> Result<()> {
    let mut lines: Vec<Vec<String>> = Vec::new();
    let unit = &analysis.unit;
    let heading = format!("speed ({})", unit.written);
    match rows {
        Rows::Modes(rows) => {
            let columns = mode_columns(&analysis.mode_columns());
            lines.push([vec![heading.clone()], header(columns.iter().map(|(.., name)| name.clone()))].concat());
            for row in rows {
                let value = |&(mode, index, _): &(Mode, usize, String)| {
                    row.values.iter().filter(|value| value.mode == mode).nth(index).map(|value| value.value)
                };
                lines.push(
                    [vec![exact(unit.value(row.speed))], columns.iter().map(value).flat_map(cells).collect()].concat(),
                );
            }
        }
        Rows::Branches(rows) | Rows::Sorted(rows) => {
            // Where nothing depends on the speed there is no column for it.
            let speed = |text: String| if analysis.design.model.depends_on_speed() { vec![text] } else { Vec::new() };
            let names = (1..=analysis.design.model.eigenvalues()).map(|index| format!("eigenvalue {index}"));
            lines.push([speed(heading), header(names), vec!["verdict".to_owned()]].concat());
            for row in rows {
                let verdict = vec![row.values.verdict.to_string()];
                lines.push(
                    [
                        speed(exact(unit.value(row.speed))),
                        row.values.values.iter().map(|value| Some(value.value)).flat_map(cells).collect(),
                        verdict,
                    ]
                    .concat(),
                );
            }
        }
    }
    write_rows(lines, output)
}

/// A mode, which of its eigenvalues, and the name of that. Weave and what has no name have numbers even if there is one.
fn mode_columns(modes: &[Mode]) -> Vec<(Mode, usize, String)> {
    let column = |(position, &mode): (usize, &Mode)| {
        let index = modes[..position].iter().filter(|&&other| other == mode).count();
        let is_only = modes.iter().filter(|&&other| other == mode).count() == 1;
        let is_single = is_only && matches!(mode, Mode::Castering | Mode::Capsize);
        (mode, index, if is_single { mode.to_string() } else { format!("{mode} {}", index + 1) })
    };
    modes.iter().enumerate().map(column).collect()
}

/// Real and imaginary part; empty where there is no such eigenvalue.
fn cells(value: Option<Complex<f64>>) -> [String; 2] {
    value.map_or_else(Default::default, |value| [exact(value.re), exact(value.im)])
}

fn header(names: impl IntoIterator<Item = String>) -> Vec<String> {
    names.into_iter().flat_map(|name| [format!("{name} re (1/s)"), format!("{name} im (1/s)")]).collect()
}
