//! Columns that do not fit together.

use core::fmt;

/// Columns or slices that do not fit a model or each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BatchError {
    /// There are not as many columns as the model has parameters or entries.
    Columns {
        /// The name of the model.
        model: &'static str,
        /// `parameters` or `entries`.
        what: &'static str,
        /// How many the model has.
        expected: usize,
        /// How many were given.
        found: usize,
    },
    /// A column or slice is not as long as the first one.
    Length {
        /// What it is: `parameter`, `entry`, `column` or `result`.
        what: &'static str,
        /// Its position among the columns.
        position: usize,
        /// The length of the first column.
        expected: usize,
        /// Its own length.
        found: usize,
    },
    /// Parameters are neither of one design for all states nor of one for each.
    Designs {
        /// Of how many designs.
        designs: usize,
        /// How many states there are.
        states: usize,
    },
    /// A number that says how motions are simulated is not what it has to be.
    Simulation {
        /// What it is.
        what: &'static str,
        /// What it has to be.
        required: &'static str,
        /// What was given.
        found: f64,
    },
}

impl BatchError {
    /// Whether there is room for as many results as there are inputs.
    pub(super) fn require_room(what: &'static str, expected: usize, found: usize) -> Result<(), Self> {
        if expected == found { Ok(()) } else { Err(Self::Length { what, position: 0, expected, found }) }
    }
}

impl fmt::Display for BatchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Columns { model, what, expected, found } => {
                write!(f, "{model}: {found} columns of {what} given; it has {expected} {what}")
            }
            Self::Length { what, position, expected, found } => {
                write!(
                    f,
                    "{what} {position} is given for {found} designs: expected {expected}, as many as there are of the first"
                )
            }
            Self::Designs { designs, states } => write!(
                f,
                "parameters of {designs} designs are given for {states} states: expected those of one design, or as many as there are states"
            ),
            Self::Simulation { what, required, found } => write!(f, "{what} is {found}: expected {required}"),
        }
    }
}

impl core::error::Error for BatchError {}
