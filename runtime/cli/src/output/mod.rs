//! The ways in which results are printed.

mod csv;
mod json;
mod list;
mod parameters;
mod sketch;
mod table;

pub use self::csv::csv;
pub use self::json::json;
pub use self::list::list;
pub use self::parameters::parameters;
pub use self::sketch::sketch;
pub use self::table::table;

use std::ops::Index;

use anstyle::{AnsiColor, Style};
use carvallo::{Coefficients, StableRange};

/// Styles of the terminal; they are stripped where the output is not a terminal.
const HEADING: Style = Style::new().bold();
const GOOD: Style = AnsiColor::Green.on_default();
const FAINT: Style = Style::new().dimmed();

/// The matrices that a bicycle's equations have, with the names and units that the paper gives them.
fn matrices(coefficients: &Coefficients<f64, 2>) -> [(&'static str, &'static str, [[f64; 2]; 2]); 4] {
    let Coefficients { m, c1, k0, k2, .. } = coefficients;
    [("M", "kg m²", rows(m)), ("C1", "kg m", rows(c1)), ("K0", "kg m", rows(k0)), ("K2", "kg", rows(k2))]
}

fn rows(matrix: &impl Index<(usize, usize), Output = f64>) -> [[f64; 2]; 2] {
    [0, 1].map(|row| [0, 1].map(|column| matrix[(row, column)]))
}

/// Whether one of the ranges holds the speed.
fn is_stable(ranges: &[StableRange], speed: f64) -> bool {
    ranges.iter().any(|range| range.from < speed && range.to.is_none_or(|to| speed < to))
}

/// A string in quotes, as JSON and TOML both read it.
fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for char in text.chars() {
        match char {
            '"' | '\\' => quoted.extend(['\\', char]),
            char if char.is_control() => quoted.push_str(&format!("\\u{:04x}", u32::from(char))),
            char => quoted.push(char),
        }
    }
    quoted.push('"');
    quoted
}
