#![doc = include_str!("../README.md")]

mod behind;
pub mod conventions;
pub mod explain;
mod form;
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

use self::explain::{Cause, Explained, Found};
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
    let own = Predictor::new(given, machine);
    let here = own.predict(&machine.world());
    if own.agreeing(&here) == here.len() {
        return Ok(Report::new(machine, &own, &own, Vec::new(), None));
    }
    if !given::contradictions(given, machine.info).is_empty() {
        return Ok(Report::new(machine, &own, &own, Vec::new(), Some(Suspects::new(machine, &own, &[]))));
    }
    if let Some((mended, told)) = form::mended(given, machine.info) {
        return Ok(check_mended(given, &mended, told, machine));
    }
    let Explained { found, cut } = explain::explain(given, machine);
    let cut = cut.as_ref().map(|own| Predictor::new(own, machine));
    let meant = cut.as_ref().unwrap_or(&own);
    let is_whole = meant.agreeing(&here) == here.len();
    let suspects = (!is_whole && found.is_empty()).then(|| Suspects::new(machine, meant, &[]));
    Ok(Report::new(machine, &own, meant, found, suspects))
}

/// Of state matrices that are transposed or negative as a whole: that, and what explains them beside it.
fn check_mended(given: &Given, mended: &Given, told: Vec<String>, machine: &Machine) -> Report {
    let own = Predictor::new(given, machine);
    let meant = Predictor::new(mended, machine);
    let here = meant.predict(&machine.world());
    let mut found = match meant.agreeing(&here) == here.len() {
        true => vec![Found { causes: Vec::new(), world: machine.world() }],
        false => explain::explain(mended, machine).found,
    };
    let suspects = found.is_empty().then(|| Suspects::new(machine, &meant, &told));
    let causes: Vec<Cause> = told.into_iter().map(Cause::Written).collect();
    found.iter_mut().for_each(|own| own.causes = [&causes[..], &own.causes[..]].concat());
    Report::new(machine, &own, &own, found, suspects)
}
