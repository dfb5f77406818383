//! A motion in other units, for programs.

use carvallo_design::number::by_time;
use carvallo_design::units::Units;
use carvallo_plot::analysis::simulation::Motion;

/// The motion with positions in other units, and rates and accelerations in their own or in these by time.
///
/// What units are called stays in memory as long as the program runs, as names of models do.
pub fn in_units<'a>(mut motion: Motion<'a>, units: &Units) -> Motion<'a> {
    for (place, quantity) in motion.quantities.iter_mut().enumerate() {
        let position = units.of(quantity.unit);
        let [rate, acceleration] = [1, 2].map(|power| units.by_time(quantity.unit, power, None));
        for row in &mut motion.rows {
            row.positions[place] = position.value(row.positions[place]);
            row.rates[place] = rate.value(row.rates[place]);
            row.accelerations[place] = acceleration.value(row.accelerations[place]);
        }
        for ((own, shown), power) in quantity.by_time.iter_mut().zip([rate, acceleration]).zip([1, 2]) {
            let is_own = shown.written != by_time(&position.written, power);
            *own = is_own.then(|| &*String::leak(shown.written));
        }
        if !position.is_declared() {
            quantity.unit = String::leak(position.written);
        }
    }
    motion
}
