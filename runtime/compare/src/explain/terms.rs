//! Guesses at one slip in one formula.

use carvallo_slips::{FormulaSlip, slip_words};

use super::{AtDesign, Evidence, Guess};

/// Every single slip of every formula, the likeliest first.
pub fn guesses<'a>(evidence: &'a Evidence<'_>) -> impl Iterator<Item = Guess<'a>> + use<'a> {
    evidence.formulas.into_iter().flat_map(move |formulas| {
        let mut slips = formulas.slips();
        slips.sort_by_key(FormulaSlip::rank);
        slips.into_iter().map(move |slip| {
            let text = formulas.formulas[slip.formulas[0]].text;
            let what = slip_words(&formulas.subject(&slip.formulas), text, &slip.slip);
            let entries = move |at: &AtDesign| {
                let mut values = at.values.clone();
                slip.apply(formulas, &at.parameters, &at.values, &mut values).then_some(values.entries)
            };
            Guess { what, of_entries: true, is_another: true, entries: Box::new(entries) }
        })
    })
}
