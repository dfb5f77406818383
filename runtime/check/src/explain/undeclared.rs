//! A closed loop that nobody declared: what differs stands in the equations of some forces alone, and is linear in the states.

use carvallo::MatrixName;
use carvallo_design::feedback::{Gain, Input, Law};
use carvallo_slips::{index, place};
use serde::Serialize;

use super::solve::digits;
use crate::conventions;
use crate::machine::Machine;
use crate::predict::Predictor;
use crate::relation::Relation;
use crate::states::states;

/// Forces in whose span everything is that differs of state matrices, or of C and K: a feedback of them makes it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Undeclared {
    /// What they are called.
    pub forces: Vec<String>,
    /// What they follow from, as `--feedback` has it, where that is known: the closed loop with these has all numbers.
    pub laws: Vec<String>,
    /// The digits of the gain that has the most.
    #[serde(skip)]
    pub digits: usize,
}

/// What a gain may be multiplied by, of a rate and of a position: the first with which one gain makes all speeds.
const POWERS: [[MatrixName; 3]; 2] =
    [[MatrixName::C0, MatrixName::C1, MatrixName::Cm1], [MatrixName::Kc, MatrixName::K1, MatrixName::K2]];

/// Those forces, fewer than there are coordinates: all of them together span everything. None where there is feedback already, and
/// where nothing but entries of M, C1, … is given.
pub fn find<'a>(machine: &'a Machine, predictor: &'a Predictor<'a>) -> Option<Undeclared> {
    let given = predictor.given();
    let has_any = !(given.state_matrices.is_empty() && given.system_matrices.is_empty());
    if !has_any || !machine.feedback.is_empty() {
        return None;
    }
    let search = Search::new(machine, predictor);
    let inputs = search.inputs()?;
    let forces = inputs.iter().map(|input| input.names(machine.info).swap_remove(0)).collect();
    let gains: Option<Vec<Vec<Gain>>> = inputs.iter().map(|input| search.gains(*input)).collect();
    let laws: Option<Vec<Law>> =
        gains.unwrap_or_default().iter().map(|gains| Law::read(&written(gains, machine)?, machine.info).ok()).collect();
    let mut laws = laws.unwrap_or_default();
    // What is told is held against all numbers, as it would be if it were declared.
    let closed = machine.closed_by(&laws).filter(|closed| Predictor::new(given, closed).fits(&closed.world()));
    if closed.is_none() {
        laws.clear();
    }
    let digits = laws.iter().flat_map(|law| &law.gains).map(|gain| digits(gain.value)).max().unwrap_or_default();
    Some(Undeclared { forces, laws: laws.into_iter().map(|law| law.written).collect(), digits })
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
        let (count, gravity) = (self.machine.formulas.count, self.machine.gravity(&self.machine.parameters));
        let holds = |relation: &&Relation| relation.holds(&self.machine.values.entries, gravity);
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
        let mut gains = Vec::new();
        for (is_rate, column) in states(self.machine.info) {
            let gain = |matrix: MatrixName| {
                let value = self.solve(&effect(matrix, column))?;
                Some(Gain { matrix, input, column, value })
            };
            gains.push(POWERS[usize::from(!is_rate)].into_iter().find_map(gain)?);
        }
        gains.retain(|gain| gain.value != 0.0);
        (!gains.is_empty()).then_some(gains)
    }

    /// The gain that makes all numbers on which it has an effect, with the fewest digits.
    fn solve(&self, effect: &[f64]) -> Option<f64> {
        let numbers = self.predictor.numbers().iter().zip(self.predictor.tolerances()).zip(&self.here).zip(effect);
        let all =
            numbers.map(|((((_, reading), tolerance), here), effect)| (reading.value - here, *tolerance, *effect));
        // What rounding leaves of it is none.
        let known: Vec<(f64, f64, f64)> = all.filter(|(_, tolerance, effect)| effect.abs() > *tolerance).collect();
        let weighted = |of: &dyn Fn(f64, f64) -> f64| -> f64 {
            known.iter().map(|(off, tolerance, effect)| of(*off, *effect) / (tolerance * tolerance)).sum()
        };
        let value = weighted(&|off, effect| off * effect) / weighted(&|_, effect| effect * effect);
        let fits =
            |value: &f64| known.iter().all(|(off, tolerance, effect)| (off - effect * value).abs() <= *tolerance);
        let rounded = (0..17).filter_map(|digits| format!("{value:.digits$e}").parse().ok());
        [0.0].into_iter().chain(rounded).filter(|value: &f64| value.is_finite()).find(fits)
    }
}
