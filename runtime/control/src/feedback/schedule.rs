//! Gains scheduled along speeds.

use carvallo_design::number::shortest;
use carvallo_design::{Design, Failure};
use nalgebra::DMatrix;

use super::modes::eigenvalues;
use super::regulator::Regulator;
use super::weights::Weights;
use crate::StateSpace;

/// Regulators of one machine with the same weights, between whose speeds the gains are interpolated linearly.
#[derive(Clone, Debug, PartialEq)]
pub struct Schedule {
    /// With ascending speeds; a single one without a speed where nothing depends on it.
    pub regulators: Vec<Regulator>,
    /// The speeds in m/s between which a motion grows with the interpolated gains, at the middle.
    pub unstable: Vec<[f64; 2]>,
}

impl Schedule {
    /// At speeds in m/s, of which there is at least one; where nothing depends on the speed they do not matter.
    ///
    /// # Errors
    /// Those of [`Regulator::new`] at one of the speeds, or if states drop out at one of them.
    pub fn new(design: &Design, speeds: &[f64], weights: &Weights) -> Result<Self, Failure> {
        let mut speeds = speeds.to_vec();
        speeds.sort_by(f64::total_cmp);
        speeds.dedup();
        speeds.truncate(if design.model.depends_on_speed() { speeds.len() } else { 1 });
        let regulators = speeds.iter().map(|&speed| Regulator::new(design, speed, weights));
        let regulators: Vec<Regulator> = regulators.collect::<Result<_, _>>()?;
        if let Some(first) = regulators.iter().find(|other| other.space.states != regulators[0].space.states) {
            let speed = first.space.speed.map(shortest).unwrap_or_default();
            let why = "the outputs depend on other states there; start the schedule elsewhere";
            return Err(Failure::Run(format!("{} at {speed} m/s: {why}", design.title())));
        }
        let unstable = between(design, &regulators, weights)?;
        Ok(Self { regulators, unstable })
    }

    /// Of each regulator the [derivatives](Regulator::sensitivities) of its gains with respect to each parameter.
    ///
    /// # Errors
    /// Those of the first regulator that has none.
    pub fn sensitivities(&self, design: &Design, weights: &Weights) -> Result<Vec<Vec<DMatrix<f64>>>, Failure> {
        self.regulators.iter().map(|regulator| regulator.sensitivities(design, weights)).collect()
    }
}

/// The intervals in whose middle a motion grows with the gains of both ends halved and added.
fn between(design: &Design, regulators: &[Regulator], weights: &Weights) -> Result<Vec<[f64; 2]>, Failure> {
    let inputs: Vec<usize> = weights.inputs.iter().map(|(input, _)| *input).collect();
    let outputs: Vec<_> = weights.outputs.iter().map(|(output, _)| *output).collect();
    let mut unstable = Vec::new();
    for pair in regulators.windows(2) {
        let [low, high] = [&pair[0], &pair[1]];
        let [Some(from), Some(to)] = [low.space.speed, high.space.speed] else { continue };
        let space = StateSpace::new(design, 0.5 * (from + to), &inputs, &outputs)?;
        let closed = &space.a - &space.b * (0.5 * (&low.gains + &high.gains));
        if eigenvalues(closed).is_none_or(|values| values.iter().any(|value| value.re >= 0.0)) {
            unstable.push([from, to]);
        }
    }
    Ok(unstable)
}
