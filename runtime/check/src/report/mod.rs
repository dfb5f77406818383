//! What comes of a check.

mod display;
mod elsewhere;
mod groups;
mod suspects;
mod words;

use carvallo::{EntryInfo, FormulaInfo, FormulaSubject, ModelInfo};
use carvallo_design::DisplayUnit;
use carvallo_design::number::shortest;
use serde::Serialize;

pub use self::elsewhere::Elsewhere;
pub(crate) use self::groups::rank;
pub use self::suspects::{Behind, Part, Suspects};
pub use self::words::words;

use crate::explain::{Found, digits as significant};
use crate::given::{Quantity, Reading};
use crate::machine::Machine;
use crate::predict::Predictor;
use crate::states::names;

/// Whether somebody's numbers are those of a machine, and what explains it where they are not.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Report {
    /// The machine.
    pub machine: String,
    /// Its model.
    pub model: String,
    /// Whether all numbers agree to the digits that were given.
    pub agrees: bool,
    /// All numbers, in the order in which they were given, those of matrices first.
    pub numbers: Vec<Comparison>,
    /// What reproduces all numbers to the given digits, the likeliest first: none where all agree, or where nothing does.
    /// Those of one group make the same matrices of this machine.
    pub explanations: Vec<Group>,
    /// The states that the rows and columns of each state matrix stand for, in the order in which they were given.
    pub states: Vec<Vec<String>>,
    /// What is said not to be known, and was not compared: `M_12`, as numbers have their names.
    pub unknown: Vec<String>,
    /// Why there are none of ours where there are none, as of accelerations in a state in which no motion is determined.
    pub reasons: Vec<String>,
    /// So many digits, where all numbers that do not agree do to them and have zeros behind: `46470.0` of 46473.2.
    pub padded: Option<usize>,
    /// Whether the search was stopped by what it costs before everything was tried.
    pub stopped_short: bool,
    /// Where nothing explains all numbers: what is known of them.
    pub unexplained: Option<Suspects>,
}

/// One number beside the one that it should be.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Comparison {
    /// What it is of: `M_12`, with row and column from one, or `Re s2 at 5 m/s`.
    pub name: String,
    /// The unit, such as `kg*m^2`: of the SI unless another one was asked for; empty for what has none, or where it is not known.
    pub unit: String,
    /// As it was given, in this unit.
    pub yours: String,
    /// As it should be; `None` where there is none, as of a critical speed.
    pub ours: Option<f64>,
    /// How many significant digits agree.
    pub digits: usize,
    /// Whether that is all that was given.
    pub agrees: bool,
    /// Where the digits that were given are those of the number, but cut off and not rounded: as they are rounded.
    pub cut_off: Option<String>,
}

/// Explanations that make the same matrices of this machine.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Group {
    /// The likeliest first.
    pub explanations: Vec<Explanation>,
    /// What would tell them from those of the first group.
    pub apart: Option<String>,
}

/// What reproduces all numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Explanation {
    /// What is otherwise, all of it together.
    pub causes: Vec<String>,
    /// Explanations of the same class in a group make the same matrices of every machine, as far as is known: no number
    /// tells them apart. Others of a group differ for other parameters.
    pub class: usize,
}

impl Report {
    /// As JSON with an end of the last line; its form is documented in `docs/check.md` of the command line.
    pub fn json(&self) -> String {
        // Text and finite numbers are always JSON.
        serde_json::to_string_pretty(self).map(|text| text + "\n").unwrap_or_default()
    }

    /// From everything that reproduces the numbers as they are meant, rounded or cut off; or, where all that does not agree is
    /// cut off, as rounded; or what is known of them.
    pub(crate) fn new(
        machine: &Machine,
        predictor: &Predictor,
        meant: &Predictor,
        found: Vec<Found>,
        unexplained: Option<Suspects>,
    ) -> Self {
        let world = machine.world();
        let here = predictor.predict(&world);
        let has_all = here.iter().all(|own| own.is_finite());
        let reasons = if has_all { Vec::new() } else { predictor.reasons(&world) };
        let numbers: Vec<Comparison> = predictor
            .numbers()
            .iter()
            .zip(&here)
            .enumerate()
            .map(|(at, (&(quantity, reading), &ours))| {
                let shown = machine.units.of(unit(quantity, machine.info));
                let is_cut_off = !predictor.agrees(at, ours) && meant.agrees(at, ours);
                Comparison {
                    name: predictor.name(at),
                    yours: in_unit(reading, &reading.written, reading.value, &shown),
                    ours: ours.is_finite().then_some(shown.value(ours) + 0.0),
                    digits: match predictor.agrees(at, ours) {
                        true if reading.digits > 0 => reading.digits,
                        _ => digits(reading.value, ours, predictor.tolerances()[at]),
                    },
                    agrees: predictor.agrees(at, ours),
                    cut_off: is_cut_off.then(|| in_unit(reading, &reading.rounding(ours), ours, &shown)),
                    unit: shown.written,
                }
            })
            .collect();
        let agrees = numbers.iter().all(|number| number.agrees);
        let is_whole = meant.agreeing(&here) == here.len();
        // Where all are cut off numbers or right ones, what is found explains them as rounded.
        let explanations = groups::groups(machine, if is_whole { predictor } else { meant }, found);
        Self {
            machine: machine.info.name.to_owned(),
            model: machine.info.name.to_owned(),
            agrees,
            numbers,
            explanations,
            states: (0..predictor.given().state_matrices.len()).map(|at| states(predictor, at, machine.info)).collect(),
            unknown: predictor.given().unknown(machine.info),
            reasons,
            padded: padded(predictor, &here),
            stopped_short: false,
            unexplained,
        }
    }
}

/// The states of a state matrix, in its order: `phi`, `phi_rate`.
fn states(predictor: &Predictor, at: usize, info: &ModelInfo) -> Vec<String> {
    let all = names(info);
    predictor.order(at).iter().map(|state| all[*state].clone()).collect()
}

/// The least number of digits to which those that do not agree do, all of them with zeros behind.
fn padded(predictor: &Predictor, here: &[f64]) -> Option<usize> {
    /// Fewer agree by chance.
    const ENOUGH: usize = 3;
    let wrong = (0..here.len()).filter(|&at| !predictor.agrees(at, here[at]));
    let digits = wrong.map(|at| {
        let reading = predictor.numbers()[at].1;
        let digits = significant(reading.value);
        let is_padded = (ENOUGH..reading.digits).contains(&digits);
        (is_padded && Reading::rounded(here[at], digits).value == reading.value).then_some(digits)
    });
    digits.collect::<Option<Vec<usize>>>()?.into_iter().min()
}

/// A number as it is written in the unit that it was declared in; in another one with as many digits as it was given to.
fn in_unit(reading: &Reading, written: &str, value: f64, shown: &DisplayUnit) -> String {
    let value = shown.value(value);
    match reading.digits {
        _ if shown.is_declared() => written.to_owned(),
        0 => shortest(format!("{value:.9e}").parse().unwrap_or(value)),
        digits => shortest(format!("{value:.*e}", digits - 1).parse().unwrap_or(value)),
    }
}

/// The unit of a number. Of an entry whose formula is zero it is that of the others of its matrix, where that is one.
pub(crate) fn unit(quantity: Quantity, info: &ModelInfo) -> &'static str {
    let Quantity::Entry(matrix, row, column) = quantity else {
        return match quantity {
            Quantity::RealPart(..) | Quantity::ImaginaryPart(..) => "1/s",
            Quantity::CriticalSpeed(_) => "m/s",
            _ => "",
        };
    };
    let places = |formula: &FormulaInfo| match formula.of {
        FormulaSubject::Entry(EntryInfo { places }) => places,
        FormulaSubject::Definition(_) | FormulaSubject::Attribute { .. } => &[],
    };
    let own = info.formulas.iter().find(|formula| places(formula).contains(&(matrix, row, column)));
    let mut others = info.formulas.iter().filter(|formula| places(formula).iter().any(|place| place.0 == matrix));
    let first = others.next().map_or("", |formula| formula.unit);
    let unit = own.map_or(if others.all(|formula| formula.unit == first) { first } else { "" }, |own| own.unit);
    if unit == "1" { "" } else { unit }
}

/// How many significant digits agree, at most 17.
fn digits(yours: f64, ours: f64, tolerance: f64) -> usize {
    let difference = (yours - ours).abs().max(tolerance);
    let digits = (ours.abs().max(yours.abs()) / difference).log10() + 0.302;
    if digits.is_finite() { digits.clamp(0.0, 17.0) as usize } else { 0 }
}
