//! Causes in words.

use carvallo_design::number::{shortest, with_unit};
use carvallo_slips::{double_words, slip_words};

use crate::conventions::{BEFORE_CLOSING, Effect};
use crate::explain::{Cause, Force, Undeclared, Which, relation};
use crate::machine::Machine;

/// What is otherwise, as the end of a sentence.
pub fn words(machine: &Machine, cause: &Cause) -> String {
    let parameter = |at: usize| &machine.info.parameters[at];
    match cause {
        Cause::Convention(own) => match &own.effect {
            Effect::Parameters(values) if values.len() <= 2 && !own.what.contains('=') => {
                let values: Vec<String> = values
                    .iter()
                    .map(|&(at, value)| {
                        let own = parameter(at);
                        let shown = machine.units.of(own.unit);
                        format!("{} = {}", own.name, with_unit(rounded(shown.value(value)), &shown.written))
                    })
                    .collect();
                format!("{} ({})", own.what, values.join(", "))
            }
            _ => own.what.clone(),
        },
        Cause::Slip(own) => {
            let formula = &machine.formulas.formulas[own.formulas[0]];
            slip_words(&machine.formulas.subject(&own.formulas), formula.text, &own.slip)
                + of_open_loop(machine, &own.formulas)
        }
        Cause::Slips(double) => {
            let formula = &machine.formulas.formulas[double.formulas[0]];
            let subject = machine.formulas.subject(&double.formulas);
            double_words(&subject, formula.text, &double.slips) + of_open_loop(machine, &double.formulas)
        }
        Cause::Parameter(at, value) => {
            let (own, old) = (parameter(*at), machine.parameters[*at]);
            let how = relation(old, *value).map(|how| format!(": {how}")).unwrap_or_default();
            let shown = machine.units.of(own.unit);
            let show = |value: f64| if shown.is_declared() { value } else { rounded(shown.value(value)) };
            let value = with_unit(show(*value), &shown.written);
            format!("{} is {value} in the place of {}{how}", own.name, shortest(show(old)))
        }
        Cause::Definition(at, value) => {
            let (name, old) = (machine.formulas.formulas[*at].subject, machine.values.definition(*at));
            let text = machine.formulas.formulas[*at].text;
            format!("{name} is {} in the place of {} = {text}", shortest(*value), shortest(rounded(old)))
        }
        Cause::Written(what) => what.clone(),
        Cause::CutOff(_, Which::All) => "all numbers are cut off, not rounded".to_owned(),
        Cause::CutOff(_, Which::Some) => "some numbers are cut off, not rounded".to_owned(),
        Cause::Feedback(own) => {
            let (forces, further) = (own.forces.join(" and "), further(own));
            let at = own.speed.map(|speed| format!(" ({})", at_one_speed(speed))).unwrap_or_default();
            format!(
                "the loop is closed{further}, in the span of {forces} alone, by what {} declares{at}",
                declared(own)
            )
        }
        Cause::Force(own) => force(machine, own),
        Cause::Scaled(own) => own.to_string(),
        Cause::Speed(factor) => {
            format!("the speeds are {} times what is given as the speed", shortest(*factor))
        }
    }
}

/// Another force than is declared.
fn force(machine: &Machine, own: &Force) -> String {
    let (name, value) = (machine.info.coordinates[own.on].name, shortest(own.value));
    match own.declared {
        Some(0.0) => format!("there is a force on {name} that is not declared, forces = {{ {name} = {value} }}"),
        Some(declared) => match own.value {
            0.0 => format!("the force on {name} is left out"),
            _ if own.value == -declared => format!("the force on {name} has the other sign"),
            _ => format!("the force on {name} is {value} in the place of {}", shortest(declared)),
        },
        None => format!("the forces on {name} are by {value} larger than they are declared"),
    }
}

/// As the feedback is declared: `--feedback 'Tdelta = -10*phi_rate'`.
fn declared(own: &Undeclared) -> String {
    let laws: Vec<String> = own.laws.iter().map(|law| format!("--feedback '{law}'")).collect();
    laws.join(" ")
}

/// What comes to the feedback that is declared.
fn further(own: &Undeclared) -> String {
    match own.further.is_empty() {
        true => String::new(),
        false => format!(" by more than is declared, {}", own.further.join(" and ")),
    }
}

fn at_one_speed(speed: f64) -> String {
    format!("gains at {} m/s: one speed does not tell how they depend on it", shortest(speed))
}

/// What is told of a feedback that may be there.
pub(super) fn may_be_closed(own: &Undeclared) -> String {
    let forces = own.forces.join(" and ");
    let span = format!("What differs is in the span of {forces} alone, as M^-1 spreads it: a feedback makes that.");
    if own.laws.is_empty() {
        return format!("{span} Closed loops are declared with --feedback '{} = …'.", own.forces[0]);
    }
    let at = own.speed.map(|speed| format!(" ({})", at_one_speed(speed))).unwrap_or_default();
    let more = match own.further.is_empty() {
        true => String::new(),
        false => format!(" By more than is declared, {},", own.further.join(" and ")),
    };
    let all = if more.is_empty() { " All" } else { " all" };
    format!("{span}{more}{all} numbers are those with {}{at}.", declared(own))
}

/// What is said of formulas of entries that feedback is added to.
fn of_open_loop(machine: &Machine, formulas: &[usize]) -> &'static str {
    let is_closed = |at: &usize| machine.place(*at).is_some_and(|entry| !machine.fed_back(entry).is_empty());
    if formulas.iter().any(is_closed) { BEFORE_CLOSING } else { "" }
}

/// Without what arithmetic left behind.
fn rounded(value: f64) -> f64 {
    format!("{value:.9e}").parse::<f64>().unwrap_or(value) + 0.0
}
