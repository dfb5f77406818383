//! A state space for people, at a terminal.

use std::fmt::Write as _;

use carvallo::nalgebra::DMatrix;
use carvallo_control::{Signal, StateSpace};
use carvallo_design::Design;
use carvallo_design::number::{fixed, shortest, unit};

use crate::output::columns::width;
use crate::output::table::write_heading;
use crate::output::{FAINT, HEADING};

/// The names with their units, and the four matrices. Writing to a string cannot fail, so that the results of `write!` are
/// dropped throughout.
pub fn render_table(design: &Design, space: &StateSpace) -> String {
    let mut text = String::new();
    write_heading(design, &mut text);
    let at = space.speed.map(|speed| format!(", at {} m/s", shortest(speed))).unwrap_or_default();
    let _ = writeln!(text, "\n{HEADING}State space{HEADING:#}  x' = A x + B u, y = C x + D u{at}");
    for (what, signals) in [("states x", &space.states), ("inputs u", &space.inputs), ("outputs y", &space.outputs)] {
        let signals: Vec<String> = signals.iter().map(described).collect();
        let _ = writeln!(text, "  {what:<11}{}", signals.join(", "));
    }
    let derivatives: Vec<Signal> = space.states.iter().map(Signal::derivative).collect();
    for (name, matrix, rows, columns) in [
        ("A", &space.a, &derivatives, &space.states),
        ("B", &space.b, &derivatives, &space.inputs),
        ("C", &space.c, &space.outputs, &space.states),
        ("D", &space.d, &space.outputs, &space.inputs),
    ] {
        write_matrix(name, matrix, rows, columns, &mut text);
    }
    text
}

/// `lean rate phi_rate (rad/s)`
pub fn described(Signal { name, label, unit: declared }: &Signal) -> String {
    let label = if label == name { String::new() } else { format!("{label} ") };
    match unit(declared) {
        unit if unit.is_empty() => format!("{label}{name}"),
        unit => format!("{label}{name} ({unit})"),
    }
}

fn write_matrix(name: &str, matrix: &DMatrix<f64>, rows: &[Signal], columns: &[Signal], text: &mut String) {
    let entry = |value: &f64| if *value == 0.0 { "0".to_owned() } else { fixed(*value, 6) };
    let cells: Vec<Vec<String>> = matrix.row_iter().map(|row| row.iter().map(entry).collect()).collect();
    let first = width(rows.iter().map(|row| &row.name), 14) + 2;
    let widths: Vec<usize> = columns
        .iter()
        .enumerate()
        .map(|(column, signal)| width(cells.iter().map(|row| &row[column]).chain([&signal.name]), 14))
        .collect();
    let headings: String =
        columns.iter().zip(&widths).map(|(signal, width)| format!("{:>width$}", signal.name)).collect();
    let _ = writeln!(text, "\n  {HEADING}{name:<first$}{HEADING:#}{FAINT}{headings}{FAINT:#}");
    for (row, signal) in cells.iter().zip(rows) {
        let cells: String = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:>width$}")).collect();
        let _ = writeln!(text, "  {FAINT}{:<first$}{FAINT:#}{cells}", signal.name);
    }
}
