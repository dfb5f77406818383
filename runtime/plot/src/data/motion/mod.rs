//! A motion as JSON and as comma-separated values.

mod csv;
mod json;

pub use self::csv::write_csv;
pub use self::json::write_json;

use carvallo_design::DisplayUnit;
use carvallo_design::units::by_time;

use crate::analysis::simulation::Motion;

/// What something is shown in that is declared in a unit, or with the power 1 its rate, and with 2 its acceleration.
pub type Shown<'a> = &'a dyn Fn(&str, u32) -> DisplayUnit;

/// That all is shown as it is declared.
pub fn declared(unit: &str, power: u32) -> DisplayUnit {
    if power == 0 { DisplayUnit::declared(unit) } else { DisplayUnit::declared(&by_time(unit, power)) }
}

/// What positions, rates and accelerations are shown in.
fn units_of(motion: &Motion, shown: Shown) -> [Vec<DisplayUnit>; 3] {
    [0, 1, 2].map(|power| motion.quantities.iter().map(|quantity| shown(quantity.unit, power)).collect())
}
