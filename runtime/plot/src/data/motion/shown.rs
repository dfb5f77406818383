//! What a motion is written in.

use carvallo_design::DisplayUnit;
use carvallo_design::units::Units;

use crate::analysis::simulation::{Motion, Quantity};

/// The units of everything in a row, in its order.
pub struct Shown {
    pub positions: Vec<DisplayUnit>,
    pub rates: Vec<DisplayUnit>,
    pub accelerations: Vec<DisplayUnit>,
    pub energy: DisplayUnit,
    pub feedback: Vec<DisplayUnit>,
    pub contact_forces: DisplayUnit,
    has_energy: bool,
    wheels: usize,
}

impl Shown {
    /// What is not in a motion is not shown in anything.
    pub fn new(motion: &Motion, units: &Units) -> Self {
        let of_each = |unit: &dyn Fn(&Quantity) -> DisplayUnit| motion.quantities.iter().map(unit).collect();
        let has_energy = motion.rows.iter().any(|row| row.energy.is_some());
        let if_any = |is_there: bool, declared: &str| {
            if is_there { units.of(declared) } else { DisplayUnit::declared(declared) }
        };
        Self {
            positions: of_each(&|quantity| units.of(quantity.unit)),
            rates: of_each(&|quantity| units.by_time(quantity.unit, 1, None)),
            accelerations: of_each(&|quantity| units.by_time(quantity.unit, 2, None)),
            energy: match if_any(has_energy, "N*m") {
                energy if energy.is_declared() => DisplayUnit::declared("J"),
                energy => energy,
            },
            feedback: motion.feedback().iter().map(|(_, unit)| units.of(unit)).collect(),
            contact_forces: if_any(!motion.wheels.is_empty(), "N"),
            has_energy,
            wheels: motion.wheels.len(),
        }
    }

    /// Those of the columns of a table, of which the first is the time.
    pub fn columns(self) -> Vec<DisplayUnit> {
        let energies = if self.has_energy { 2 } else { 0 };
        std::iter::once(DisplayUnit::declared("s"))
            .chain(self.positions)
            .chain(self.rates)
            .chain(self.accelerations)
            .chain(std::iter::repeat_n(self.energy, energies))
            .chain(self.feedback)
            .chain(std::iter::repeat_n(self.contact_forces, 3 * self.wheels))
            .collect()
    }
}

/// Values, each in a unit of its own.
pub fn values<'a>(units: &'a [DisplayUnit], values: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
    // Adding zero turns -0 into 0.
    units.iter().zip(values).map(|(unit, value)| unit.value(*value) + 0.0)
}
