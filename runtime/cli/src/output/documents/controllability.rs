//! Modal controllability and observability, in tables.

use carvallo::Complex;
use carvallo_design::DisplayUnit;
use carvallo_design::number::{fixed, shortest};
use carvallo_plot::analysis::controllability::{AtSpeed, Controllability, LostTo};

use crate::output::typeset::{Cell, Column, Document, Table};

/// Where modes get lost up to a speed, and the cosines at each speed.
pub fn of_controllability(controllability: &Controllability, lost: &[LostTo], most: f64, rows: &[AtSpeed]) -> Document {
    let design = &controllability.analysis.design;
    let moves = design.model.depends_on_speed();
    let mut tables = Vec::new();
    if moves {
        tables.push(of_lost(lost, most, &controllability.analysis.unit));
    }
    tables.push(of_modes(controllability, rows, moves));
    super::about(design, tables)
}

fn of_lost(lost: &[LostTo], most: f64, unit: &DisplayUnit) -> Table {
    let row = |of: &LostTo| {
        let what = if of.is_input { "out of reach of" } else { "out of sight of" };
        let name = of.name.clone();
        of.lost
            .iter()
            .map(move |lost| {
                let speed = Cell::number(shortest(unit.value(lost.speed)));
                vec![speed, Cell::number(eigenvalue(lost.eigenvalue)), Cell::words(what), Cell::words(name.clone())]
            })
            .collect::<Vec<_>>()
    };
    let rows: Vec<Vec<Cell>> = lost.iter().flat_map(row).collect();
    let notes = if rows.is_empty() { vec!["none".to_owned()] } else { Vec::new() };
    let columns = vec![
        Column::right(format!("v ({})", unit.unit())),
        Column::right("eigenvalue (1/s)"),
        Column::left("the mode is"),
        Column::left(""),
    ];
    let title = format!("Speeds at which a mode is lost, up to {} {}", shortest(unit.value(most)), unit.unit());
    Table { title, columns, rows, notes }
}

fn of_modes(controllability: &Controllability, rows: &[AtSpeed], moves: bool) -> Table {
    let unit = &controllability.analysis.unit;
    let cosine = |value: &f64| Cell::number(if *value == 0.0 { "0".to_owned() } else { fixed(*value, 4) });
    let row = |row: &AtSpeed| {
        let shown = row.modes.iter().filter(|(mode, _)| mode.value.im >= 0.0);
        let speed = moves.then(|| Cell::number(shortest(unit.value(row.speed))));
        shown
            .map(|(mode, measures)| {
                let name = Cell::words(mode.mode.to_string());
                let head = speed.iter().cloned().chain([name, Cell::number(eigenvalue(mode.value))]);
                let cosines = measures.controllability.iter().chain(&measures.observability);
                head.chain(cosines.map(cosine)).collect::<Vec<_>>()
            })
            .collect::<Vec<_>>()
    };
    let head = [Column::left("mode"), Column::right("eigenvalue (1/s)")];
    let signals = controllability.inputs.iter().chain(&controllability.outputs);
    Table {
        title: "Modes  cosines of left eigenvectors with inputs, and of right ones with outputs".to_owned(),
        columns: moves
            .then(|| Column::right(format!("v ({})", unit.unit())))
            .into_iter()
            .chain(head)
            .chain(signals.map(|signal| Column::right(&signal.name)))
            .collect(),
        rows: rows.iter().flat_map(row).collect(),
        notes: Vec::new(),
    }
}

/// A real one, or the pair that it is half of.
fn eigenvalue(value: Complex<f64>) -> String {
    let re = fixed(value.re, 4);
    if value.im == 0.0 { re } else { format!("{re} ± {} i", fixed(value.im, 4)) }
}
