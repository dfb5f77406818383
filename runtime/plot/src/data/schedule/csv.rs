//! Scheduled gains as comma-separated values.

use std::io::{Result, Write};

use carvallo_control::{Regulator, Schedule, Signal};

use crate::data::cells::{exact, write_rows};

/// A row for each speed, with the gains of each input by state, and the eigenvalues of the closed loop.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(schedule: &Schedule, output: &mut dyn Write) -> Result<()> {
    let space = &schedule.regulators[0].space;
    let speed = |text: String| space.speed.map(|_| text);
    let gains = space.inputs.iter().flat_map(|input| {
        let heading = |state: &Signal| format!("{} by {} ({})", input.name, state.name, input.unit_by(state));
        space.states.iter().map(heading).collect::<Vec<_>>()
    });
    let values =
        (1..=space.states.len()).flat_map(|index| ["re", "im"].map(|part| format!("eigenvalue {index} {part} (1/s)")));
    let header =
        speed(format!("speed ({})", space.speed_unit.written)).into_iter().chain(gains).chain(values).collect();
    let row = |own: &Regulator| {
        let speed = own.space.shown_speed().map(exact);
        let gains = own.gains.row_iter().flat_map(|row| row.iter().map(|gain| exact(*gain)).collect::<Vec<_>>());
        let values = own.eigenvalues.iter().flat_map(|value| [value.re, value.im].map(exact));
        speed.into_iter().chain(gains.collect::<Vec<_>>()).chain(values).collect()
    };
    write_rows(std::iter::once(header).chain(schedule.regulators.iter().map(row)), output)
}
