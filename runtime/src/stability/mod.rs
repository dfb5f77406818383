//! Stability along speed, for models with two coordinates.

mod modes;

use core::fmt;

use crate::{Coefficients, Complex, Scalar, SystemError};

pub use modes::{Mode, ModeValue, Modes};

/// The critical speeds and the stable ranges of a model with two coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Stability {
    /// All critical speeds above zero, ascending.
    pub critical_speeds: Vec<CriticalSpeed>,
    /// The ranges of speed in which the motion is stable, ascending.
    pub stable_ranges: Vec<StableRange>,
}

impl Stability {
    /// Everything about stability along speed, at a gravitational field strength in N/kg.
    ///
    /// # Errors
    /// If gravity or an entry is not finite, the mass matrix is singular, or the numbers differ too much in size.
    pub fn new<T: Scalar>(coefficients: &Coefficients<T, 2>, gravity: f64) -> Result<Self, SystemError> {
        let _ = (coefficients, gravity);
        todo!()
    }

    /// Whether the motion is stable at a speed in m/s.
    ///
    /// # Errors
    /// If the speed is negative or not finite.
    pub fn verdict(&self, speed: f64) -> Result<Verdict, SystemError> {
        let _ = speed;
        todo!()
    }
}

/// A speed at which the kind of motion changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CriticalSpeed {
    /// What happens there.
    pub kind: CriticalKind,
    /// The speed in m/s.
    pub speed: f64,
    /// An estimate of the absolute error of the speed in m/s.
    pub error: f64,
    /// The eigenvalue in 1/s: zero at capsize speeds, i omega with omega > 0 at weave speeds, the double eigenvalue at
    /// double-root speeds.
    pub eigenvalue: Complex<f64>,
    /// What changes as the speed grows.
    pub change: Change,
}

/// What happens at a critical speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CriticalKind {
    /// A conjugate pair is on the imaginary axis.
    Weave,
    /// A real eigenvalue is zero.
    Capsize,
    /// Two eigenvalues coincide.
    DoubleRoot,
}

/// Reads `weave`, `capsize`, `double_root`.
impl fmt::Display for CriticalKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Weave => "weave",
            Self::Capsize => "capsize",
            Self::DoubleRoot => "double_root",
        })
    }
}

/// What changes at a critical speed as the speed grows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Change {
    /// The eigenvalue or pair moves from the right half-plane to the left.
    Stabilizes,
    /// The eigenvalue or pair moves from the left half-plane to the right.
    Destabilizes,
    /// Two real eigenvalues become a complex pair.
    Merges,
    /// A complex pair becomes two real eigenvalues.
    Splits,
    /// Nothing lasts: the eigenvalues are on the same side, or of the same kind, before and after.
    Touches,
}

/// Reads `stabilizes`, `destabilizes`, `merges`, `splits`, `touches`.
impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Stabilizes => "stabilizes",
            Self::Destabilizes => "destabilizes",
            Self::Merges => "merges",
            Self::Splits => "splits",
            Self::Touches => "touches",
        })
    }
}

/// An open range of speeds in which every eigenvalue has a negative real part.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StableRange {
    /// The lower end in m/s.
    pub from: f64,
    /// The upper end in m/s; `None` if the range has no end.
    pub to: Option<f64>,
}

/// Whether the motion is stable at one speed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// Every eigenvalue has a negative real part.
    Stable,
    /// No eigenvalue has a positive real part, and at least one has a zero real part.
    Marginal,
    /// An eigenvalue has a positive real part.
    Unstable,
}

/// Reads `stable`, `marginal`, `unstable`.
impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Stable => "stable",
            Self::Marginal => "marginal",
            Self::Unstable => "unstable",
        })
    }
}
