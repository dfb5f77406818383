//! The best design that was found.

use carvallo_design::{Design, Failure};

use crate::measures::Measures;
use crate::problem::Problem;

/// The best design that was found. It lies within its ranges and keeps every constraint, exactly.
#[derive(Clone, Debug)]
pub struct Optimum {
    /// All parameters, in the order of the model.
    pub values: Vec<f64>,
    /// Those with ranges, in their order.
    pub varied: Vec<f64>,
    /// The measure of the goal, in its unit.
    pub value: f64,
    /// The same of the design that it began with; `None` where it has none.
    pub before: Option<f64>,
    /// Of each range at which end the optimum lies, if it does.
    pub ends: Vec<Option<End>>,
    /// Of each constraint whether it leaves no room.
    pub is_tight: Vec<bool>,
    /// From how many designs the search began, ...
    pub starts: u32,
    /// ... and how many of these searches came to the same value, to six digits.
    pub agreeing: u32,
    /// For how many designs the measures were computed.
    pub evaluations: u64,
}

/// An end of a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The least value.
    Low,
    /// The largest value.
    High,
}

/// How far a search has come.
#[derive(Clone, Copy, Debug)]
pub struct Progress {
    /// How many of the starts are done.
    pub done: u32,
    /// How many there are.
    pub starts: u32,
    /// The best value so far, in the unit of the measure.
    pub best: Option<f64>,
}

impl Optimum {
    /// What it violates of the ranges and the constraints: nothing.
    pub fn violations(&self, problem: &Problem) -> Vec<String> {
        let info = problem.design.info();
        let ranges = problem.ranges.iter().zip(&self.varied);
        let outside = ranges.filter(|(range, value)| !(range.low..=range.high).contains(value)).map(|(range, _)| range);
        let measures = Measures::new(problem.design.model, self.values.clone(), problem.settings.speeds).ok();
        let missed = problem.constraints.iter().filter(|constraint| {
            !constraint.excess(info, &self.values, measures.as_ref()).is_some_and(|excess| excess <= 0.0)
        });
        outside.map(|range| range.written.clone()).chain(missed.map(|missed| missed.written.clone())).collect()
    }

    /// The design that it began with, once more.
    ///
    /// # Errors
    /// If it has no equations of motion.
    pub fn given(&self, problem: &Problem) -> Result<Design, Failure> {
        problem.design.with_values(&problem.design.values()).map_err(Failure::Run)
    }

    /// The design itself.
    ///
    /// # Errors
    /// If it has no equations of motion.
    pub fn design(&self, problem: &Problem) -> Result<Design, Failure> {
        let from = problem.design;
        let source = from.source.as_ref().map(|source| format!("{source}; changed by carvallo optimize"));
        let changed = from.with_values(&self.values).map_err(Failure::Run)?;
        Ok(Design { name: format!("{}-optimal", from.name), source, ..changed })
    }
}
