//! What is known of numbers that nothing explains as a whole.

use serde::Serialize;

use super::elsewhere::Elsewhere;
use super::words::words;
use crate::behind;
use crate::explain::{Cause, Missing, Undeclared, missing, of_accelerations, undeclared, written};
use crate::given::{Quantity, contradictions};
use crate::machine::Machine;
use crate::predict::Predictor;
use crate::states::states;
use carvallo_slips::index;

/// What is known of numbers that nothing explains as a whole.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Suspects {
    /// What no machine has at once, of state matrices at one speed: `A_31 at 5 m/s is 9.490 and 11.000`.
    pub contradictions: Vec<String>,
    /// How state matrices were written as a whole: the rest is told of them as they should have been.
    pub beside: Vec<String>,
    /// What is wrong.
    pub wrong: Vec<String>,
    /// Whether all numbers together have too few digits for two causes to be searched, some of which would make them by chance.
    pub has_few_digits: bool,
    /// The formulas, and terms of the feedback, on which every wrong entry depends, and no right one; empty where no entries of
    /// matrices were given.
    pub formulas: Vec<String>,
    /// What explains some of the wrong numbers and leaves all right ones as they are: several mistakes may stand side by
    /// side.
    pub parts: Vec<Part>,
    /// What agrees and may be of somewhere else, with what explains all others, where anything does.
    pub elsewhere: Option<Elsewhere>,
    /// Where entries of state matrices are wrong: those of the damping and stiffness that they come from.
    pub behind: Option<Behind>,
    /// In which equations of motion accelerations are off, and by which forces.
    pub equations: Vec<String>,
    /// That what differs of state matrices, or of C and K, is in the span of some forces alone, where it is: a feedback makes it.
    pub feedback: Option<Undeclared>,
}

/// The entries of C and K of `M q'' + C q' + K q = f` behind state matrices, by the mass matrix as it is here.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Behind {
    /// Those that differ: `K_12 at 5 m/s is 1940.43 in the place of 1889.43`.
    pub wrong: Vec<String>,
    /// How many there are in all.
    pub count: usize,
    /// What explains some of them and leaves all right ones as they are.
    pub parts: Vec<Part>,
}

/// What explains some of the wrong numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Part {
    /// Which ones.
    pub numbers: Vec<String>,
    /// By what, the likeliest first; no more than a few.
    pub causes: Vec<String>,
}

/// So many causes of a part are told.
const TOLD: usize = 4;

impl Suspects {
    /// Whether all that differs is explained, though not at once.
    pub(super) fn are_explained_one_by_one(&self) -> bool {
        are_explained(&self.wrong, &self.parts) || self.behind.as_ref().is_some_and(Behind::are_explained)
    }

    /// Of numbers that are not those of the machine; `beside` how state matrices were written as a whole.
    pub(crate) fn new(machine: &Machine, predictor: &Predictor, beside: &[String]) -> Self {
        let here = &predictor.predict(&machine.world())[..];
        let name = |at: usize| predictor.name(at);
        let wrong: Vec<usize> = (0..here.len()).filter(|&at| !predictor.agrees(at, here[at])).collect();
        let behind = Behind::new(machine, predictor);
        let formulas = formulas(machine, predictor, &wrong);
        let names: Vec<String> = wrong.iter().map(|&at| name(at)).collect();
        let mut parts = parts(machine, predictor, wrong, here, &name);
        // What explains all of it behind state matrices is told there.
        if behind.as_ref().is_some_and(Behind::are_explained) && !are_explained(&names, &parts) {
            parts.clear();
        }
        let feedback = undeclared(machine, predictor).or_else(|| of_accelerations(machine, predictor));
        let equations = equations(machine, predictor);
        let contradictions = contradictions(predictor.given(), machine.info);
        let elsewhere = Elsewhere::new(machine, predictor, !contradictions.is_empty());
        let (beside, has_few_digits) = (beside.to_vec(), predictor.has_few_digits());
        let wrong = names;
        Self { contradictions, beside, wrong, has_few_digits, formulas, parts, elsewhere, behind, equations, feedback }
    }
}

/// Whether each of these is explained, by one part or another.
fn are_explained(wrong: &[String], parts: &[Part]) -> bool {
    let names = || parts.iter().flat_map(|part| &part.numbers);
    // Of what stands behind a state matrix the values are told with the names.
    wrong.iter().all(|own| names().any(|name| own == name || own.starts_with(&format!("{name} is "))))
}

impl Behind {
    fn are_explained(&self) -> bool {
        are_explained(&self.wrong, &self.parts)
    }

    /// None where no state matrix is given whole, or all is right behind it, or where it says something else of the rates of
    /// positions: it has no such form then.
    fn new(machine: &Machine, predictor: &Predictor) -> Option<Self> {
        if has_wrong_rates(machine, predictor) {
            return None;
        }
        let given = behind::state_matrices(machine, predictor)?;
        let predictor = Predictor::new(&given, machine);
        let here = predictor.predict(&machine.world());
        let name = |at: usize| predictor.name(at);
        let wrong: Vec<usize> = (0..here.len()).filter(|&at| !predictor.agrees(at, here[at])).collect();
        let told = |&at: &usize| {
            let [yours, ours] = [predictor.numbers()[at].1.value, here[at]].map(behind::shown);
            format!("{} is {yours} in the place of {ours}", name(at))
        };
        let own = Self {
            wrong: wrong.iter().map(told).collect(),
            count: here.len(),
            parts: parts(machine, &predictor, wrong, &here, &name),
        };
        (!own.wrong.is_empty()).then_some(own)
    }
}

/// Whether a row of a state matrix for a position does not say that its rate is the rate.
fn has_wrong_rates(machine: &Machine, predictor: &Predictor) -> bool {
    let (states, here) = (states(machine.info), predictor.predict(&machine.world()));
    let is_of_position = |quantity: &Quantity| match *quantity {
        Quantity::State(matrix, row, _) => !states[predictor.order(matrix)[row]].0,
        _ => false,
    };
    let mut numbers = predictor.numbers().iter().zip(&here).enumerate();
    numbers.any(|(at, ((quantity, _), &here))| is_of_position(quantity) && !predictor.agrees(at, here))
}

/// In which equations of motion accelerations are off, as `in state 1 at 5 m/s that of delta, by a force of 2.5`.
fn equations(machine: &Machine, predictor: &Predictor) -> Vec<String> {
    let told = |own: Missing| {
        let speed = predictor.given().accelerations[own.state].speed;
        let (wrong, right): (Vec<usize>, Vec<usize>) = (0..own.forces.len()).partition(|at| own.is_wrong(*at));
        let name = |at: &usize| machine.info.coordinates[*at].name;
        let off = |at: &usize| format!("that of {}, by a force of {}", name(at), behind::shown(own.forces[*at][0]));
        let wrong: Vec<String> = wrong.iter().map(off).collect();
        let right: Vec<&str> = right.iter().map(name).collect();
        let holds = if right.is_empty() { String::new() } else { format!("; that of {} holds", right.join(" and ")) };
        format!("in state {} at {speed} m/s {}{holds}", own.state + 1, wrong.join(", and "))
    };
    let is_off = |own: &Missing| (0..own.forces.len()).any(|at| own.is_wrong(at));
    missing(machine, predictor).into_iter().filter(is_off).map(told).collect()
}

/// The formulas, and the terms of the feedback, that all wrong and no right entries come from.
fn formulas(machine: &Machine, predictor: &Predictor, wrong: &[usize]) -> Vec<String> {
    let all = &machine.formulas.formulas;
    let given = predictor.numbers().iter().enumerate();
    // Of each the formula, if the model has any for it, and the place.
    let entries: Vec<(Option<usize>, usize, bool)> = given
        .filter_map(|(at, (quantity, _))| {
            let Quantity::Entry(matrix, row, column) = *quantity else { return None };
            let place = index(matrix, row, column, machine.formulas.count);
            Some((machine.formulas.entry(matrix, row, column), place, wrong.contains(&at)))
        })
        .collect();
    if !entries.iter().any(|(.., is_wrong)| *is_wrong) {
        return Vec::new();
    }
    let feeds = |own: usize, entry: Option<usize>| entry.is_some_and(|entry| machine.formulas.feeds(own, entry));
    let is_suspect =
        |own: &usize| all[*own].is_tried && entries.iter().all(|&(entry, _, is_wrong)| feeds(*own, entry) == is_wrong);
    let told = |own: usize| {
        let fed_back = machine.place(own).map(|entry| machine.fed_back(entry)).unwrap_or_default();
        let less = if fed_back.is_empty() { String::new() } else { format!(", less {}", fed_back.join(" and ")) };
        format!("{} = {}{less}", all[own].subject, all[own].text)
    };
    let closing: Vec<Vec<String>> = entries.iter().map(|(_, place, _)| machine.fed_back(*place)).collect();
    let is_suspect_term =
        |term: &&String| entries.iter().zip(&closing).all(|((.., is_wrong), own)| own.contains(term) == *is_wrong);
    let mut terms: Vec<String> = closing.iter().flatten().filter(is_suspect_term).cloned().collect();
    terms.dedup();
    (0..all.len()).filter(is_suspect).map(told).chain(terms).collect()
}

/// One cause after the other, each that explains the most of what is left without a change of what is right.
fn parts(
    machine: &Machine,
    predictor: &Predictor,
    wrong: Vec<usize>,
    here: &[f64],
    name: &dyn Fn(usize) -> String,
) -> Vec<Part> {
    // What makes one number alone was searched for.
    if here.len() == 1 {
        return Vec::new();
    }
    let mut left = wrong.clone();
    let mut candidates: Vec<(Vec<usize>, u32, Cause)> = Vec::new();
    machine.singles(&mut |cause, world| {
        let disagreeing = predictor.disagreeing(world);
        let is_right = |own: &Vec<usize>| own.iter().all(|at| !wrong.contains(at));
        let is_told = |at: &usize| disagreeing.iter().any(|own| own[..] == [*at]);
        if disagreeing.iter().any(is_right) || wrong.iter().all(is_told) {
            return;
        }
        let values = predictor.predict(world);
        let agrees = |at: usize| predictor.agrees(at, values[at]);
        if (0..values.len()).all(|at| wrong.contains(&at) || agrees(at)) {
            let explained: Vec<usize> = wrong.iter().copied().filter(|&at| agrees(at)).collect();
            if !explained.is_empty() {
                candidates.push((explained, super::groups::rank(machine, &cause), cause));
            }
        }
    });
    for slip in written(predictor, here) {
        let cause = Cause::Written(slip.what);
        candidates.push((slip.numbers, super::groups::rank(machine, &cause), cause));
    }
    let mut parts = Vec::new();
    while !left.is_empty() {
        let gain = |explained: &[usize]| explained.iter().filter(|at| left.contains(at)).count();
        let Some(most) = candidates.iter().map(|(explained, ..)| gain(explained)).max().filter(|most| *most > 0) else {
            break;
        };
        let mut best: Vec<_> = candidates.iter().filter(|(explained, ..)| gain(explained) == most).collect();
        best.sort_by_key(|(_, rank, _)| *rank);
        let explained: Vec<usize> = best[0].0.clone();
        best.retain(|(own, ..)| *own == explained);
        // An entry of the wrong sign is also a number that was written with it, be it of C and K at a speed.
        let same = |told: &String, cause: &String| match &explained[..] {
            [at] => cause.strip_prefix(&name(*at)).map_or(told == cause, |how| told.ends_with(how)),
            _ => told == cause,
        };
        let mut causes: Vec<String> = Vec::new();
        for cause in best.iter().map(|(.., cause)| words(machine, cause)) {
            if causes.len() < TOLD && !causes.iter().any(|told| same(told, &cause)) {
                causes.push(cause);
            }
        }
        parts.push(Part { numbers: explained.iter().map(|&at| name(at)).collect(), causes });
        left.retain(|at| !explained.contains(at));
    }
    parts
}
