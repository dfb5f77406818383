//! Columns that seem to be in another unit: a wheel base of 900 to 1200 in the place of 0.9 to 1.2.

use carvallo::ParameterInfo;
use carvallo_design::conventions::{Varied, Varying};
use carvallo_design::input::warning_of_varied;
use carvallo_design::number::shortest;
use carvallo_design::{Design, Failure, parameter};

use crate::source::{Batches, Source};
use crate::table::Designs;

/// So many designs are looked at: what is in another unit is so in all of them.
const MOST: usize = 4096;

/// A warning for each column of angles of which the values would be none but in degrees; and for each of which the largest value makes a design as none is, and in another unit an ordinary one, and so does
/// the middle one: a single odd design is no slip of units. All else is that of the design's own row.
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
        let cells = ascending(&chunks, column);
        let warning = |&Cell { value, designs, row }: &Cell| {
            if let Some(warning) = in_degrees(value, &varying.info) {
                return Some(warning);
            }
            let mut values = design.values();
            varied.put(|column| designs.columns[column].number(row), &mut values).ok()?;
            warning_of_varied(&varying.info, value, design.info(), &values)
        };
        cells.get(cells.len() / 2).and_then(warning).and(cells.last().and_then(warning))
    };
    let columns = columns.iter().enumerate().filter_map(|(at, column)| Some((at, column.as_ref()?)));
    Ok(columns.filter_map(warning).collect())
}

/// A value of a column, with its row.
struct Cell<'a> {
    value: f64,
    designs: &'a Designs,
    row: usize,
}

/// A warning if a value is none that its parameter can have, and one in degrees.
fn in_degrees(value: f64, info: &ParameterInfo) -> Option<String> {
    let ParameterInfo { name, domain, .. } = info;
    let written = shortest(value);
    let hint = parameter::in_degrees(&written, value, info);
    let is_meant = !domain.contains(value) && !hint.is_empty();
    is_meant.then(|| format!("`{name}` is {written} rad; it must be {domain}{hint}"))
}

/// The values of a column by their sizes.
fn ascending<'a>(chunks: &'a [Designs], column: usize) -> Vec<Cell<'a>> {
    let rows = chunks.iter().flat_map(|designs| (0..designs.rows).map(move |row| (designs, row)));
    let cell =
        |(designs, row): (&'a Designs, usize)| Some(Cell { value: designs.columns[column].number(row)?, designs, row });
    let mut cells: Vec<Cell> = rows.filter_map(cell).collect();
    cells.sort_by(|a, b| a.value.abs().total_cmp(&b.value.abs()));
    cells
}
