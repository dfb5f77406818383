//! What can keep a mechanism from moving.

use core::fmt;

/// Why there is no answer of a [`Motion`](super::Motion).
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum MotionError {
    /// What was given is infinite or not a number.
    NotFinite {
        /// The name of the position or of the force; of a speed, that of the position whose rate it is.
        name: &'static str,
        /// What of it: `position`, `rate` or `force`.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// No positions were found in which every wheel touches the ground.
    NotClosed {
        /// A wheel that does not.
        wheel: &'static str,
        /// How far its lowest point is below the ground at the end of the search, in m.
        below: f64,
    },
    /// The machine is singular in this state: a wheel lies flat, or the contacts no longer determine how it moves. Or the
    /// numbers leave the range of their type.
    Singular {
        /// What has no value.
        quantity: &'static str,
    },
}

impl fmt::Display for MotionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { name, what: "position", value } => {
                write!(f, "the position `{name}` is {value}; it must be finite")
            }
            Self::NotFinite { name, what: "rate", value } => {
                write!(f, "the rate of `{name}` is {value}; it must be finite")
            }
            Self::NotFinite { name, what, value } => write!(f, "the {what} `{name}` is {value}; it must be finite"),
            Self::NotClosed { wheel, below } => write!(
                f,
                "no position was found in which all wheels touch the ground: the lowest point of `{wheel}` is {below} m below \
                 it; the other positions must leave that possible"
            ),
            Self::Singular { quantity } => write!(
                f,
                "{quantity} has no value in this state: a wheel lies flat, or the contacts do not determine the motion"
            ),
        }
    }
}

impl core::error::Error for MotionError {}
