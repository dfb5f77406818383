//! Numbers that agree beside others that do not: they may be of somewhere else, as critical speeds that were copied.

use serde::Serialize;

use super::groups::groups;
use crate::explain::{Found, Search};
use crate::given::{Given, Quantity};
use crate::machine::Machine;
use crate::predict::Predictor;

/// What agrees as a whole, and what explains all that does not.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Elsewhere {
    /// What all of agrees, such as `critical speeds`.
    pub agreeing: Vec<String>,
    /// What makes all others, one or the other, the likeliest first; no more than a few.
    pub causes: Vec<String>,
}

/// So many causes are told.
const TOLD: usize = 4;

impl Elsewhere {
    /// None where nothing agrees as a whole, or where no single cause makes what is left.
    pub fn new(machine: &Machine, predictor: &Predictor, has_contradictions: bool) -> Option<Self> {
        let (rest, agreeing) = without_agreeing(machine, predictor, has_contradictions)?;
        let own = Predictor::new(&rest, machine);
        // Some cause or other makes a few digits, and a value of many.
        if own.has_few_digits() {
            return None;
        }
        let mut found: Vec<Found> = Search::new(machine, &own, &own).by_one(&own);
        found.retain(Found::is_plain);
        let told = groups(machine, &own, found).into_iter().flat_map(|group| group.explanations);
        let mut causes: Vec<String> = told.map(|own| own.causes.join(", and ")).collect();
        causes.truncate(TOLD);
        (!causes.is_empty()).then_some(Self { agreeing, causes })
    }
}

/// The numbers without those kinds of which all agree, and what these are called; `None` where there are none, or no others. Of state
/// matrices that contradict one another each is one by itself.
fn without_agreeing(machine: &Machine, predictor: &Predictor, is_each: bool) -> Option<(Given, Vec<String>)> {
    let here = predictor.predict(&machine.world());
    let agrees = |is_of: &dyn Fn(Quantity) -> bool| {
        let mut own = predictor.numbers().iter().enumerate().filter(|(_, (quantity, _))| is_of(*quantity)).peekable();
        own.peek().is_some() && own.all(|(at, _)| predictor.agrees(at, here[at]))
    };
    let (mut rest, mut agreeing) = (predictor.given().clone(), Vec::new());
    if agrees(&|own| matches!(own, Quantity::Entry(..) | Quantity::System(..))) {
        rest.matrices.clear();
        rest.system_matrices.clear();
        agreeing.push("matrices of the equations of motion".to_owned());
    }
    if agrees(&|own| matches!(own, Quantity::State(..))) {
        rest.state_matrices.clear();
        agreeing.push("A".to_owned());
    } else if is_each {
        let is_right = |at: &usize| agrees(&|own| matches!(own, Quantity::State(of, ..) if of == *at));
        let right: Vec<usize> = (0..rest.state_matrices.len()).filter(is_right).collect();
        let kept = rest.state_matrices.iter().enumerate().filter(|(at, _)| !right.contains(at));
        rest.state_matrices = kept.map(|(_, own)| own.clone()).collect();
        agreeing.extend(right.into_iter().map(|at| predictor.given().state_name(at)));
    }
    if agrees(&|own| matches!(own, Quantity::RealPart(..) | Quantity::ImaginaryPart(..))) {
        rest.eigenvalues.clear();
        agreeing.push("eigenvalues".to_owned());
    }
    if agrees(&|own| matches!(own, Quantity::CriticalSpeed(_))) {
        rest.critical_speeds.clear();
        agreeing.push("critical speeds".to_owned());
    }
    if agrees(&|own| matches!(own, Quantity::Acceleration(..))) {
        rest.accelerations.clear();
        agreeing.push("accelerations".to_owned());
    }
    (!agreeing.is_empty() && !rest.numbers().is_empty()).then_some((rest, agreeing))
}
