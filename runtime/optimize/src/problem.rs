//! What is asked for: a design, what of it may change, what is best, and what must be kept.

use carvallo_design::number::shortest;
use carvallo_design::{Design, Failure, Place};

use crate::bodies;
use crate::constraint::Constraint;
use crate::goal::{Goal, Measure};
use crate::range::Range;

/// What is asked for.
#[derive(Debug)]
pub struct Problem<'a> {
    /// Where it begins.
    pub design: &'a Design,
    /// What may change.
    pub ranges: Vec<Range>,
    /// What is best.
    pub goal: Goal,
    /// What must be kept, with what every bicycle keeps.
    pub constraints: Vec<Constraint>,
    /// How it is searched.
    pub settings: Settings,
}

/// How it is searched.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// The speeds that count, in m/s, from the lower to the higher one.
    pub speeds: [f64; 2],
    /// From how many designs the search begins: the given one, and others within the ranges.
    pub starts: u32,
    /// Of the generator of those others.
    pub seed: u64,
}

impl Default for Settings {
    fn default() -> Self {
        Self { speeds: [0.0, 20.0], starts: 8, seed: 1 }
    }
}

impl<'a> Problem<'a> {
    /// A problem with constraints such as `xB >= 0.2`.
    ///
    /// # Errors
    /// If nothing may change, or a parameter has two ranges; if a constraint cannot be read; or if nothing of the model depends
    /// on the speed, of which the goal is.
    pub fn new(design: &'a Design, ranges: Vec<Range>, goal: Goal, keep: &[String]) -> Result<Self, Failure> {
        let info = design.info();
        if ranges.is_empty() {
            return Err(Failure::usage("nothing may change: expected ranges, such as --vary w=0.9:1.2"));
        }
        for (index, range) in ranges.iter().enumerate() {
            if ranges[..index].iter().any(|other| other.position == range.position) {
                let place = Place::Option(format!("--vary {}", range.written));
                return Err(Failure::at(place, format!("`{}` has a range already", range.parameter.name)));
            }
        }
        if !matches!(goal.measure, Measure::Parameter(..)) && !design.model.depends_on_speed() {
            let message =
                format!("nothing in the model {} depends on the speed, so it has no {}", info.name, goal.measure);
            return Err(Failure::usage(message));
        }
        let values = design.values();
        let mut constraints = bodies::constraints(info, &ranges);
        for written in keep {
            constraints.push(Constraint::parse(written, info, &values)?);
        }
        Ok(Self { design, ranges, goal, constraints, settings: Settings::default() })
    }

    /// The same, searched in another way.
    ///
    /// # Errors
    /// If no speeds count, or there is no start.
    pub fn with(self, settings: Settings) -> Result<Self, Failure> {
        let [low, high] = settings.speeds;
        if !(low >= 0.0 && low < high && high.is_finite()) {
            let [low, high] = [low, high].map(shortest);
            return Err(Failure::usage(format!(
                "the speeds that count are from {low} to {high} m/s; they must ascend from 0"
            )));
        }
        if settings.starts == 0 {
            return Err(Failure::usage("the search has no start: expected 1 or more"));
        }
        Ok(Self { settings, ..self })
    }

    /// The parameters at shares of the ranges.
    pub(crate) fn values(&self, shares: &[f64]) -> Vec<f64> {
        let mut values = self.design.values();
        for (range, share) in self.ranges.iter().zip(shares) {
            values[range.position] = range.at(*share);
        }
        values
    }
}
