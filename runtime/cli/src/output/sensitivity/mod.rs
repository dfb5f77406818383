//! How critical speeds change with the parameters, in each of the formats.

mod csv;
mod deviations;
mod json;
mod table;

use carvallo::CriticalKind;

pub use self::csv::write_csv;
pub use self::json::write_json;
pub use self::table::render_table;

use crate::sensitivity::Changes;

/// The name of each critical speed: its kind, with a number if there are more of the kind.
fn name_critical_speeds(changes: &Changes) -> Vec<String> {
    let kinds: Vec<CriticalKind> = changes.critical_speeds.iter().map(|critical| critical.speed.kind).collect();
    let name = |(index, kind): (usize, &CriticalKind)| {
        let count = |kinds: &[CriticalKind]| kinds.iter().filter(|other| *other == kind).count();
        if count(&kinds) == 1 { kind.to_string() } else { format!("{kind} {}", count(&kinds[..=index])) }
    };
    kinds.iter().enumerate().map(name).collect()
}
