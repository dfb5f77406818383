//! Columns that seem to be in another unit: a wheel base of 900 to 1200 in the place of 0.9 to 1.2.

use carvallo_design::conventions::{Varied, Varying};
use carvallo_design::input::warning_of_varied;
use carvallo_design::{Design, Failure};

use crate::source::{Batches, Source};
use crate::table::Designs;

/// So many designs are looked at: what is in another unit is so in all of them.
const MOST: usize = 4096;

/// A warning for each column of which the largest value makes a design as none is, and in another unit an ordinary one. All else
/// is that of its row.
///
/// # Errors
/// If a file cannot be read.
pub fn warnings(
    design: &Design,
    source: &Source,
    columns: &[Option<&Varying>],
    varied: &Varied,
) -> Result<Vec<String>, Failure> {
    let chunks = Batches::new(source)?.next(0, MOST)?;
    let warning = |(column, varying): (usize, &&Varying)| {
        let (value, designs, row) = largest(&chunks, column)?;
        let mut values = design.values();
        varied.put(|column| designs.columns[column].number(row), &mut values).ok()?;
        warning_of_varied(&varying.info, value, design.info(), &values)
    };
    let columns = columns.iter().enumerate().filter_map(|(at, column)| Some((at, column.as_ref()?)));
    Ok(columns.filter_map(warning).collect())
}

/// The largest value of a column, by its size, with its row.
fn largest(chunks: &[Designs], column: usize) -> Option<(f64, &Designs, usize)> {
    let rows = chunks.iter().flat_map(|designs| (0..designs.rows).map(move |row| (designs, row)));
    let values = rows.filter_map(|(designs, row)| Some((designs.columns[column].number(row)?, designs, row)));
    values.max_by(|(a, ..), (b, ..)| a.abs().total_cmp(&b.abs()))
}
