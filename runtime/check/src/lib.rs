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

use self::machine::Machine;

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
    let predictor = predict::Predictor::new(given, machine.info);
    let here = predictor.predict(&machine.world());
    let agrees = here.iter().enumerate().all(|(at, value)| predictor.agrees(at, *value));
    let found = if agrees { Vec::new() } else { explain::explain(machine, &predictor) };
    Ok(Report::new(machine, &predictor, found))
}
