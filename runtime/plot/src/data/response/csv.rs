//! A response as comma-separated values.

use std::io::{Result, Write};

use crate::analysis::response::Responses;
use crate::data::cells::{exact, write_rows};

/// One row a time, with all outputs, in SI units.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(Responses { space, response, .. }: &Responses, output: &mut dyn Write) -> Result<()> {
    let names = space.outputs.iter().map(|signal| format!("{} ({})", signal.name, signal.unit));
    let header = std::iter::once("t (s)".to_owned()).chain(names).collect();
    // Adding zero turns -0 into 0.
    let row = |(time, values): (&f64, &Vec<f64>)| {
        std::iter::once(exact(*time)).chain(values.iter().map(|value| exact(value + 0.0))).collect()
    };
    write_rows(std::iter::once(header).chain(response.times.iter().zip(&response.outputs).map(row)), output)
}
