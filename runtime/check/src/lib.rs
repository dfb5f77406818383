#![doc = include_str!("../README.md")]

mod behind;
pub mod conventions;
pub mod explain;
pub mod given;
pub mod machine;
mod motion;
pub mod predict;
pub mod read;
mod relation;
mod report;
mod states;
mod zero;

use carvallo_design::Design;
use carvallo_design::units::Units;

pub use self::given::Given;
pub use self::report::{Behind, Comparison, Explanation, Group, Part, Report, Suspects, words};

use self::explain::Search;
use self::machine::Machine;
use self::predict::Predictor;

/// Holds somebody's numbers against those of a design, and explains where they do not agree.
///
/// # Errors
/// That nothing was given; that a number is of what the model does not have, such as a third row of a matrix of two; or that
/// its formulas are not known: matrices that are given themselves have none.
pub fn check(given: &Given, design: &Design) -> Result<Report, String> {
    check_in(given, design, Units::default())
}

/// The same with a report in other units than those of the SI; the numbers that are given are in these.
///
/// # Errors
/// As there.
pub fn check_in(given: &Given, design: &Design, units: Units) -> Result<Report, String> {
    let mut machine = Machine::new(design)?;
    machine.units = units;
    Ok(Report { machine: design.title(), ..check_machine(given, &machine)? })
}

/// The same of a machine that is kept, with everything that may be mistaken about it, for several checks.
///
/// # Errors
/// As there.
pub fn check_machine(given: &Given, machine: &Machine) -> Result<Report, String> {
    given.fits(machine.info)?;
    let is_nonlinear = |own: &given::Accelerations| own.equations == Some(given::Kind::Nonlinear);
    if machine.motion.is_none() && given.accelerations.iter().any(is_nonlinear) {
        return Err(format!("the model {} has no nonlinear equations for accelerations", machine.info.name));
    }
    let rounded = Predictor::new(given, machine);
    let here = rounded.predict(&machine.world());
    if rounded.agreeing(&here) == here.len() {
        return Ok(Report::new(machine, &rounded, &rounded, Vec::new()));
    }
    // Numbers that may have been cut off: some of them, by hand, or all.
    let all = given.cut_off(&mut |_| true);
    let of_all = Predictor::new(&all, machine);
    let some = given.cut_off(&mut |at| !rounded.agrees(at, here[at]) && of_all.agrees(at, here[at]));
    let of_some = Predictor::new(&some, machine);
    if of_some.agreeing(&here) == rounded.agreeing(&here) {
        let found = Search::new(machine, &rounded, &rounded).explain(&rounded);
        return Ok(Report::new(machine, &rounded, &rounded, found));
    }
    let any = given.in_any_way();
    let of_any = Predictor::new(&any, machine);
    let search = Search::new(machine, &rounded, &of_any);
    let is_one_cause = search.has_one_cause(&rounded);
    // Who cuts off needs no other cause; but a slip that makes the very same numbers is told beside that.
    if of_some.agreeing(&here) == here.len() {
        let found = if is_one_cause { search.explain(&rounded) } else { Vec::new() };
        return Ok(Report::new(machine, &rounded, &of_some, found));
    }
    // One slip or convention is likelier than it beside a slip; two causes, or a definition of another value, are not.
    if !is_one_cause {
        for cut in [&of_all, &of_some] {
            if cut.agreeing(&here) > rounded.agreeing(&here) {
                let others = search.explain(cut);
                if !others.is_empty() {
                    return Ok(Report::new(machine, &rounded, cut, others));
                }
            }
        }
    }
    let explained = search.explain(&rounded);
    let meant = if explained.is_empty() { &of_some } else { &rounded };
    Ok(Report::new(machine, &rounded, meant, explained))
}
