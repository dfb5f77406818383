//! Frequency responses as comma-separated values.

use std::io::{Result, Write};

use crate::analysis::transfer::Transfers;
use crate::data::cells::{exact, write_rows};

/// One row a frequency, with the gain and the phase of each transfer function, and of several the singular values.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(transfers: &Transfers, output: &mut dyn Write) -> Result<()> {
    let mut header = vec!["frequency (rad/s)".to_owned()];
    for channel in &transfers.channels {
        let name = format!("{}/{}", channel.function.output.name, channel.function.input.name);
        header.extend([format!("gain {name} ({})", channel.unit()), format!("phase {name} (rad)")]);
    }
    let several =
        if transfers.are_several() { transfers.space.inputs.len().min(transfers.space.outputs.len()) } else { 0 };
    header.extend((1..=several).map(|place| format!("singular value {place}")));
    let count = transfers.channels.first().map_or(0, |channel| channel.response.len());
    let row = |place: usize| {
        let points = || transfers.channels.iter().map(move |channel| channel.response[place]);
        let frequency = points().next().map(|point| exact(point.frequency));
        // At a pole on the imaginary axis there is no gain.
        let number = |value: f64| if value.is_finite() { exact(value) } else { String::new() };
        let gains = points().flat_map(|point| [number(point.gain), number(point.phase)]);
        let together = points().next().and_then(|point| {
            transfers.singular_values.iter().find(|at| at.frequency == point.frequency).map(|at| &at.values)
        });
        let singular = (0..several).map(|place| together.map_or(String::new(), |values| exact(values[place])));
        frequency.into_iter().chain(gains).chain(singular).collect()
    };
    write_rows(std::iter::once(header).chain((0..count).map(row)), output)
}
