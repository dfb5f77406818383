//! Two slips in one formula, where it is known what value they must make.

use std::ops::Range;

use carvallo_slips::{FormulaSlip, Kind, Slip, terms};

use super::{Cause, Found};
use crate::machine::Machine;
use crate::predict::Predictor;

/// Two slips in one formula, the first of which stands before the second.
#[derive(Clone, Debug)]
pub struct DoubleSlip {
    /// The formulas that have them: the same text in several places of a matrix.
    pub formulas: Vec<usize>,
    /// The slips, in the order of the text.
    pub slips: [Slip; 2],
}

impl DoubleSlip {
    /// The formula with both.
    pub fn apply(&self, formula: &str) -> String {
        let [first, second] = &self.slips;
        first.apply(&second.apply(formula))
    }

    /// How unlikely they are.
    pub fn rank(&self) -> u32 {
        self.slips.iter().map(|slip| if is_likely(slip) { 2 } else { 5 }).sum()
    }
}

fn is_likely(slip: &Slip) -> bool {
    !matches!(slip.kind, Kind::OtherName | Kind::SumOrProduct)
}

/// A slip with what the formula is with it alone, and the term of it that it stands in, if it is in one.
struct Single<'a> {
    slip: &'a Slip,
    value: f64,
    term: Option<usize>,
}

/// The pairs of slips in a formula that make this value of it, within a tolerance, and with which everything fits. In one term one
/// at most is another name altogether, or a sum for a product.
pub fn find<'a>(
    machine: &Machine,
    predictor: &Predictor,
    formulas: &[usize],
    (value, tolerance): (f64, f64),
) -> Vec<Found<'a>> {
    let text = machine.formulas.formulas[formulas[0]].text;
    let here = machine.formulas.parse(text).map_or(f64::NAN, |own| machine.values.of(&own, &machine.parameters));
    let terms = terms(text);
    let single = |own: &'_ FormulaSlip| -> (f64, Option<usize>) {
        let is_in = |term: &Range<usize>| term.start <= own.slip.place.start && own.slip.place.end <= term.end;
        (machine.values.of(&own.changed, &machine.parameters), terms.iter().position(is_in))
    };
    let own = machine.slips().iter().filter(|slip| slip.formulas == formulas[..1]);
    let mut slips: Vec<Single> = own
        .map(|own| {
            let (value, term) = single(own);
            Single { slip: &own.slip, value, term }
        })
        .collect();
    slips.sort_by_key(|own| own.slip.place.start);
    let mut found = Vec::new();
    for (at, first) in slips.iter().enumerate() {
        for second in &slips[at + 1..] {
            if first.slip.place.end > second.slip.place.start {
                continue;
            }
            match first.term.zip(second.term) {
                // Terms are added, so that it is known what both make.
                Some((a, b)) if a != b => {
                    let both = first.value + second.value - here;
                    let rounding = 1e-9 * (first.value.abs() + second.value.abs() + here.abs());
                    if (both - value).abs() > tolerance + rounding {
                        continue;
                    }
                }
                _ if !(is_likely(first.slip) || is_likely(second.slip)) => continue,
                _ => {}
            }
            let double = DoubleSlip { formulas: formulas.to_vec(), slips: [first.slip.clone(), second.slip.clone()] };
            let Some(changed) = machine.formulas.parse(&double.apply(text)) else { continue };
            let both = machine.values.of(&changed, &machine.parameters);
            if (both - value).abs() > tolerance || machine.formulas.is_circular(formulas, &changed) {
                continue;
            }
            let mut values = machine.values.clone();
            machine.formulas.change(formulas, &changed, &machine.parameters, &mut values);
            let world = machine.world_from(values.entries, &machine.parameters);
            if predictor.fits(&world) {
                found.push(Found { causes: vec![Cause::Slips(double)], world });
            }
        }
    }
    found
}
