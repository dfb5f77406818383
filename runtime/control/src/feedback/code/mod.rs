//! Scheduled gains as source text of other languages: what a controller runs needs nothing of this crate.

mod c;
mod rust;

use std::fmt::Write as _;

use carvallo_design::Design;
use carvallo_design::number::shortest;

use super::regulator::Regulator;
use super::schedule::Schedule;
use super::weights::Weights;
use crate::{Ports, Signal};

/// A language that a schedule is written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Code {
    /// A module that needs `core` alone, and does not allocate.
    Rust,
    /// C99 without a header, C++ as well.
    C,
}

impl Schedule {
    /// The gains as tables of constants, with functions that interpolate between them linearly along the speed and hold those at the
    /// ends beyond, and that give the inputs for a state. At one speed alone there is nothing to interpolate, and no speed to give.
    ///
    /// At the speeds of the schedule the gains are the same to the last bit.
    pub fn code(&self, language: Code, design: &Design, weights: &Weights) -> String {
        let text = Text { schedule: self, about: about(self, design, weights) };
        match language {
            Code::Rust => rust::write(&text),
            Code::C => c::write(&text),
        }
    }
}

/// What is written.
struct Text<'a> {
    schedule: &'a Schedule,
    /// Lines that say what it is, without anything that would end a comment.
    about: Vec<String>,
}

impl Text<'_> {
    fn first(&self) -> &Regulator {
        &self.schedule.regulators[0]
    }

    /// How many inputs and states there are, and speeds.
    fn counts(&self) -> [usize; 3] {
        let space = &self.first().space;
        [space.inputs.len(), space.states.len(), self.schedule.regulators.len()]
    }
}

fn about(schedule: &Schedule, design: &Design, weights: &Weights) -> Vec<String> {
    let space = &schedule.regulators[0].space;
    let list = |signals: &[Signal]| {
        let named = |signal: &Signal| format!("{} ({})", signal.name, signal.unit);
        signals.iter().map(named).collect::<Vec<_>>().join(", ")
    };
    let ports = Ports::of(design);
    let of_outputs = weights.outputs.iter().map(|(output, weight)| (ports.signal(*output).name, weight));
    let of_inputs = weights.inputs.iter().map(|(input, weight)| (ports.inputs[*input].name.clone(), weight));
    let weights = of_outputs.chain(of_inputs).fold(String::new(), |mut text, (name, weight)| {
        let between = if text.is_empty() { "" } else { ", " };
        // Writing to a string cannot fail.
        let _ = write!(text, "{between}{name} = {}", shortest(*weight));
        text
    });
    let speed = match (&schedule.regulators[..], space.speed) {
        ([_], Some(speed)) => format!(", at {} m/s", shortest(speed)),
        ([_], None) => String::new(),
        _ => ", scheduled along the speed".to_owned(),
    };
    let laws = design.feedback.iter().map(|law| format!("Beside it: {}", law.written));
    let lines = [
        format!("Gains of a linear quadratic regulator for {}{speed}.", design.title()),
        String::new(),
        format!("Inputs: {}", list(&space.inputs)),
        format!("States: {}", list(&space.states)),
        format!("Weights: {weights}"),
    ];
    // A name may have anything in it.
    let harmless = |line: String| line.replace(char::is_control, " ").replace("*/", "* /").replace("/*", "/ *");
    lines.into_iter().chain(laws).map(harmless).collect()
}

/// A speed for a comment.
fn speed(regulator: &Regulator) -> String {
    regulator.space.speed.map(|speed| format!("{} m/s", shortest(speed))).unwrap_or_default()
}

/// The rows of the gains between brackets of a language.
fn rows(regulator: &Regulator, [open, close]: [char; 2]) -> String {
    let row = |row: Vec<String>| format!("{open}{}{close}", row.join(", "));
    let rows = regulator.gains.row_iter().map(|gains| row(gains.iter().map(|gain| format!("{gain:?}")).collect()));
    row(rows.collect())
}
