//! Inputs, outputs and states in JSON, and numbers by their names.

use carvallo_control::Signal;
use serde::{Serialize, Serializer};

use super::layout::Line;

/// An input, an output or a state.
#[derive(Serialize)]
pub struct Told<'a> {
    name: &'a str,
    label: &'a str,
    unit: &'a str,
}

impl<'a> Told<'a> {
    pub fn of(Signal { name, label, unit }: &'a Signal) -> Self {
        Self { name, label, unit }
    }

    /// Each on a line.
    pub fn all(signals: &'a [Signal]) -> Vec<Line<Self>> {
        signals.iter().map(Self::of).map(Line).collect()
    }
}

/// Numbers by the names of signals, in their order.
pub struct Named<'a>(Vec<(&'a str, f64)>);

impl<'a> Named<'a> {
    pub fn new(signals: &'a [Signal], values: impl IntoIterator<Item = f64>) -> Self {
        Self(signals.iter().map(|signal| signal.name.as_str()).zip(values).collect())
    }
}

impl Serialize for Named<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().copied())
    }
}
