//! Eigenvectors for people: for each mode the size and the phase of each coordinate.

use std::fmt::Write as _;

use carvallo::{Complex, CoordinateInfo, ModeValue, States};
use carvallo_design::Shape;
use carvallo_design::number::{fixed, shortest};
use carvallo_plot::analysis::{Analysis, Rows};

use super::columns::width;
use super::{FAINT, HEADING};

/// The eigenvectors at each of some speeds, of pairs those of the half with a positive imaginary part.
///
/// Writing to a string cannot fail, so that the results of `write!` are dropped.
pub fn write_shapes(analysis: &Analysis, rows: &Rows, shapes: &[Vec<Shape>], text: &mut String) {
    let _ = writeln!(
        text,
        "\n{HEADING}Eigenvectors{HEADING:#}  sizes relative to the largest, and by how many degrees each leads it"
    );
    let coordinates = coordinates(analysis);
    for ((speed, values), shapes) in rows.values().into_iter().zip(shapes) {
        let rows = cells(values, shapes);
        let first = width(rows.iter().map(|(name, _)| name), 10) + 2;
        let columns: Vec<usize> = (0..coordinates.len())
            .map(|index| width(rows.iter().map(|(_, cells)| &cells[index]).chain([&coordinates[index]]), 12) + 1)
            .collect();
        let at = at(analysis, speed);
        let titles: String = coordinates.iter().zip(&columns).map(|(name, width)| format!("{name:>width$}")).collect();
        let _ = writeln!(text, "  {FAINT}{at:<first$}{titles}{FAINT:#}");
        for (name, cells) in &rows {
            let cells: String = cells.iter().zip(&columns).map(|(cell, width)| format!("{cell:>width$}")).collect();
            let _ = writeln!(text, "  {name:<first$}{cells}");
        }
    }
}

/// What stands above the column of each coordinate.
pub fn coordinates(analysis: &Analysis) -> Vec<String> {
    let coordinates = analysis.design.info().coordinates.iter();
    let heading = |coordinate: &CoordinateInfo| {
        let name = coordinate.name;
        if coordinate.states == States::Rate { format!("{name}\u{2019}") } else { name.to_owned() }
    };
    coordinates.map(heading).collect()
}

/// Each eigenvalue that is shown, and the size and phase of each coordinate.
pub fn cells(values: &[ModeValue], shapes: &[Shape]) -> Vec<(String, Vec<String>)> {
    let shown = values.iter().zip(shapes).filter(|(value, _)| value.value.im >= 0.0);
    shown.map(|(value, shape)| (eigenvalue(value), shape.right.iter().copied().map(phasor).collect())).collect()
}

/// The speed that eigenvectors are at.
pub fn at(analysis: &Analysis, speed: f64) -> String {
    let moves = analysis.design.model.depends_on_speed();
    if moves {
        format!("at {} {}", shortest(analysis.unit.value(speed)), analysis.unit.written)
    } else {
        "at every speed".to_owned()
    }
}

/// Its name, where it has one, and its value.
fn eigenvalue(ModeValue { mode, value }: &ModeValue) -> String {
    let im = if value.im == 0.0 { String::new() } else { format!(" + {} i", fixed(value.im, 4)) };
    format!("{mode} {}{im}", fixed(value.re, 4))
}

/// `0.5312 at -32.1°`, and without a phase what is the largest or not there.
fn phasor(value: Complex<f64>) -> String {
    let degrees = value.arg().to_degrees();
    match value.norm() {
        0.0 => "0".to_owned(),
        size if value.im == 0.0 && value.re > 0.0 => format!("{}         ", fixed(size, 4)),
        size => format!("{} at {degrees:>5.0}°", fixed(size, 4)),
    }
}
