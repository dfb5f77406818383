//! Accelerations as forces: what is missing in each equation of motion, and a feedback that makes it.

use carvallo_design::feedback::{Gain, Input};

use super::gains::solution;
use super::undeclared::{EXPONENTS, POWERS, Undeclared};
use crate::given::{Accelerations, Quantity};
use crate::machine::Machine;
use crate::predict::Predictor;
use crate::states::states;

/// The forces with which accelerations in a state come out as they were given, beside those that are there.
pub struct Missing {
    /// Which state.
    pub state: usize,
    /// On each coordinate, and how far it may be off.
    pub forces: Vec<[f64; 2]>,
}

impl Missing {
    /// Whether more is missing in an equation than digits that are not known.
    pub fn is_wrong(&self, equation: usize) -> bool {
        let [force, tolerance] = self.forces[equation];
        force.abs() > tolerance
    }
}

/// Of each state in which all accelerations are given, which are linear in the forces.
pub fn missing(machine: &Machine, predictor: &Predictor) -> Vec<Missing> {
    let (count, world) = (machine.formulas.count, machine.world());
    let here = predictor.predict(&world);
    let of = |state: usize| {
        let number = |of: usize| {
            let wanted = Quantity::Acceleration(state, of);
            predictor.numbers().iter().position(|(quantity, _)| *quantity == wanted)
        };
        let numbers: Vec<usize> = (0..count).map(number).collect::<Option<_>>()?;
        let nothing = predictor.with_force(state, None, &world)?;
        let by_one = |on: usize| predictor.with_force(state, Some(on), &world);
        let by_each: Vec<Vec<f64>> = (0..count).map(by_one).collect::<Option<_>>()?;
        let row = |row: usize| (0..count).map(|on| by_each[on][row] - nothing[row]).collect();
        let rows: Vec<Vec<f64>> = (0..count).map(row).collect();
        let off: Vec<f64> = numbers.iter().map(|at| predictor.numbers()[*at].1.value - here[*at]).collect();
        let values = solution(&rows, &off)?;
        let mut forces: Vec<[f64; 2]> = values.into_iter().map(|value| [value, 0.0]).collect();
        for (at, number) in numbers.iter().enumerate() {
            let mut one = vec![0.0; count];
            one[at] = predictor.tolerances()[*number];
            let effect = solution(&rows, &one)?;
            forces.iter_mut().zip(effect).for_each(|(force, effect)| force[1] += effect.abs());
        }
        Some(Missing { state, forces })
    };
    (0..predictor.given().accelerations.len()).filter_map(of).collect()
}

/// In how many equations of all states anything is missing, where nothing but accelerations is given; what has no forces counts by its
/// numbers.
pub fn off(machine: &Machine, predictor: &Predictor) -> Option<usize> {
    let missing = missing(machine, predictor);
    let is_acceleration = |(quantity, _): &(Quantity, _)| matches!(quantity, Quantity::Acceleration(..));
    let of = |(state, given): (usize, &Accelerations)| match missing.iter().find(|own| own.state == state) {
        Some(own) => (0..own.forces.len()).filter(|at| own.is_wrong(*at)).count(),
        None => given.values.iter().flatten().count(),
    };
    let all = predictor.given().accelerations.iter().enumerate();
    predictor.numbers().iter().all(is_acceleration).then(|| all.map(of).sum())
}

/// The forces on the coordinates in whose equations anything is missing, fewer than all, and the one law of each of one term or of two that
/// makes it, if there is one alone.
pub fn find(machine: &Machine, predictor: &Predictor) -> Option<Undeclared> {
    let missing = missing(machine, predictor);
    let count = machine.formulas.count;
    let wrong: Vec<usize> = (0..count).filter(|at| missing.iter().any(|own| own.is_wrong(*at))).collect();
    if wrong.is_empty() || wrong.len() == count {
        return None;
    }
    let gains: Option<Vec<Vec<Gain>>> = wrong.iter().map(|at| law(machine, predictor, *at)).collect();
    let inputs = wrong.iter().map(|at| Input::Coordinate(*at));
    let forces = inputs.map(|input| input.names(machine.info).swap_remove(0)).collect();
    let told = gains.and_then(|gains| Undeclared::new(machine, predictor, &gains.concat()));
    Some(told.unwrap_or(Undeclared { forces, laws: Vec::new(), further: Vec::new(), speed: None, digits: 0 }))
}

/// The gains of the force on a coordinate, of one term or else of two; `None` where several would do.
fn law(machine: &Machine, predictor: &Predictor, on: usize) -> Option<Vec<Gain>> {
    let given = predictor.given();
    let all = missing(machine, predictor);
    let known = |state: usize| all.iter().find(|own| own.state == state).map(|own| own.forces[on]);
    let wanted: Vec<[f64; 2]> = (0..given.accelerations.len()).map(known).collect::<Option<_>>()?;
    let powers = if given.speeds().len() > 1 { 3 } else { 1 };
    let mut terms: Vec<(Gain, Vec<f64>)> = Vec::new();
    for (is_rate, column) in states(machine.info) {
        for (power, &matrix) in POWERS[usize::from(!is_rate)][..powers].iter().enumerate() {
            let of = |own: &Accelerations| {
                let value = if is_rate { own.rates[column] } else { own.positions[column] };
                value * own.speed.powi(EXPONENTS[usize::from(!is_rate)][power])
            };
            let values: Vec<f64> = given.accelerations.iter().map(of).collect();
            let gain = Gain { matrix, input: Input::Coordinate(on), column, value: 0.0 };
            if values.iter().all(|value| value.is_finite()) && values.iter().any(|value| *value != 0.0) {
                terms.push((gain, values));
            }
        }
    }
    let one: Vec<Vec<usize>> = (0..terms.len()).map(|at| vec![at]).collect();
    let two = (0..terms.len()).flat_map(|a| (a + 1..terms.len()).map(move |b| vec![a, b])).collect();
    for chosen in [one, two] {
        let made = |chosen: &Vec<usize>| {
            let effects: Vec<&[f64]> = chosen.iter().map(|at| &terms[*at].1[..]).collect();
            let values = gains(&wanted, &effects)?;
            Some(chosen.iter().zip(values).map(|(at, value)| Gain { value, ..terms[*at].0 }).collect::<Vec<Gain>>())
        };
        let found: Vec<Vec<Gain>> = chosen.iter().filter_map(made).collect();
        match &found[..] {
            [] => {}
            [own] => return Some(own.clone()),
            _ => return None,
        }
    }
    None
}

/// The factors with the fewest digits with which the effects make what is wanted.
fn gains(wanted: &[[f64; 2]], effects: &[&[f64]]) -> Option<Vec<f64>> {
    let weighted = |a: &dyn Fn(usize) -> f64, b: &[f64]| -> f64 {
        (0..wanted.len()).map(|at| a(at) * b[at] / wanted[at][1].powi(2)).sum()
    };
    let row = |own: &&[f64]| effects.iter().map(|other| weighted(&|at| own[at], other)).collect();
    let rows: Vec<Vec<f64>> = effects.iter().map(row).collect();
    let right: Vec<f64> = effects.iter().map(|own| weighted(&|at| wanted[at][0], own)).collect();
    let values = solution(&rows, &right)?;
    let fits = |values: &Vec<f64>| {
        let made = |at: usize| -> f64 { effects.iter().zip(values).map(|(own, value)| own[at] * value).sum() };
        (0..wanted.len()).all(|at| (made(at) - wanted[at][0]).abs() <= wanted[at][1])
    };
    let rounded = (0..17).filter_map(|digits| {
        values.iter().map(|value| format!("{value:.digits$e}").parse().ok()).collect::<Option<Vec<f64>>>()
    });
    rounded.into_iter().find(fits).filter(|values| values.iter().all(|value| *value != 0.0))
}
