#![doc = include_str!("../README.md")]

mod behind;
pub mod conventions;
mod critical;
pub mod explain;
mod form;
mod frequencies;
pub mod given;
mod kinds;
pub mod machine;
mod motion;
pub mod predict;
pub mod read;
mod relation;
mod report;
mod states;
mod zero;

use carvallo::MatrixName;
use carvallo_design::Design;
use carvallo_design::units::Units;

pub use self::given::Given;
pub use self::report::{Behind, Comparison, Elsewhere, Explanation, Group, Part, Report, Suspects, words};

use self::explain::{Cause, Explained, Found, Search, Which};
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
    let mut speeds =
        given.state_matrices.iter().map(|own| own.speed).chain(given.eigenvalues.iter().map(|own| own.speed));
    if machine.gains().any(|gain| gain.matrix == MatrixName::Cm1) && speeds.any(|speed| speed == 0.0) {
        return Err("the feedback has 1/v in it, which has no value at 0 m/s, where numbers are given".to_owned());
    }
    let is_nonlinear = |own: &given::Accelerations| own.equations == Some(given::Kind::Nonlinear);
    if machine.motion.is_none() && given.accelerations.iter().any(is_nonlinear) {
        return Err(format!("the model {} has no nonlinear equations for accelerations", machine.info.name));
    }
    let Some(other) = Predictor::new(given, machine).by_other_equations(machine) else {
        return Ok(compare(given, machine));
    };
    // By which equations wrong accelerations are is a guess: one cause by the others is likelier than several by these, or a force on fewer
    // coordinates.
    let off = |given: &Given| explain::off(machine, &Predictor::new(given, machine));
    let has_form = |given: &Given| !in_another_form(given, &Predictor::new(given, machine), machine).is_empty();
    let is_likelier = || has_one_cause(&other, machine) || off(&other) < off(given);
    let is_other = || has_form(&other) || !has_one_cause(given, machine) && is_likelier();
    let [first, last] = match !has_form(given) && is_other() {
        true => [&other, given],
        false => [given, &other],
    };
    let found = compare(first, machine);
    let other = found.explanations.is_empty().then(|| compare(last, machine));
    Ok(other.filter(|other| !other.explanations.is_empty()).unwrap_or(found))
}

/// Whether a slip or a convention alone makes all numbers.
fn has_one_cause(given: &Given, machine: &Machine) -> bool {
    let machine = with_formulas_of(given, machine);
    let own = Predictor::new(given, machine);
    Search::new(machine, &own, &own).has_one_cause(&own)
}

/// The machine with a mechanism where accelerations are by its nonlinear equations.
fn with_formulas_of<'a>(given: &Given, machine: &'a Machine) -> &'a Machine {
    let own = Predictor::new(given, machine);
    machine.with_mechanism().filter(|_| own.has_nonlinear()).unwrap_or(machine)
}

fn compare(given: &Given, machine: &Machine) -> Report {
    let machine = with_formulas_of(given, machine);
    let own = Predictor::new(given, machine);
    let here = own.predict(&machine.world());
    if own.agreeing(&here) == here.len() {
        return Report::new(machine, &own, &own, Vec::new(), None);
    }
    let mended = form::mended(given, machine.info);
    if !given::contradictions(given, machine.info).is_empty() {
        let (meant, told) = mended.as_ref().map_or((given, &[][..]), |(meant, told)| (meant, told));
        let suspects = Suspects::new(machine, &Predictor::new(meant, machine), told);
        return Report::new(machine, &own, &own, Vec::new(), Some(suspects));
    }
    let is_whole = |given: &Given| {
        let own = Predictor::new(given, machine);
        own.agreeing(&own.predict(&machine.world())) == own.numbers().len()
    };
    let mended = form::others(given, machine.info).find(|(other, _)| is_whole(other)).or(mended);
    if let Some((mended, told)) = mended {
        return check_mended(given, &mended, told, machine);
    }
    let others = in_another_form(given, &own, machine);
    if !others.is_empty() {
        return Report::new(machine, &own, &own, others, None);
    }
    let Explained { found, cut, is_short } =
        explain::explain(given, machine, &|| Elsewhere::new(machine, &own, false).is_some());
    let cut = cut.as_ref().map(|own| Predictor::new(own, machine));
    let meant = cut.as_ref().unwrap_or(&own);
    let is_whole = meant.agreeing(&here) == here.len();
    let suspects = (!is_whole && found.is_empty()).then(|| Suspects::new(machine, meant, &[]));
    Report { stopped_short: is_short, ..Report::new(machine, &own, meant, found, suspects) }
}

/// What makes all numbers, of what was done to accelerations by the nonlinear equations as a whole, to the names of critical speeds and to
/// the unit of eigenvalues:
/// such causes change no parameters and no matrices, in which others are searched.
fn in_another_form<'a>(given: &Given, own: &Predictor, machine: &Machine) -> Vec<Found<'a>> {
    let motions = if own.has_nonlinear() { motion::forms::mended(given, machine.info) } else { Vec::new() };
    let forms = motions.into_iter().chain(kinds::exchanged(given)).chain(frequencies::in_seconds(given));
    let forms: Vec<_> = forms.collect();
    if forms.is_empty() {
        return Vec::new();
    }
    let world = machine.world();
    let makes_all = |other: &Given| {
        let own = Predictor::new(other, machine);
        let here = own.predict(&world);
        own.agreeing(&here) == here.len()
    };
    let all = forms.into_iter().filter(|(other, _)| makes_all(other));
    all.map(|(_, told)| Found { causes: vec![Cause::Written(told)], world: world.clone() }).collect()
}

/// Of state matrices that are transposed or negative as a whole: that, and what explains them beside it, as rounded or as cut off.
fn check_mended(given: &Given, mended: &Given, told: Vec<String>, machine: &Machine) -> Report {
    let own = Predictor::new(given, machine);
    let world = machine.world();
    let is_whole = |given: &Given| {
        let own = Predictor::new(given, machine);
        let here = own.predict(&world);
        own.agreeing(&here) == here.len()
    };
    let nothing = || Found { causes: Vec::new(), world: machine.world() };
    let Explained { mut found, cut, is_short } = match is_whole(mended) {
        true => Explained { found: vec![nothing()], cut: None, is_short: false },
        false => explain::explain(mended, machine, &|| false),
    };
    if let Some(cut) = &cut {
        let is_cut = is_whole(cut);
        if is_cut {
            // What explains the numbers as rounded, too, goes behind.
            found.insert(0, nothing());
        }
        let all = mended.cut_off(&mut |_| true);
        let which = if *cut == all || is_whole(&all) { Which::All } else { Which::Some };
        let count = if is_cut { 1 } else { found.len() };
        found.iter_mut().take(count).for_each(|own| own.causes.push(Cause::CutOff(0, which)));
    }
    let meant = Predictor::new(cut.as_ref().unwrap_or(mended), machine);
    let suspects = found.is_empty().then(|| Suspects::new(machine, &meant, &told));
    let causes: Vec<Cause> = told.into_iter().map(Cause::Written).collect();
    found.iter_mut().for_each(|own| own.causes = [&causes[..], &own.causes[..]].concat());
    Report { stopped_short: is_short, ..Report::new(machine, &own, &own, found, suspects) }
}
