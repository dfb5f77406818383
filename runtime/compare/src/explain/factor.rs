//! What may multiply something by mistake.

use carvallo::ModelInfo;

use super::AtDesign;

#[derive(Clone, Copy)]
pub enum Factor {
    Number(f64),
    Parameter(usize),
    Inverse(usize),
}

impl Factor {
    pub const ONE: Self = Self::Number(1.0);
    pub const MINUS: Self = Self::Number(-1.0);

    pub fn at(self, at: &AtDesign) -> f64 {
        match self {
            Self::Number(number) => number,
            Self::Parameter(index) => at.parameters[index],
            Self::Inverse(index) => 1.0 / at.parameters[index],
        }
    }

    /// What it does to something: `is twice as large`.
    pub fn says(self, info: &ModelInfo) -> String {
        match self {
            Self::Number(-1.0) => "has the opposite sign".into(),
            Self::Number(0.0) => "is zero".into(),
            Self::Number(2.0) => "is twice as large".into(),
            Self::Number(0.5) => "is half as large".into(),
            Self::Number(number) => format!("is {number} times as large"),
            Self::Parameter(index) => format!("has `{}` as a factor too many", info.parameters[index].name),
            Self::Inverse(index) => format!("is divided by `{}`", info.parameters[index].name),
        }
    }
}

/// The usual numbers, and all parameters.
pub fn factors(info: &'static ModelInfo) -> impl Iterator<Item = Factor> {
    let parameters = info.parameters.iter().enumerate().filter(move |(index, parameter)| {
        // Gravity stands before the matrices, so none depends on it.
        parameter.used || info.gravity == Some(*index)
    });
    let by_parameters = parameters.flat_map(|(index, _)| [Factor::Parameter(index), Factor::Inverse(index)]);
    [-1.0, 2.0, 0.5, 0.0].map(Factor::Number).into_iter().chain(by_parameters)
}
