//! Values of the parameters for which a claim is wrong.

use super::intervals::Interval;
use super::ranges::{Ranges, Reading};
use crate::domain::{Bound, Domain};
use crate::equations::Equations;
use crate::formula::Formula;
use crate::model::{ParameterSet, Requirement};

/// Where two formulas differ, beyond any rounding.
#[derive(Debug)]
pub struct Counterexample {
    /// The parameter set that the values come from, if they do.
    pub set: Option<String>,
    /// The parameters that the formulas depend on, by position, and their values.
    pub values: Vec<(usize, f64)>,
    /// The value of the one formula.
    pub left: f64,
    /// The value of the other.
    pub right: f64,
}

/// Values inside the domains that are tried before a proof is looked for: they refute nearly all that is wrong, and what they
/// do not is right, as a rule.
pub const FEW: usize = 50;
/// Values inside the domains that are tried where no proof was found.
pub const MANY: usize = 1_000;
/// How many times as many are looked at, at most; some requirement may refuse them.
const DRAWN: usize = 5;

/// What values may be tried.
#[derive(Debug)]
pub struct Space<'a> {
    pub domains: &'a [Domain],
    pub requirements: &'a [Requirement],
    pub sets: &'a [&'a ParameterSet],
}

impl Space<'_> {
    /// Looks for a counterexample to the equality of two formulas, among so many values at most, which are the same ones
    /// each time.
    ///
    /// # Errors
    /// If none is found, the number of values that were tried.
    pub fn find_counterexample(
        &self,
        most: usize,
        definitions: &[Formula],
        pair: &Equations,
        left: &Formula,
        right: &Formula,
    ) -> Result<Counterexample, usize> {
        let conditions = self.requirements.iter().map(|requirement| requirement.value.clone());
        let outputs = [left.clone(), right.clone()].into_iter().chain(conditions).collect();
        let equations = Equations::of_formulas(self.domains.len(), definitions, outputs);
        let used = find_parameters(pair);
        let found = |values: &[f64], set: Option<String>| -> Result<Counterexample, bool> {
            let (left, right) = self.differ(&equations, values)?;
            Ok(Counterexample { set, values: used.iter().map(|index| (*index, values[*index])).collect(), left, right })
        };
        let mut tried = 0;
        for set in self.sets {
            match found(&set.values, Some(set.name.to_string())) {
                Ok(counterexample) => return Ok(counterexample),
                Err(inside) => tried += usize::from(inside),
            }
        }
        let candidates: Vec<Vec<f64>> = self.domains.iter().map(list_candidates).collect();
        let mut random = Random(1);
        for drawn in 0..DRAWN * most {
            // Simple values first.
            let simple = 3 + drawn / 16;
            let values: Option<Vec<f64>> =
                candidates.iter().map(|all| all.get(random.below(all.len().min(simple))).copied()).collect();
            let Some(values) = values else { break };
            match found(&values, None) {
                Ok(counterexample) => return Ok(counterexample),
                Err(inside) => tried += usize::from(inside),
            }
            if tried >= most {
                break;
            }
        }
        Err(tried)
    }

    /// The values of the first two outputs, if they differ.
    ///
    /// # Errors
    /// If they do not, whether the values of the parameters are allowed and both outputs have a value.
    fn differ(&self, equations: &Equations, parameters: &[f64]) -> Result<(f64, f64), bool> {
        let mut definitions = Vec::with_capacity(equations.definitions.len());
        for definition in &equations.definitions {
            definitions.push(definition.evaluate(parameters, &definitions));
        }
        let outputs: Vec<f64> = equations.outputs.iter().map(|o| o.evaluate(parameters, &definitions)).collect();
        let conditions = self.requirements.iter().zip(&outputs[2..]);
        let allowed = conditions.into_iter().all(|(requirement, value)| requirement.domain.contains(*value));
        let (left, right) = (outputs[0], outputs[1]);
        if !allowed || !left.is_finite() || !right.is_finite() {
            return Err(false);
        }
        // Equal up to rounding, most likely, and then the intervals will not tell them apart.
        if (left - right).abs() <= 1e-14 * left.abs().max(right.abs()) {
            return Err(true);
        }
        let points = parameters.iter().map(|value| Interval::point(*value)).collect();
        let mut ranges = Ranges::new(Reading::Exact, points);
        equations.definitions.iter().for_each(|definition| ranges.push_definition(definition));
        let [a, b] = [0, 1].map(|side| ranges.of(&equations.outputs[side]));
        if a.is_apart_from(b) { Ok((left, right)) } else { Err(true) }
    }
}

/// The parameters that formulas depend on.
fn find_parameters(equations: &Equations) -> Vec<usize> {
    let mut used = vec![false; equations.parameters];
    for formula in equations.definitions.iter().chain(&equations.outputs) {
        formula.walk(&mut |part| {
            if let Formula::Parameter(index) = part {
                used[*index] = true;
            }
        });
    }
    (0..used.len()).filter(|index| used[*index]).collect()
}

/// Short numbers, the simplest first.
const SHORT: [f64; 18] =
    [1.0, 2.0, 3.0, 5.0, 0.5, 4.0, -1.0, 0.2, -2.0, 10.0, 0.1, -0.5, 0.25, -3.0, 0.05, 0.01, 100.0, 0.001];

/// Short numbers of a domain.
fn list_candidates(domain: &Domain) -> Vec<f64> {
    let value = |bound| match bound {
        Bound::Unbounded => None,
        Bound::Open(value) | Bound::Closed(value) => Some(value),
    };
    let mut all: Vec<f64> = SHORT.to_vec();
    match (value(domain.lower), value(domain.upper)) {
        (Some(low), Some(high)) => {
            all.extend([0.5, 0.25, 0.75, 0.125, 0.875].map(|part| shortest(low, high, low + (high - low) * part)));
            all.extend([low, high]);
        }
        (Some(low), None) => all.extend([low].into_iter().chain(SHORT.map(|beyond| low + beyond.abs()))),
        (None, Some(high)) => all.extend([high].into_iter().chain(SHORT.map(|below| high - below.abs()))),
        (None, None) => {}
    }
    all.retain(|value| domain.contains(*value));
    all
}

/// A number between two with few digits, near one between them.
fn shortest(low: f64, high: f64, near: f64) -> f64 {
    let rounded = (0..17).filter_map(|digits| format!("{near:.digits$e}").parse::<f64>().ok());
    rounded.into_iter().find(|value| *value > low && *value < high).unwrap_or(near)
}

/// Numbers that look random and are the same in every run.
struct Random(u64);

impl Random {
    fn below(&mut self, count: usize) -> usize {
        // Multiplier and increment are Knuth's (MMIX).
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) % count.max(1) as u64) as usize
    }
}
