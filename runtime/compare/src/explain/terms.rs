//! Guesses at one slip in one formula.

use super::{AtDesign, Evidence, Guess, entry_name};
use crate::formula::slips;

/// Every single slip of every formula.
pub fn guesses<'a>(evidence: &'a Evidence<'_>) -> impl Iterator<Item = Guess<'a>> + use<'a> {
    let n = evidence.n();
    evidence.equations.into_iter().flat_map(move |equations| {
        slips(equations).map(move |slip| {
            let equation = &equations.all[slip.equation];
            let of = match equation.definition {
                Some(name) => name.to_owned(),
                None => {
                    let names: Vec<String> = equation.positions.iter().map(|entry| entry_name(n, *entry)).collect();
                    names.join(" = ")
                }
            };
            let what = format!("in `{of} = {}` {}: `{}`", equation.formula, slip.what, slip.formula);
            let entries = move |at: &AtDesign| equations.entries_with(&at.parameters, &slip);
            Guess { what, of_entries: true, is_another: true, entries: Box::new(entries) }
        })
    })
}
