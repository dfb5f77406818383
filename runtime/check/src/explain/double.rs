//! Two slips in one formula, where it is known what value they must make.

use super::{Cause, Found};
use crate::machine::Machine;
use crate::predict::Predictor;
use crate::slips::{Kind, Slip};

/// Two slips in one formula, the first of which stands before the second.
#[derive(Clone, Debug)]
pub struct DoubleSlip {
    /// The formula.
    pub formula: usize,
    /// The slips, in the order of the text.
    pub slips: [Slip; 2],
}

impl DoubleSlip {
    /// The formula with both.
    pub fn apply(&self, formula: &str) -> String {
        let [first, second] = &self.slips;
        first.apply(&second.apply(formula))
    }
}

/// The pairs of slips in a definition that make about this value of it, and with which everything fits. Of two names one at
/// most is another one altogether.
pub fn find<'a>(machine: &Machine, predictor: &Predictor, definition: usize, value: f64) -> Vec<Found<'a>> {
    let text = machine.formulas.formulas[definition].text;
    let own = machine.slips().iter().filter(|slip| slip.formulas == [definition]);
    let mut slips: Vec<&Slip> = own.map(|slip| &slip.slip).collect();
    slips.sort_by_key(|slip| slip.place.start);
    let is_likely = |slip: &Slip| !matches!(slip.kind, Kind::OtherName | Kind::SumOrProduct);
    let mut found = Vec::new();
    for (at, &first) in slips.iter().enumerate() {
        for &second in &slips[at + 1..] {
            if first.place.end > second.place.start || !(is_likely(first) || is_likely(second)) {
                continue;
            }
            let double = DoubleSlip { formula: definition, slips: [first.clone(), second.clone()] };
            let Some(changed) = machine.formulas.parse(&double.apply(text)) else { continue };
            let here = machine.values.of(&changed, &machine.parameters);
            if (here - value).abs() > 1e-2 * value.abs() || machine.formulas.is_circular(&[definition], &changed) {
                continue;
            }
            let mut values = machine.values.clone();
            machine.formulas.change(&[definition], &changed, &machine.parameters, &mut values);
            let world = machine.world_from(values.entries, &machine.parameters);
            if predictor.fits(&world) {
                found.push(Found { causes: vec![Cause::Slips(double)], world });
            }
        }
    }
    found
}
