//! A motion in other units, for programs.

use carvallo_design::units::Units;
use carvallo_plot::analysis::simulation::Motion;

/// The motion with positions in other units, and rates and accelerations in these by time.
///
/// What units are called stays in memory as long as the program runs, as names of models do.
pub fn in_units<'a>(mut motion: Motion<'a>, units: &Units) -> Motion<'a> {
    for (place, quantity) in motion.quantities.iter_mut().enumerate() {
        let unit = units.of(quantity.unit);
        if unit.is_declared() {
            continue;
        }
        for row in &mut motion.rows {
            for values in [&mut row.positions, &mut row.rates, &mut row.accelerations] {
                values[place] = unit.value(values[place]);
            }
        }
        quantity.unit = String::leak(unit.written);
    }
    motion
}
