//! Guesses at what was done to single entries.

use carvallo_slips::place;

use super::factor::{Factor, factors};
use super::{Evidence, Guess, Place, entry_name, position};

pub fn guesses(evidence: &Evidence<'_>, wrong: &[usize]) -> Vec<Guess<'static>> {
    let all = wrong.iter().flat_map(|entry| of_entry(evidence, *entry, wrong));
    // An entry may be told in the words of its matrix already.
    all.map(|guess| Guess { of_entries: true, is_another: false, ..guess }).collect()
}

/// Exchanged with another wrong entry of its matrix, a factor, or another entry in its place.
fn of_entry(evidence: &Evidence<'_>, entry: usize, wrong: &[usize]) -> Vec<Guess<'static>> {
    let (info, n) = (evidence.info, evidence.n());
    let (here, name) = (place(entry, n), entry_name(n, entry));
    let instead = move |from: Place| move |to: Place| (to == here).then_some(from);
    let mut all = Vec::new();
    for other in wrong.iter().filter(|other| **other > entry && place(**other, n).0 == here.0) {
        let there = place(*other, n);
        let both = move |to: Place| match to {
            _ if to == here => Some(there),
            _ if to == there => Some(here),
            _ => None,
        };
        let what = format!("{name} and {} are exchanged", entry_name(n, *other));
        all.push(Guess::moved(n, what, Factor::ONE, both));
    }
    for factor in factors(info).chain(ratio(evidence, entry)) {
        all.push(Guess::moved(n, format!("{name} {}", factor.says(info)), factor, instead(here)));
    }
    for there in (0..n * n).map(|index| (here.0, index / n, index % n)) {
        let what = format!("{name} is what {} is to be", entry_name(n, position(n, there)));
        all.push(Guess::moved(n, what.clone(), Factor::ONE, instead(there)));
        all.push(Guess::moved(n, format!("{what}, with the opposite sign"), Factor::MINUS, instead(there)));
    }
    all
}

/// A number by which an entry is too large, whatever it is.
fn ratio(evidence: &Evidence<'_>, entry: usize) -> Option<Factor> {
    let at = evidence.designs.iter().find(|at| at.exact[entry] != 0.0)?;
    // No more digits than differences are told by.
    let digits = 10_f64.powf((0.1 / evidence.same).log10().round());
    let ratio = (at.by_hand[entry] / at.exact[entry] * digits).round() / digits;
    (ratio.is_finite() && ratio != 0.0).then_some(Factor::Number(ratio))
}
