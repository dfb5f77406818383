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

use carvallo_design::Design;

pub use self::given::Given;
pub use self::report::{Comparison, Explanation, Group, Report, Suspects};

/// Holds somebody's numbers against those of a design, and explains where they do not agree.
///
/// # Errors
/// That nothing was given; that a number is of what the model does not have, such as a third row of a matrix of two; or that
/// the model has no formulas, as matrices that are given themselves.
pub fn check(given: &Given, design: &Design) -> Result<Report, String> {
    given.fits(design.info())?;
    let machine = machine::Machine::new(design)?;
    let predictor = predict::Predictor::new(given, machine.info);
    let here = predictor.predict(&machine.world());
    let agrees = here.iter().enumerate().all(|(at, value)| predictor.agrees(at, *value));
    let found = if agrees { Vec::new() } else { explain::explain(&machine, &predictor) };
    Ok(Report::new(design.title(), &machine, &predictor, found))
}
