//! Critical speeds: what they are.

use core::fmt;

use nalgebra::Complex;

use super::mode::Mode;

/// A speed above zero at which the kind of motion changes.
///
/// The speed zero is never listed. It is the end of the speeds, not a speed at which anything changes; and without
/// damping that does not depend on the speed (C0 = 0) the eigenvalues there are symmetric about the imaginary axis, so
/// that conditions for critical speeds hold there for every model.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct CriticalSpeed {
    /// What happens there.
    pub kind: CriticalKind,
    /// The speed in m/s.
    pub speed: f64,
    /// An estimate of the absolute error of the speed in m/s: what the rounding of the matrix entries to `f64` may do to
    /// it, and its own rounding. Large where the change is fragile, such as where eigenvalues only touch.
    pub error: f64,
    /// The eigenvalue in 1/s: zero at capsize speeds, i omega with omega > 0 at weave speeds, the double eigenvalue at
    /// double-root speeds (of a conjugate pair of double eigenvalues the one with a positive imaginary part).
    #[cfg_attr(feature = "serde", serde(with = "super::complex::Parts"))]
    pub eigenvalue: Complex<f64>,
    /// What changes as the speed grows.
    pub change: Change,
}

impl CriticalSpeed {
    /// What oscillates as fast as this or faster is called wobble, in rad/s: 5 Hz.
    ///
    /// Weave of bicycles and motorcycles is reported with 2 to 4 Hz, and up to 5 at the highest speeds, wobble with 6 to 10.
    pub const WOBBLE: f64 = 10.0 * core::f64::consts::PI;

    /// The mode that is on the imaginary axis here, by the names of machines that lean and steer, or else of all others;
    /// `None` at a double root, but where it is pairs on the axis that meet, and become unstable by it or stable: that is how
    /// what nothing damps flutters.
    ///
    /// Of two coordinates, lean and steer alone, every pair on the axis is weave: [`Modes`](crate::Modes).
    pub fn mode(&self, is_bicycle: bool) -> Option<Mode> {
        let decides = matches!(self.change, Change::Destabilizes | Change::Stabilizes);
        let oscillates = match self.kind {
            CriticalKind::Weave => true,
            CriticalKind::Capsize => false,
            CriticalKind::DoubleRoot if decides && self.eigenvalue.im != 0.0 => true,
            CriticalKind::DoubleRoot => return None,
        };
        Some(match (oscillates, is_bicycle) {
            (true, true) if self.eigenvalue.im.abs() >= Self::WOBBLE => Mode::Wobble,
            (true, true) => Mode::Weave,
            (false, true) => Mode::Capsize,
            (true, false) => Mode::Flutter,
            (false, false) => Mode::Divergence,
        })
    }
}

/// What happens at a critical speed, told from the eigenvalues there and from nothing else.
///
/// [`Modes`](crate::Modes) name the eigenvalue by it: at a weave speed the pair is the mode weave, at a capsize speed the
/// eigenvalue that is zero is the mode capsize.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum CriticalKind {
    /// A conjugate pair of eigenvalues is on the imaginary axis. A real pair +-s, at which the Hurwitz determinant is zero
    /// too, is none.
    Weave,
    /// A real eigenvalue is zero.
    Capsize,
    /// Two eigenvalues coincide that do not coincide at neighbouring speeds.
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

/// What changes at a critical speed as the speed grows: of the eigenvalue or pair, not of the motion, which may be unstable
/// before and after by another one ([`Stability::verdicts_around`](crate::Stability::verdicts_around)).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Change {
    /// The eigenvalue or pair leaves the right half-plane.
    Stabilizes,
    /// The eigenvalue or pair enters the right half-plane.
    Destabilizes,
    /// Two real eigenvalues become a conjugate pair.
    Merges,
    /// A conjugate pair becomes two real eigenvalues.
    Splits,
    /// The eigenvalues are on the same side, or as many of them real, before and after.
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
