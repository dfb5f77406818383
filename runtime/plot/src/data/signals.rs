//! Inputs, outputs and states in JSON.

use carvallo_control::Signal;
use serde::Serialize;

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
