//! A force that is not declared, or another one than is, and the same in all states of which accelerations are given.

use super::forces::{Missing, missing};
use super::solve::digits;
use crate::given::{Given, Kind};
use crate::machine::Machine;
use crate::predict::Predictor;

/// Another force on a coordinate than is declared.
#[derive(Clone, Debug, PartialEq)]
pub struct Force {
    /// Which coordinate.
    pub on: usize,
    /// What is declared, where that is the same in all states.
    pub declared: Option<f64>,
    /// What it is, or by how much it is larger, where others are declared in other states.
    pub value: f64,
}

impl Force {
    /// Whether it is one that is declared, left out or of the other sign.
    pub fn is_of_declared(&self) -> bool {
        self.declared.is_some_and(|declared| declared != 0.0 && (self.value == 0.0 || self.value == -declared))
    }
}

/// The forces with which all numbers come out, with the fewest digits, on the coordinates in whose equations anything is missing. None
/// where forces on all coordinates make all accelerations, whatever these are, or where a force has more than so many digits.
pub fn find(machine: &Machine, predictor: &Predictor, most: usize) -> Vec<Force> {
    let given = predictor.given();
    let (all, count) = (missing(machine, predictor), machine.formulas.count);
    let wrong: Vec<usize> = (0..count).filter(|at| all.iter().any(|own| own.is_wrong(*at))).collect();
    let is_known = all.len() == given.accelerations.len() && (wrong.len() < count || all.len() > 1);
    if wrong.is_empty() || !is_known {
        return Vec::new();
    }
    let forces: Option<Vec<Force>> = wrong.into_iter().map(|on| constant(given, &all, on)).collect();
    let plain = forces.filter(|forces| forces.iter().all(|own| digits(own.value) <= most));
    plain.filter(|forces| fit(machine, predictor, forces)).unwrap_or_default()
}

/// The force on a coordinate that makes what is missing in all states, with the fewest digits.
fn constant(given: &Given, all: &[Missing], on: usize) -> Option<Force> {
    let mut declared = given.accelerations.iter().map(|own| own.forces[on]);
    let first = declared.next()?;
    let declared = declared.all(|other| other == first).then_some(first);
    let bounds = all.iter().map(|own| {
        let [force, tolerance] = own.forces[on];
        let value = declared.unwrap_or(0.0) + force;
        [value - tolerance, value + tolerance]
    });
    let [low, high] =
        bounds.fold([f64::NEG_INFINITY, f64::INFINITY], |[low, high], own| [low.max(own[0]), high.min(own[1])]);
    let middle = (low + high) / 2.0;
    let rounded = (0..17).filter_map(|digits| format!("{middle:.digits$e}").parse().ok());
    let value = [0.0].into_iter().chain(rounded).find(|value| (low..=high).contains(value))?;
    Some(Force { on, declared, value })
}

/// Whether all numbers come out with these forces, by the equations that they are held against.
fn fit(machine: &Machine, predictor: &Predictor, forces: &[Force]) -> bool {
    let mut given = predictor.given().clone();
    for (state, own) in given.accelerations.iter_mut().enumerate() {
        own.equations = Some(if predictor.is_state_nonlinear(state) { Kind::Nonlinear } else { Kind::Linear });
        for force in forces {
            own.forces[force.on] = force.value + if force.declared.is_some() { 0.0 } else { own.forces[force.on] };
        }
    }
    let own = Predictor::new(&given, machine);
    let here = own.predict(&machine.world());
    own.agreeing(&here) == here.len()
}
