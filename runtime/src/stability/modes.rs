//! Which mode each eigenvalue belongs to.

use core::fmt;

use crate::{Coefficients, Complex, Scalar, SystemError};

/// A mode of the uncontrolled bicycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mode {
    /// The front frame swings into line: one eigenvalue.
    Castering,
    /// Slow leaning over: one eigenvalue.
    Capsize,
    /// Oscillation of lean and steer: two eigenvalues.
    Weave,
}

/// Reads `castering`, `capsize`, `weave`.
impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Castering => "castering",
            Self::Capsize => "capsize",
            Self::Weave => "weave",
        })
    }
}

/// One eigenvalue and the mode it belongs to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ModeValue {
    /// The mode.
    pub mode: Mode,
    /// The eigenvalue in 1/s.
    pub value: Complex<f64>,
}

/// The modes of a model with two coordinates, followed along speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Modes {}

impl Modes {
    /// Follows the modes along speed, at a gravitational field strength in N/kg.
    ///
    /// # Errors
    /// As [`Stability::new`](crate::Stability::new).
    pub fn new<T: Scalar>(coefficients: &Coefficients<T, 2>, gravity: f64) -> Result<Self, SystemError> {
        let _ = (coefficients, gravity);
        todo!()
    }

    /// The eigenvalues at a speed in m/s: castering, capsize, weave, weave.
    ///
    /// # Errors
    /// If the speed is negative or not finite, or if the system there has no eigenvalues in the range of `f64`.
    pub fn at(&self, speed: f64) -> Result<[ModeValue; 4], SystemError> {
        let _ = speed;
        todo!()
    }
}
