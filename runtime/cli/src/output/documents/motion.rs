//! A motion in time, in a table.

use carvallo_design::units::Units;
use carvallo_plot::analysis::simulation::Motion;

use crate::output::motion::{columns, equations};
use crate::output::typeset::{Cell, Column, Document, Table};

/// Positions at each time.
pub fn of_motion(motion: &Motion, units: &Units) -> Document {
    let columns = columns(motion, units);
    let row = |index: usize| columns.iter().map(|column| Cell::number(column.cells[index].clone())).collect();
    let rows = (0..motion.rows.len()).map(row).collect();
    let columns = columns.iter().map(|column| Column::right(column.heading.clone())).collect();
    let title = format!("Motion by {}", equations(motion));
    super::about(motion.design, vec![Table { title, columns, rows, notes: Vec::new() }])
}
