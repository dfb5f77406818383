//! Numbers that may be rounded or cut off: what explains them in either way.

use super::{Found, Search};
use crate::given::Given;
use crate::machine::Machine;
use crate::predict::Predictor;

/// What explains numbers, and how they are meant where some of them are cut off.
pub struct Explained<'a> {
    /// Nothing where nothing does, or where numbers that are cut off need no other cause.
    pub found: Vec<Found<'a>>,
    /// The numbers with those cut off that are.
    pub cut: Option<Given>,
}

/// Searches for what makes numbers that do not agree.
pub fn explain<'a>(given: &Given, machine: &'a Machine) -> Explained<'a> {
    let rounded = Predictor::new(given, machine);
    let here = rounded.predict(&machine.world());
    // Numbers that may have been cut off: some of them, by hand, or all.
    let all = given.cut_off(&mut |_| true);
    let of_all = Predictor::new(&all, machine);
    let some = given.cut_off(&mut |at| !rounded.agrees(at, here[at]) && of_all.agrees(at, here[at]));
    let of_some = Predictor::new(&some, machine);
    if of_some.agreeing(&here) == rounded.agreeing(&here) {
        return Explained { found: Search::new(machine, &rounded, &rounded).explain(&rounded), cut: None };
    }
    let any = given.in_any_way();
    let of_any = Predictor::new(&any, machine);
    let search = Search::new(machine, &rounded, &of_any);
    let is_one_cause = search.has_one_cause(&rounded);
    // Who cuts off needs no other cause; but a slip that makes the very same numbers is told beside that.
    if of_some.agreeing(&here) == here.len() {
        let found = if is_one_cause { search.explain(&rounded) } else { Vec::new() };
        return Explained { found, cut: Some(some) };
    }
    // One slip or convention is likelier than it beside a slip; two causes, or a definition of another value, are not.
    if !is_one_cause {
        for (cut, own) in [(&of_all, &all), (&of_some, &some)] {
            if cut.agreeing(&here) > rounded.agreeing(&here) {
                let found = search.explain(cut);
                if !found.is_empty() {
                    return Explained { found, cut: Some(own.clone()) };
                }
            }
        }
    }
    let found = search.explain(&rounded);
    let cut = found.is_empty().then(|| some.clone());
    Explained { found, cut }
}
