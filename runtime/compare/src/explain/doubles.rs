//! Two slips in the formula of one entry, where nothing else explains it.

use carvallo_slips::{FormulaSlip, Formulas, double_words, place};

use super::{ALIKE, AtDesign, Evidence, Explanation, entry_name};

/// What explains an entry as two slips in its formula; none where nothing does.
pub fn explain(evidence: &Evidence<'_>, slips: &[FormulaSlip], entry: usize) -> Option<Explanation> {
    let formulas = evidence.formulas?;
    let (matrix, row, column) = place(entry, formulas.count);
    let own = [formulas.entry(matrix, row, column)?];
    let first = evidence.designs.first()?;
    let value = (first.by_hand[entry], evidence.same * (first.sizes[entry] + first.by_hand[entry].abs()));
    let mut found = formulas.doubles(slips, &own, (&first.parameters, &first.values), value);
    found.retain(|(_, changed)| {
        evidence.designs.iter().all(|at| is_by_hand(evidence, formulas, at, (entry, changed, own[0])))
    });
    found.sort_by_key(|(double, changed)| (!formulas.makes_sense(own[0], changed), double.rank()));
    let text = formulas.formulas[own[0]].text;
    let words = found.iter().map(|(double, _)| double_words(&formulas.subject(&own), text, &double.slips));
    let mut causes: Vec<String> = Vec::new();
    words.for_each(|what| {
        if causes.len() < ALIKE && !causes.contains(&what) {
            causes.push(what);
        }
    });
    (!causes.is_empty()).then(|| Explanation { entries: vec![entry_name(formulas.count, entry)], causes })
}

fn is_by_hand(
    evidence: &Evidence<'_>,
    formulas: &Formulas,
    at: &AtDesign,
    (entry, changed, formula): (usize, &carvallo::Expression, usize),
) -> bool {
    let mut values = at.values.clone();
    formulas.change(&[formula], changed, &at.parameters, &mut values);
    at.is_by_hand(entry, values.entries[entry], evidence.same)
}
