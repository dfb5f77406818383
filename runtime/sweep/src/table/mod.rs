//! Tables: their columns, and the formats in which they are written and read.

mod columns;
mod format;

use std::borrow::Cow;

use carvallo::StableRange;

pub use self::columns::{Column, shown_in, written};
pub use self::format::{Format, parquet_message};
pub use carvallo_plot::analysis::columns::{Heading, Kind, Layout};

/// Some designs, in columns.
#[derive(Debug)]
pub struct Designs {
    pub rows: usize,
    /// As they are written to the result.
    pub columns: Vec<Column>,
    /// Why a row is no design.
    pub errors: Vec<Option<String>>,
}

/// The results of some designs, in columns.
#[derive(Debug)]
pub struct Results {
    pub columns: Vec<Column>,
    /// Why a design has no results.
    pub errors: Vec<Option<String>>,
    /// The first stable range of each design, if it has one.
    pub stable: Vec<Option<StableRange>>,
}

/// Rows of the result, in columns: designs, results and errors.
pub fn joined(designs: Designs, results: Results) -> Vec<Column> {
    let errors = results.errors.into_iter().map(|error| error.map(Cow::Owned)).collect();
    designs.columns.into_iter().chain(results.columns).chain([Column::Texts(errors)]).collect()
}
