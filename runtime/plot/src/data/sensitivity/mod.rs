//! How critical speeds change with the parameters, as JSON and as comma-separated values.

mod csv;
mod json;

pub use self::csv::write_csv;
pub use self::json::write_json;

use crate::analysis;
use crate::analysis::sensitivity::Changes;

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
