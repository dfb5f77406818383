//! What each command found, as tables for documents, with the numbers that it prints at a terminal.

mod along;
mod analysis;
mod bicycles;
mod compare;
mod controllability;
mod models;
mod motion;
mod optimum;
mod response;
mod schedule;
mod sensitivity;
mod state_space;
mod transfer;
mod turns;

pub use self::along::of_along;
pub use self::analysis::of_analysis;
pub use self::bicycles::of_bicycles;
pub use self::compare::of_comparison;
pub use self::controllability::of_controllability;
pub use self::models::of_models;
pub use self::motion::of_motion;
pub use self::optimum::of_optimum;
pub use self::response::of_responses;
pub use self::schedule::of_schedule;
pub use self::sensitivity::of_sensitivity;
pub use self::state_space::of_state_space;
pub use self::transfer::of_transfers;
pub use self::turns::of_turns;

use carvallo_design::Design;
use carvallo_plot::data::Matrix;

use super::typeset::{Cell, Column, Document, Table};

/// A document about a design.
fn about(design: &Design, tables: Vec<Table>) -> Document {
    let kind = design.kind.as_ref().map(|kind| format!(": {kind}")).unwrap_or_default();
    let laws = design.feedback.iter().map(|law| format!("feedback {}", law.written));
    let about = design.source.iter().cloned().chain(laws).collect();
    Document { title: format!("{}{kind}", design.title()), about, tables }
}

/// The entries of matrices, a row of a matrix in each line.
fn matrices(design: &Design, title: String, matrices: &[Matrix], entries: Vec<Vec<Vec<String>>>) -> Table {
    let coordinates = design.info().coordinates.iter();
    let columns = coordinates.map(|coordinate| {
        let name = coordinate.name.to_owned();
        Column { heading: Cell::Symbol { symbol: name.clone(), name }, ..Column::right("") }
    });
    let line = |(matrix, index, row): (&Matrix, usize, Vec<String>)| {
        let (name, unit) = if index == 0 { (matrix.name, matrix.unit) } else { ("", "") };
        let head = [Cell::words(name), Cell::words(unit)];
        head.into_iter().chain(row.into_iter().map(Cell::number)).collect()
    };
    let lines = matrices
        .iter()
        .zip(entries)
        .flat_map(|(matrix, rows)| rows.into_iter().enumerate().map(move |(index, row)| (matrix, index, row)));
    Table {
        title,
        columns: [Column::left("matrix"), Column::left("unit")].into_iter().chain(columns).collect(),
        rows: lines.map(line).collect(),
        notes: Vec::new(),
    }
}
