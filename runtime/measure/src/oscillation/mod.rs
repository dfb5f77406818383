//! The period of a pendulum from its recorded motion: a decaying sine with an offset, fitted by least squares.
//!
//! As BicycleParameters fits the voltage of a rate gyro; an angle, a position or a rate of any size does as well.

mod fit;
mod guess;
mod samples;
mod signal;

pub use self::fit::{FitError, Oscillation, fit};
pub(crate) use self::signal::Recording;
