//! The formats of tables.

pub mod csv;
pub mod parquet;

use std::path::Path;

use super::columns::Column;
use super::evaluate::{Designs, Results};

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

/// Rows of the result, in columns: designs, results and errors.
pub fn table(designs: Designs, results: Results) -> Vec<Column> {
    let errors = results.errors.into_iter().map(|error| error.map(Into::into)).collect();
    designs.columns.into_iter().chain(results.columns).chain([Column::Texts(errors)]).collect()
}
