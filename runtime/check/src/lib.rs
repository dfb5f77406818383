#![doc = include_str!("../README.md")]

pub mod conventions;
pub mod explain;
pub mod formula;
pub mod formulas;
pub mod given;
pub mod machine;
pub mod predict;
pub mod read;
mod report;
pub mod slips;
mod states;

use carvallo_design::Design;

pub use self::given::Given;
pub use self::report::{Comparison, Explanation, Group, Part, Report, Suspects, words};

use self::explain::{Cause, Found};
use self::machine::Machine;
use self::predict::Predictor;

/// Holds somebody's numbers against those of a design, and explains where they do not agree.
///
/// # Errors
/// That nothing was given; that a number is of what the model does not have, such as a third row of a matrix of two; or that
/// its formulas are not those of the design: matrices that are given themselves have none, nor has feedback.
pub fn check(given: &Given, design: &Design) -> Result<Report, String> {
    Ok(Report { machine: design.title(), ..check_machine(given, &Machine::new(design)?)? })
}

/// The same of a machine that is kept, with everything that may be mistaken about it, for several checks.
///
/// # Errors
/// As there.
pub fn check_machine(given: &Given, machine: &Machine) -> Result<Report, String> {
    given.fits(machine.info)?;
    let predictor = Predictor::new(given, machine.info);
    let here = predictor.predict(&machine.world());
    let found = |predictor: &Predictor| match predictor.agreeing(&here) == here.len() {
        true => Vec::new(),
        false => explain::explain(machine, predictor),
    };
    // Who cuts one number off cuts all of them: where more agree so, that is how they were made.
    let cut = given.cut_off(&mut |_| true);
    let of_cut = Predictor::new(&cut, machine.info);
    if of_cut.agreeing(&here) > predictor.agreeing(&here) {
        return Ok(Report::new(machine, &predictor, &of_cut, found(&of_cut)));
    }
    let explained = found(&predictor);
    // Or some of them were, by hand: likelier than any two causes, or a definition of another value, but not than one slip.
    let is_one = |found: &Found| matches!(found.causes[..], [Cause::Convention(_) | Cause::Slip(_)]);
    let some = given.cut_off(&mut |at| !predictor.agrees(at, here[at]) && of_cut.agrees(at, here[at]));
    let of_some = Predictor::new(&some, machine.info);
    if !explained.iter().any(is_one) && of_some.agreeing(&here) > predictor.agreeing(&here) {
        let others = found(&of_some);
        if explained.is_empty() || !others.is_empty() || of_some.agreeing(&here) == here.len() {
            return Ok(Report::new(machine, &predictor, &of_some, others));
        }
    }
    Ok(Report::new(machine, &predictor, &predictor, explained))
}
