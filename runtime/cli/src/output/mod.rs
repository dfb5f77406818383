//! The ways in which results are printed.

mod along;
mod branches;
mod columns;
pub mod documents;
mod equations;
pub mod list;
mod models;
pub mod motion;
mod ranges;
pub mod sensitivity;
mod shapes;
mod sketch;
mod sorted;
mod table;
pub mod turns;
pub mod typeset;

pub use self::along::render_along;
pub use self::list::render_bicycles;
pub use self::models::render_models;
pub use self::sketch::draw_sketch;
pub use self::table::render_table;

use anstyle::{AnsiColor, Style};
use carvallo_design::Design;
use carvallo_design::units::Units;

/// Styles of the terminal; they are stripped where the output is not a terminal.
const HEADING: Style = Style::new().bold();
const GOOD: Style = AnsiColor::Green.on_default();
const FAINT: Style = Style::new().dimmed();

/// The parameters of a design as a file, with comments that stand back.
pub fn render_parameters(design: &Design, units: &Units) -> String {
    carvallo_design::file::write_in(design, &|declared| units.of(declared), &faint)
}

/// A text that stands back.
pub fn faint(text: &str) -> String {
    format!("{FAINT}{text}{FAINT:#}")
}
