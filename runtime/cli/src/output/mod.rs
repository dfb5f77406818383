//! The ways in which results are printed.

mod cells;
mod columns;
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
pub use self::list::render_bicycles;
pub use self::models::render_models;
pub use self::parameters::render_parameters;
pub use self::sketch::draw_sketch;
pub use self::table::render_table;

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
