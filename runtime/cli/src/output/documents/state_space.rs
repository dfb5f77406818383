//! A state space: its signals, and a table for each matrix.

use carvallo::nalgebra::DMatrix;
use carvallo_control::{Signal, StateSpace};
use carvallo_design::Design;
use carvallo_design::number::{fixed, unit};

use crate::output::typeset::{Cell, Column, Document, Table};

/// The names with their units, and the four matrices.
pub fn of_state_space(design: &Design, space: &StateSpace) -> Document {
    let derivatives: Vec<Signal> = space.states.iter().map(Signal::derivative).collect();
    let matrices = [
        matrix("A", &space.a, &derivatives, &space.states),
        matrix("B", &space.b, &derivatives, &space.inputs),
        matrix("C", &space.c, &space.outputs, &space.states),
        matrix("D", &space.d, &space.outputs, &space.inputs),
    ];
    super::about(design, [signals(space)].into_iter().chain(matrices).collect())
}

/// Where a state space is, as the end of a title.
pub fn at(space: &StateSpace) -> String {
    space.speed_text().map(|speed| format!(", at {speed}")).unwrap_or_default()
}

fn signals(space: &StateSpace) -> Table {
    let rows = [("state x", &space.states), ("input u", &space.inputs), ("output y", &space.outputs)];
    let row = |what: &str, signal: &Signal| {
        [what, &signal.name, &signal.label, &unit(&signal.unit)].map(Cell::words).to_vec()
    };
    Table {
        title: format!("State space x' = A x + B u, y = C x + D u{}", at(space)),
        columns: ["", "name", "", "unit"].map(Column::left).into(),
        rows: rows.iter().flat_map(|(what, signals)| signals.iter().map(|signal| row(what, signal))).collect(),
        notes: Vec::new(),
    }
}

fn matrix(name: &str, matrix: &DMatrix<f64>, rows: &[Signal], columns: &[Signal]) -> Table {
    let entry = |value: &f64| Cell::number(if *value == 0.0 { "0".to_owned() } else { fixed(*value, 6) });
    let row = |(index, signal): (usize, &Signal)| {
        std::iter::once(Cell::words(&signal.name)).chain(matrix.row(index).iter().map(entry)).collect()
    };
    Table {
        title: name.to_owned(),
        columns: [Column::left("")]
            .into_iter()
            .chain(columns.iter().map(|signal| Column::right(&signal.name)))
            .collect(),
        rows: rows.iter().enumerate().map(row).collect(),
        notes: Vec::new(),
    }
}
