//! Numbers that may be rounded or cut off: what explains them in either way.

use super::{Cause, Found, Search, Which};
use crate::given::Given;
use crate::machine::Machine;
use crate::predict::Predictor;

/// From so many numbers on that are cut off by themselves nobody rounds.
const SURE: usize = 2;
/// How much unlikelier it is that all numbers are cut off where none shows it by itself.
const UNLIKELY: u32 = 2;

/// What explains numbers, and how they are meant where some of them are cut off.
pub struct Explained<'a> {
    /// Nothing where nothing does, or where numbers that are cut off need no other cause.
    pub found: Vec<Found<'a>>,
    /// The numbers with those cut off that are.
    pub cut: Option<Given>,
    /// Whether the search was stopped by what it costs before everything was tried.
    pub is_short: bool,
}

/// Searches for what makes numbers that do not agree; of those that `are_of_elsewhere` in part one cause alone is searched for.
pub fn explain<'a>(given: &Given, machine: &'a Machine, are_of_elsewhere: &dyn Fn() -> bool) -> Explained<'a> {
    let rounded = Predictor::new(given, machine);
    let here = rounded.predict(&machine.world());
    // Numbers that may have been cut off: some of them, by hand, or all.
    let all = given.cut_off(&mut |_| true);
    let of_all = Predictor::new(&all, machine);
    let some = given.cut_off(&mut |at| !rounded.agrees(at, here[at]) && of_all.agrees(at, here[at]));
    let of_some = Predictor::new(&some, machine);
    // So many numbers are here as they are given, but cut off and not rounded.
    let shown = of_some.agreeing(&here) - rounded.agreeing(&here);
    let any = given.in_any_way();
    let of_any = Predictor::new(&any, machine);
    let search = Search::new(machine, &rounded, &of_any);
    let is_short = || [&rounded, &of_all, &of_some, &of_any].iter().any(|own| own.is_short());
    let explained = |found: Vec<Found<'a>>, cut: Option<Given>| Explained { found, cut, is_short: is_short() };
    let mut one = search.by_one(&rounded);
    // Who cuts off needs no other cause; but a slip that makes the very same numbers is told beside that.
    if shown > 0 && of_some.agreeing(&here) == here.len() {
        let found = if search.has_one_cause(&rounded) { one } else { Vec::new() };
        return explained(found, Some(some.clone()));
    }
    let mut of_cut = if all == *given { Vec::new() } else { search.by_one(&of_all) };
    of_cut.retain(|own| shown > 0 || own.is_plain());
    one.retain(|own| own.is_plain() || of_cut.is_empty());
    if shown >= SURE && !of_cut.is_empty() {
        one.clear();
    }
    let best = |found: &[Found]| found.iter().map(|own| own.rank(machine)).min();
    match (best(&one), best(&of_cut)) {
        (None, Some(_)) if shown > 0 => return explained(of_cut, Some(all.clone())),
        (one_rank, Some(cut_rank)) => {
            let unlikely = if shown > 0 { 0 } else { UNLIKELY };
            if shown > 0 || one_rank.is_none_or(|rank| cut_rank + unlikely < rank) {
                of_cut.iter_mut().for_each(|own| own.causes.push(Cause::CutOff(unlikely, Which::All)));
                one.extend(of_cut);
            }
            return explained(one, None);
        }
        (Some(_), None) => return explained(one, None),
        (None, None) => {}
    }
    if shown == 0 && are_of_elsewhere() {
        return explained(Vec::new(), None);
    }
    if shown == 0 {
        return explained(search.of_rounded().explain(&rounded), None);
    }
    // It is likelier that all or some are cut off than that there are two causes, or a definition of another value.
    for (cut, own) in [(&of_all, &all), (&of_some, &some)] {
        if cut.agreeing(&here) > rounded.agreeing(&here) {
            let found = search.explain(cut);
            if !found.is_empty() {
                return explained(found, Some(own.clone()));
            }
        }
    }
    let found = search.explain(&rounded);
    let cut = found.is_empty().then(|| some.clone());
    explained(found, cut)
}
