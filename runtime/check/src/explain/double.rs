//! Two slips in one formula, where it is known what value they must make.

use super::{Cause, Found};
use crate::machine::Machine;
use crate::predict::Predictor;

/// The pairs of slips in a formula that make this value of it, within a tolerance, and with which everything fits.
pub fn find<'a>(machine: &Machine, predictor: &Predictor, formulas: &[usize], value: (f64, f64)) -> Vec<Found<'a>> {
    let here = (&machine.parameters[..], &machine.values);
    let mut found = Vec::new();
    for (double, changed) in machine.formulas.doubles(machine.slips(), formulas, here, value) {
        let mut values = machine.values.clone();
        machine.formulas.change(formulas, &changed, &machine.parameters, &mut values);
        let world = machine.world_from(values, &machine.parameters);
        if predictor.fits(&world) {
            found.push(Found { causes: vec![Cause::Slips(double)], world });
        }
    }
    found
}
