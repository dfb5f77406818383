//! Why the symbolic stage makes nothing of equations.

use std::fmt;

use nanoserde::{DeBin, SerBin};

/// Why nothing came out of the engine.
#[derive(Debug)]
pub enum EngineFailure {
    /// The lock or the thread could not be had.
    System(String),
    /// The engine stopped with a message.
    Stopped(String),
}

impl fmt::Display for EngineFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::System(message) => write!(f, "the symbolic engine could not be started: {message}"),
            Self::Stopped(message) => write!(f, "the symbolic engine failed on this model: {message}"),
        }
    }
}

/// Why nothing became of equations.
#[derive(Debug)]
pub enum Failure {
    /// The engine could not be had, or stopped.
    Engine(EngineFailure),
    /// A formula has no value, whatever the parameters.
    Undefined {
        /// The position of its equations among those that are compiled together.
        equations: usize,
        /// The formula.
        place: Place,
        /// What is wrong with it.
        why: Undefined,
    },
}

impl From<EngineFailure> for Failure {
    fn from(failure: EngineFailure) -> Self {
        Self::Engine(failure)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Engine(failure) => write!(f, "{failure}"),
            Self::Undefined { why, .. } => write!(f, "{why}"),
        }
    }
}

/// A formula among equations: the definition of the model, or the output, at a position.
#[derive(Clone, Copy, Debug, DeBin, PartialEq, Eq, SerBin)]
pub enum Place {
    /// The definition at a position of the model.
    Definition(usize),
    /// The output at a position of the equations.
    Output(usize),
}

/// Why a formula has no value, whatever the parameters.
#[derive(Clone, Copy, Debug, DeBin, PartialEq, Eq, SerBin)]
pub enum Undefined {
    /// A divisor that is identically zero, or a power of zero that is not positive.
    DivisionByZero,
    /// The square root of a negative number.
    RootOfNegative,
}

/// Reads as a whole message.
impl fmt::Display for Undefined {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::DivisionByZero => "a division by zero here: expected divisors that are not zero for all parameters",
            Self::RootOfNegative => "the square root of a negative number here: expected one of a number >= 0",
        })
    }
}
