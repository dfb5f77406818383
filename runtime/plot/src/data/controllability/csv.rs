//! Modal measures as comma-separated values.

use std::io::{Result, Write};

use crate::analysis::controllability::{AtSpeed, Controllability};
use crate::data::cells::{exact, write_rows};

/// One row a mode and speed, with the cosines of all inputs and outputs. Where nothing depends on the speed it is left out.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(controllability: &Controllability, rows: &[AtSpeed], output: &mut dyn Write) -> Result<()> {
    let unit = &controllability.analysis.unit;
    let mut header = vec![format!("speed ({})", unit.written)];
    header.extend(["mode", "re (1/s)", "im (1/s)"].map(str::to_owned));
    header.extend(controllability.inputs.iter().map(|input| format!("controllability {}", input.name)));
    header.extend(controllability.outputs.iter().map(|output| format!("observability {}", output.name)));
    let moves = controllability.analysis.design.model.depends_on_speed();
    let modes = rows.iter().flat_map(|row| row.modes.iter().map(move |mode| (row.speed, mode)));
    let rows = modes.map(|(speed, (mode, measures))| {
        let speed = if moves { exact(unit.value(speed)) } else { String::new() };
        let mut row = vec![speed, mode.mode.to_string(), exact(mode.value.re), exact(mode.value.im)];
        row.extend(measures.controllability.iter().chain(&measures.observability).map(|cosine| exact(*cosine)));
        row
    });
    write_rows(std::iter::once(header).chain(rows), output)
}
