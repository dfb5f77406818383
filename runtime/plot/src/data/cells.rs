//! Cells of comma-separated values.

use std::io::{Error, Result, Write};

/// Writes rows of as many cells each.
///
/// # Errors
/// If they cannot be written.
pub fn write_rows(rows: impl IntoIterator<Item = Vec<String>>, output: &mut dyn Write) -> Result<()> {
    let mut writer = csv::Writer::from_writer(output);
    rows.into_iter().try_for_each(|row| writer.write_record(row)).map_err(|error| match error.into_kind() {
        // As it was, so that a reader that has seen enough is known.
        csv::ErrorKind::Io(error) => error,
        other => Error::other(format!("{other:?}")),
    })?;
    writer.flush()
}

/// The fewest digits that read back to the same double, with an exponent only where there would be many zeros.
pub fn exact(value: f64) -> String {
    format!("{value:?}")
}
