//! The formats of tables.

use std::path::Path;

use parquet::errors::ParquetError;

/// How a table is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    Csv,
    Parquet,
}

impl Format {
    /// The format that the ending of a name tells.
    pub fn of(path: &Path) -> Option<Self> {
        let ending = path.extension()?;
        let is = |known: &str| ending.eq_ignore_ascii_case(known);
        if is("csv") {
            Some(Self::Csv)
        } else if is("parquet") {
            Some(Self::Parquet)
        } else {
            None
        }
    }
}

/// What went wrong with a file of Parquet, without the name of the kind of error where it comes from the system.
pub fn parquet_message(error: ParquetError) -> String {
    match error {
        ParquetError::External(error) => error.to_string(),
        error => error.to_string(),
    }
}
