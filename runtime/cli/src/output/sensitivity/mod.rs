//! How critical speeds change with the parameters, in each of the formats.

mod csv;
mod deviations;
mod json;
mod table;

pub use self::csv::write_csv;
pub use self::json::write_json;
pub use self::table::render_table;

use crate::analysis;
use crate::sensitivity::Changes;

/// The name of each critical speed: its kind, with a number if there are more of the kind.
fn name_critical_speeds(changes: &Changes) -> Vec<String> {
    let info = changes.design.info();
    let names: Vec<&str> =
        changes.critical_speeds.iter().map(|critical| analysis::name(&critical.speed, info)).collect();
    let numbered = |(index, name): (usize, &&str)| {
        let count = |names: &[&str]| names.iter().filter(|other| *other == name).count();
        if count(&names) == 1 { (*name).to_owned() } else { format!("{name} {}", count(&names[..=index])) }
    };
    names.iter().enumerate().map(numbered).collect()
}
