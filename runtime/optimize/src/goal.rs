//! What is to be as small, or as large, as can be.

use std::fmt;

use carvallo::ModelInfo;
use carvallo_design::conventions::{Convention, Quantity};
use carvallo_design::nearest;
use carvallo_design::parameter::find;

/// A measure that is minimized or maximized.
#[derive(Clone, Copy, Debug)]
pub struct Goal {
    /// What of the design.
    pub measure: Measure,
    /// Whether more of it is better.
    pub maximize: bool,
}

/// What a design is measured by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Measure {
    /// The width of the widest stable range of speeds, in m/s, as far as it is within the speeds that count.
    StableRange,
    /// The speed in m/s above which weave is stable: the highest at which it becomes so.
    WeaveSpeed,
    /// The lowest speed in m/s at which it becomes unstable by an eigenvalue that is zero: capsize, or divergence.
    CapsizeSpeed,
    /// The lowest speed in m/s at which it becomes unstable by an oscillation: flutter, wobble, or weave.
    FlutterSpeed,
    /// A parameter of the model, or of a convention, in its unit.
    Parameter(Quantity),
}

/// The names of what is no parameter, on the command line and in constraints.
const NAMES: [(&str, Measure); 6] = [
    ("stable-range", Measure::StableRange),
    ("weave-speed", Measure::WeaveSpeed),
    ("capsize-speed", Measure::CapsizeSpeed),
    ("divergence-speed", Measure::CapsizeSpeed),
    ("flutter-speed", Measure::FlutterSpeed),
    ("wobble-speed", Measure::FlutterSpeed),
];

impl Goal {
    /// As little of a measure as can be.
    pub fn minimize(measure: Measure) -> Self {
        Self { measure, maximize: false }
    }

    /// As much of a measure as can be.
    pub fn maximize(measure: Measure) -> Self {
        Self { measure, maximize: true }
    }
}

impl Measure {
    /// The measure called `name`: `stable-range`, `weave-speed`, `capsize-speed`, `divergence-speed`, `flutter-speed` or
    /// `wobble-speed`, or a parameter of the model, or of a convention.
    ///
    /// # Errors
    /// If there is none.
    pub fn called(name: &str, info: &ModelInfo) -> Result<Self, String> {
        Self::find(name, info, None).ok_or_else(|| {
            let names: Vec<&str> = NAMES.iter().map(|(name, _)| *name).collect();
            let message = find(name, info).err().unwrap_or_else(|| format!("`{name}` is not known"));
            let meant = if message.contains("did you mean") { None } else { nearest(name, names.iter().copied()) };
            let meant = meant.map(|meant| format!("; did you mean `{meant}`?")).unwrap_or_default();
            format!("{message}{meant}; expected a parameter, or one of {}", names.join(", "))
        })
    }

    /// The same, if there is one; of names that several conventions have, that of the one beside it is meant.
    pub(crate) fn find(name: &str, info: &ModelInfo, beside: Option<&'static Convention>) -> Option<Self> {
        Self::of_speeds(name).or_else(|| Quantity::called(name, info, beside).map(Self::Parameter))
    }

    /// The measure of speeds called `name`, with `-` or with `_` in it.
    pub(crate) fn of_speeds(name: &str) -> Option<Self> {
        NAMES.iter().find(|(known, _)| *known == name.replace('_', "-")).map(|(_, measure)| *measure)
    }

    /// An expression with `_` in the names of measures of speeds, where `-` would be a difference.
    pub(crate) fn with_underscores(expression: &str) -> String {
        NAMES.iter().fold(expression.to_owned(), |text, (name, _)| text.replace(name, &name.replace('-', "_")))
    }

    /// What a design has of which this is the measure, with an article.
    pub(crate) fn had(self) -> String {
        match self {
            Self::StableRange => "a stable range".to_owned(),
            measure => format!("a {measure}"),
        }
    }

    /// The unit of it.
    pub fn unit(self) -> &'static str {
        if let Self::Parameter(quantity) = self { quantity.info.unit } else { "m/s" }
    }
}

/// Reads as a sentence has it: `weave speed`.
impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::StableRange => "width of the stable range",
            Self::WeaveSpeed => "weave speed",
            Self::CapsizeSpeed => "speed of capsize or divergence",
            Self::FlutterSpeed => "speed of flutter",
            Self::Parameter(quantity) => quantity.info.name,
        })
    }
}
