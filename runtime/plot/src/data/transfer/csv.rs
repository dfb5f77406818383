//! Frequency responses as comma-separated values.

use std::io::{Result, Write};

use crate::analysis::transfer::Transfers;
use crate::data::cells::{exact, write_rows};

/// One row a frequency, with the gain and the phase of each transfer function.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(transfers: &Transfers, output: &mut dyn Write) -> Result<()> {
    let mut header = vec!["frequency (rad/s)".to_owned()];
    for channel in &transfers.channels {
        let name = format!("{}/{}", channel.function.output.name, channel.function.input.name);
        header.extend([format!("gain {name} ({})", channel.unit()), format!("phase {name} (rad)")]);
    }
    let count = transfers.channels.first().map_or(0, |channel| channel.response.len());
    let row = |place: usize| {
        let points = || transfers.channels.iter().map(move |channel| channel.response[place]);
        let frequency = points().next().map(|point| exact(point.frequency));
        // At a pole on the imaginary axis there is no gain.
        let number = |value: f64| if value.is_finite() { exact(value) } else { String::new() };
        frequency.into_iter().chain(points().flat_map(|point| [number(point.gain), number(point.phase)])).collect()
    };
    write_rows(std::iter::once(header).chain((0..count).map(row)), output)
}
