//! How critical speeds change with the parameters, in each of the formats.

mod csv;
mod deviations;
mod json;
mod table;

use carvallo::CriticalKind;

pub use self::csv::write_csv;
pub use self::json::write_json;
pub use self::table::render_table;

use crate::analysis::kind;
use crate::sensitivity::Changes;

/// The name of each critical speed: its kind, with a number if there are more of the kind.
fn name_critical_speeds(changes: &Changes) -> Vec<String> {
    let kinds: Vec<CriticalKind> = changes.critical_speeds.iter().map(|critical| critical.speed.kind).collect();
    let name = |(index, of): (usize, &CriticalKind)| {
        let count = |kinds: &[CriticalKind]| kinds.iter().filter(|other| *other == of).count();
        let name = kind(*of, changes.design.info());
        if count(&kinds) == 1 { name.to_owned() } else { format!("{name} {}", count(&kinds[..=index])) }
    };
    kinds.iter().enumerate().map(name).collect()
}
