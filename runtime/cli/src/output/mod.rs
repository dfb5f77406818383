//! The ways in which results are printed.

mod cells;
mod csv;
mod equations;
mod json;
mod layout;
mod list;
mod models;
mod parameters;
pub mod sensitivity;
mod sketch;
mod sorted;
mod table;

pub use self::csv::write_csv;
pub use self::json::write_json;
pub use self::list::list;
pub use self::models::models;
pub use self::parameters::parameters;
pub use self::sketch::sketch;
pub use self::table::table;

use anstyle::{AnsiColor, Style};
use carvallo::StableRange;

/// Styles of the terminal; they are stripped where the output is not a terminal.
const HEADING: Style = Style::new().bold();
const GOOD: Style = AnsiColor::Green.on_default();
const FAINT: Style = Style::new().dimmed();

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
