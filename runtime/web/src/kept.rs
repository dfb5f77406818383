//! The designs that were asked about last, analyzed: while a slider moves, each is asked about several times, and while that of
//! the speed does, all of them are again and again.

use std::cell::RefCell;
use std::rc::Rc;

use carvallo_design::Failure;
use carvallo_plot::analysis::Analysis;

use crate::subject::Subject;

/// Enough for the designs that lie over each other, and for what the chosen one began with.
const MOST: usize = 8;

thread_local! {
    /// The one that was asked about last is the last.
    static KEPT: RefCell<Vec<(Subject, Rc<Analysis>)>> = const { RefCell::new(Vec::new()) };
}

/// The analysis of a design.
///
/// # Errors
/// Everything that is wrong with the parameters, or that there is none.
pub fn analysis(subject: Subject) -> Result<Rc<Analysis>, Failure> {
    KEPT.with_borrow_mut(|kept| {
        let analysis = match kept.iter().position(|(known, _)| *known == subject) {
            Some(place) => kept.remove(place).1,
            None => Rc::new(Analysis::new(subject.load()?)?),
        };
        if kept.len() == MOST {
            kept.remove(0);
        }
        kept.push((subject, Rc::clone(&analysis)));
        Ok(analysis)
    })
}
