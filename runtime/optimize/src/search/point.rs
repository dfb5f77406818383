//! What is known of one design.

use super::WORSE;
use crate::measures::{Measured, Measures};

/// What is known of one design.
pub(super) struct Point {
    pub shares: Vec<f64>,
    /// Of the parameters with ranges.
    pub varied: Vec<f64>,
    /// Of the model; none where there is no such design.
    pub values: Option<Vec<f64>>,
    pub measures: Option<Measures>,
    pub measured: Option<Measured>,
    /// Of each constraint, relative to its size.
    pub excess: Vec<Option<f64>>,
}

impl Point {
    pub(super) fn keeps_all(&self) -> bool {
        self.excess.iter().all(|excess| excess.is_some_and(|excess| excess <= 0.0))
    }

    pub(super) fn value(&self) -> f64 {
        self.measured.as_ref().map_or(f64::NAN, |measured| measured.value)
    }

    /// How far it is from being stable.
    pub(super) fn instability(&self) -> f64 {
        self.measures.as_ref().map_or(WORSE, Measures::instability)
    }
}
