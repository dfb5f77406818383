//! What can keep a motion from being computed.

use core::fmt;

#[cfg(feature = "simulation")]
use crate::motion::MotionError;

/// Why there is no motion, or none beyond a time.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SimulationError {
    /// A number that was given is infinite or not a number.
    NotFinite {
        /// What it is, such as `position 2`.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// There is another number of values than is needed.
    Length {
        /// What they are, such as `initial positions`.
        quantity: &'static str,
        /// How many there have to be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// The times at which the motion is asked for do not ascend.
    Unsorted {
        /// A time in s.
        time: f64,
        /// The one behind it, which is earlier.
        next: f64,
    },
    /// There is no position, free rate or force of a name.
    Unknown {
        /// What there is none of.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// The equations have no value in the state that the motion begins with.
    #[cfg(feature = "simulation")]
    Motion {
        /// The time in s.
        time: f64,
        /// Why.
        error: MotionError,
    },
    /// The motion leaves the range of `f64`, as one that is unstable does after a long time.
    OutOfRange {
        /// The time in s that is not reached.
        time: f64,
    },
    /// The step to a time is too long beside what moves fastest.
    TooLong {
        /// The time in s that is not reached.
        time: f64,
    },
}

impl fmt::Display for SimulationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { quantity, value } => write!(f, "{quantity}: {value} is not finite"),
            Self::Length { quantity, expected, found } => {
                write!(f, "{quantity}: there are {found}; there must be {expected}")
            }
            Self::Unsorted { time, next } => write!(f, "times must ascend, but behind {time} s comes {next} s"),
            Self::Unknown { what, name } => write!(f, "there is no {what} `{name}`"),
            #[cfg(feature = "simulation")]
            Self::Motion { time, error } => write!(f, "at {time} s: {error}"),
            Self::OutOfRange { time } => {
                write!(f, "the motion leaves the range of floating-point numbers before {time} s")
            }
            Self::TooLong { time } => write!(f, "the step to {time} s is too long beside what moves fastest"),
        }
    }
}

impl core::error::Error for SimulationError {}

/// Whether numbers that were given are finite.
pub(super) fn require_finite(quantity: &'static str, values: &[f64]) -> Result<(), SimulationError> {
    match values.iter().find(|value| !value.is_finite()) {
        Some(&value) => Err(SimulationError::NotFinite { quantity, value }),
        None => Ok(()),
    }
}

/// Whether there are as many as are needed.
pub(super) fn require_length(quantity: &'static str, expected: usize, found: usize) -> Result<(), SimulationError> {
    if found == expected { Ok(()) } else { Err(SimulationError::Length { quantity, expected, found }) }
}

/// Whether times are finite and ascend.
pub(super) fn require_ascending(times: &[f64]) -> Result<(), SimulationError> {
    require_finite("times", times)?;
    match times.windows(2).find(|pair| pair[1] < pair[0]) {
        Some(pair) => Err(SimulationError::Unsorted { time: pair[0], next: pair[1] }),
        None => Ok(()),
    }
}
