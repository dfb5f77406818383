//! A closed loop that nobody declared, or more of it than was: what differs stands in the equations of some forces alone, and is linear
//! in the states.

use carvallo::MatrixName;
use carvallo_design::feedback::{Gain, Input, Law};
use carvallo_slips::{index, place};
use serde::Serialize;

use super::PLAIN;
use super::gains::{solution, solve};
use super::solve::{digits, near, solve as value};
use crate::conventions;
use crate::machine::Machine;
use crate::predict::{Predictor, World};
use crate::relation::Relation;
use crate::states::states;

/// Forces in whose span everything is that differs of state matrices, or of C and K: a feedback of them makes it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Undeclared {
    /// What they are called.
    pub forces: Vec<String>,
    /// What they follow from, as `--feedback` has it, where that is known: the closed loop with these has all numbers.
    pub laws: Vec<String>,
    /// What of these comes to the feedback that is declared; none where none is.
    pub further: Vec<String>,
    /// The speed in m/s at which the gains are these, where all numbers are of one: how they depend on it is not known.
    pub speed: Option<f64>,
    /// The digits of the gain that has the most.
    #[serde(skip)]
    pub digits: usize,
}

/// Beyond so much of it an imaginary part is none that the digits of an eigenvalue leave to a gain.
const UNREAL: f64 = 0.1;

/// What a gain may be multiplied by, of a rate and of a position.
pub const POWERS: [[MatrixName; 3]; 2] =
    [[MatrixName::C0, MatrixName::C1, MatrixName::Cm1], [MatrixName::Kc, MatrixName::K1, MatrixName::K2]];

/// The powers of the speed of these.
pub const EXPONENTS: [[i32; 3]; 2] = [[0, 1, -1], [0, 1, 2]];

/// Those forces, fewer than there are coordinates: all of them together span everything. None where nothing but entries of M, C1, … is
/// given.
pub fn find<'a>(machine: &'a Machine, predictor: &'a Predictor<'a>) -> Option<Undeclared> {
    let given = predictor.given();
    if given.state_matrices.is_empty() && given.system_matrices.is_empty() {
        return None;
    }
    let search = Search::new(machine, predictor);
    let inputs = search.inputs()?;
    let gains: Option<Vec<Vec<Gain>>> = inputs.iter().map(|input| search.gains(*input)).collect();
    let told = Undeclared::new(machine, predictor, &gains.unwrap_or_default().concat());
    let name = |input: &Input| input.names(machine.info).swap_remove(0);
    let forces = inputs.iter().map(name).collect();
    let nothing = Undeclared { forces: Vec::new(), laws: Vec::new(), further: Vec::new(), speed: None, digits: 0 };
    Some(Undeclared { forces, ..told.unwrap_or(nothing) })
}

/// One gain that makes eigenvalues and critical speeds, with the fewest digits that do; `None` where anything else is given: of that
/// [`find`] tells more.
pub fn of_eigenvalues(machine: &Machine, predictor: &Predictor) -> Option<Undeclared> {
    if predictor.given().eigenvalues.is_empty() || !predictor.relations().is_empty() {
        return None;
    }
    predictor.begin();
    let powers = if predictor.given().speeds().len() > 1 { 3 } else { 1 };
    let mut found: Vec<Undeclared> = Vec::new();
    for input in Input::all(machine.info) {
        let shares = input.shares(machine.info, &machine.parameters);
        for (is_rate, column) in states(machine.info) {
            for &matrix in &POWERS[usize::from(!is_rate)][..powers] {
                let world = |value: f64| {
                    let mut own = machine.world();
                    for (row, share) in shares.iter().enumerate() {
                        own.entries[index(matrix, row, column, machine.formulas.count)] -= share * value;
                    }
                    Some(own)
                };
                let value = by_eigenvalue(predictor, &world).unwrap_or_else(|| value(predictor, 0.0, &world, false));
                let value = value.filter(|value| *value != 0.0);
                let gain = value.map(|value| Gain { matrix, input, column, value });
                found.extend(gain.and_then(|gain| Undeclared::new(machine, predictor, &[gain])));
            }
        }
    }
    found.into_iter().min_by_key(|own| own.digits).or_else(|| of_two_powers(machine, predictor))
}

/// A gain of one state with two powers of the speed, from what it is at each speed of which there are eigenvalues.
fn of_two_powers(machine: &Machine, predictor: &Predictor) -> Option<Undeclared> {
    let speeds = predictor.given().speeds();
    let [first, .., last] = speeds[..] else { return None };
    for input in Input::all(machine.info) {
        let shares = input.shares(machine.info, &machine.parameters);
        for (is_rate, column) in states(machine.info) {
            let (matrices, exponents) = (POWERS[usize::from(!is_rate)], EXPONENTS[usize::from(!is_rate)]);
            let world = |gains: &[(MatrixName, f64)]| {
                let mut own = machine.world();
                for (row, share) in shares.iter().enumerate() {
                    for (matrix, value) in gains {
                        own.entries[index(*matrix, row, column, machine.formulas.count)] -= share * value;
                    }
                }
                own
            };
            let at = |speed: f64| at_speed(predictor, speed, [&machine.world(), &world(&[(matrices[0], 1.0)])]);
            let (Some(of_first), Some(of_last)) = (at(first), at(last)) else { continue };
            for chosen in [[0, 1], [0, 2], [1, 2]] {
                let row = |speed: f64| chosen.map(|at| speed.powi(exponents[at])).to_vec();
                let Some(values) = solution(&[row(first), row(last)], &[of_first, of_last]) else { continue };
                let rounded = (0..PLAIN).filter_map(|digits| {
                    let values = values.iter().map(|value| format!("{value:.digits$e}").parse().ok());
                    values.collect::<Option<Vec<f64>>>()
                });
                let powers =
                    |values: Vec<f64>| chosen.map(|at| matrices[at]).into_iter().zip(values).collect::<Vec<_>>();
                let mut fitting = rounded.map(powers).filter(|gains| predictor.fits(&world(gains)));
                let Some(gains) = fitting.next() else { continue };
                let gains = gains.into_iter().filter(|(_, value)| *value != 0.0);
                let gains: Vec<Gain> = gains.map(|(matrix, value)| Gain { matrix, input, column, value }).collect();
                if let Some(found) = Undeclared::new(machine, predictor, &gains) {
                    return Some(found);
                }
            }
        }
    }
    None
}

/// What a gain is at a speed, by an eigenvalue there that the machine has not without it; `None` where one is not real. Of the machine
/// without it, and with a gain of one.
fn at_speed(predictor: &Predictor, speed: f64, worlds: [&World; 2]) -> Option<f64> {
    let entries = worlds.map(|own| predictor.closed_entries(own));
    let gravity = worlds[0].gravity;
    let mut own = predictor.zeros().iter().filter(|own| own.speed == speed);
    let zero = own.find(|own| !own.holds(&entries[0], gravity))?;
    let [off, further] = entries.map(|own| zero.determinant(&own, gravity));
    let value = off / (off - further);
    (value.re.is_finite() && value.im.abs() <= UNREAL * value.re.abs()).then_some(value.re)
}

/// A gain by an eigenvalue that the machine has not without it: each is multiplied with one column of one force, so that the
/// determinant that is zero there is linear in it. The inner `None` is that of no gain, the outer one where no such eigenvalue is known.
fn by_eigenvalue(predictor: &Predictor, world: &dyn Fn(f64) -> Option<World>) -> Option<Option<f64>> {
    let (without, with) = (world(0.0)?, world(1.0)?);
    let entries = [&without, &with].map(|own| predictor.closed_entries(own));
    let zero = predictor.zeros().iter().find(|own| !own.holds(&entries[0], without.gravity))?;
    let [off, further] = entries.map(|own| zero.determinant(&own, without.gravity));
    let value = off / (off - further);
    let is_real = value.re.is_finite() && value.im.abs() <= UNREAL * value.re.abs();
    Some(is_real.then(|| near(predictor, value.re, world)).flatten())
}

impl Undeclared {
    /// With gains beside those that are declared; `None` where the loop that they close does not have all numbers.
    pub fn new(machine: &Machine, predictor: &Predictor, gains: &[Gain]) -> Option<Self> {
        let mut inputs: Vec<Input> = gains.iter().map(|gain| gain.input).collect();
        inputs.dedup();
        let (mut laws, mut further) = (machine.feedback.clone(), Vec::new());
        laws.retain(|law| !inputs.contains(&law.input));
        for &input in &inputs {
            let more: Vec<Gain> = gains.iter().filter(|gain| gain.input == input).copied().collect();
            let declared = machine.gains().filter(|gain| gain.input == input).copied();
            let all = sum(declared.collect(), &more);
            if !all.is_empty() {
                laws.push(Law::read(&written(&all, machine)?, machine.info).ok()?);
            }
            further.extend(written(&more, machine).filter(|_| !machine.feedback.is_empty()));
        }
        // What is told is held against all numbers, as it would be if it were declared.
        let given = predictor.given();
        machine.closed_by(&laws).filter(|closed| Predictor::new(given, closed).fits(&closed.world()))?;
        let digits = gains.iter().map(|gain| digits(gain.value)).max().unwrap_or_default();
        let speed = Some(given.speeds()).filter(|all| all.len() == 1).map(|all| all[0]);
        let forces = inputs.iter().map(|input| input.names(machine.info).swap_remove(0)).collect();
        Some(Self { forces, laws: laws.into_iter().map(|law| law.written).collect(), further, speed, digits })
    }
}

/// Gains of one force, and others added to them; those that come to nothing are none.
fn sum(mut declared: Vec<Gain>, more: &[Gain]) -> Vec<Gain> {
    for gain in more {
        match declared.iter_mut().find(|own| (own.matrix, own.column) == (gain.matrix, gain.column)) {
            // Without what arithmetic left behind: 0.1 and 0.2 are 0.3.
            Some(own) => own.value = format!("{:.14e}", own.value + gain.value).parse().unwrap_or(f64::NAN),
            None => declared.push(*gain),
        }
    }
    declared.retain(|own| own.value != 0.0);
    declared
}

/// `Tdelta = -10*phi_rate + 3*delta`.
fn written(gains: &[Gain], machine: &Machine) -> Option<String> {
    let force = gains.first()?.input.names(machine.info).swap_remove(0);
    let terms: Vec<String> = gains.iter().map(|gain| conventions::term(gain, machine.info)).collect();
    Some(format!("{force} = {}", terms.join(" + ").replace("+ -", "- ")))
}

struct Search<'a> {
    machine: &'a Machine,
    predictor: &'a Predictor<'a>,
    /// The numbers as they are here.
    here: Vec<f64>,
}

impl<'a> Search<'a> {
    fn new(machine: &'a Machine, predictor: &'a Predictor<'a>) -> Self {
        Self { machine, predictor, here: predictor.predict(&machine.world()) }
    }

    /// The forces on the coordinates in whose equations anything differs, or else one force on several of them.
    fn inputs(&self) -> Option<Vec<Input>> {
        let (count, world) = (self.machine.formulas.count, self.machine.world());
        let entries = self.predictor.closed_entries(&world);
        let holds = |relation: &&Relation| relation.holds(&entries, world.gravity);
        // All entries of a relation stand in one row.
        let row = |relation: &Relation| relation.terms.first().map(|term| place(term.place, count).1);
        let wrong = self.predictor.relations().iter().filter(|own| !holds(own));
        let mut rows: Vec<usize> = wrong.map(row).collect::<Option<_>>()?;
        rows.sort_unstable();
        rows.dedup();
        if rows.len() < count {
            return Some(rows.into_iter().map(Input::Coordinate).collect())
                .filter(|inputs: &Vec<_>| !inputs.is_empty());
        }
        let all = Input::all(self.machine.info).into_iter();
        let mut others = all.filter(|input| matches!(input, Input::Applied(_)) && count > 1);
        others.find(|input| self.gains(*input).is_some()).map(|input| vec![input])
    }

    /// The gains of a force by each state; `None` where there are none that make what differs.
    fn gains(&self, input: Input) -> Option<Vec<Gain>> {
        let (count, shares) = (self.machine.formulas.count, input.shares(self.machine.info, &self.machine.parameters));
        // What a gain of one adds to each number: they are linear in the entries of C and K.
        let effect = |matrix: MatrixName, column: usize| -> Vec<f64> {
            let mut world = self.machine.world();
            for (row, share) in shares.iter().enumerate() {
                world.entries[index(matrix, row, column, count)] -= share;
            }
            let with = self.predictor.predict(&world);
            with.iter().zip(&self.here).map(|(with, here)| with - here).collect()
        };
        let speeds = self.predictor.given().speeds().len();
        let mut gains = Vec::new();
        for (is_rate, column) in states(self.machine.info) {
            let powers = POWERS[usize::from(!is_rate)].map(|matrix| (matrix, effect(matrix, column)));
            gains.extend(solve(self.predictor, &self.here, &powers, speeds)?.into_iter().map(|(matrix, value)| Gain {
                matrix,
                input,
                column,
                value,
            }));
        }
        gains.retain(|gain| gain.value != 0.0);
        (!gains.is_empty()).then_some(gains)
    }
}
