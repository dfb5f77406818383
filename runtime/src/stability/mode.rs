//! What modes are called.

use core::fmt;

/// A mode of a bicycle, a motorcycle or any other machine, or what an eigenvalue is where that has none of the names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Mode {
    /// The front frame swings into line: one eigenvalue.
    Castering,
    /// Slow leaning over: one eigenvalue.
    Capsize,
    /// Oscillation of lean and steer: two eigenvalues.
    Weave,
    /// Fast oscillation of the front frame, of a machine that leans and steers.
    Wobble,
    /// What grows or dies away without oscillating, of any other machine: one eigenvalue.
    Divergence,
    /// An oscillation that takes its energy from the motion or the flow, of any other machine: two eigenvalues.
    Flutter,
    /// A real eigenvalue without a name.
    Real,
    /// One of a pair of eigenvalues without a name.
    Oscillatory,
}

/// Reads `castering`, `capsize`, `weave`, `wobble`, `divergence`, `flutter`, `real`, `oscillatory`.
impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Castering => "castering",
            Self::Capsize => "capsize",
            Self::Weave => "weave",
            Self::Wobble => "wobble",
            Self::Divergence => "divergence",
            Self::Flutter => "flutter",
            Self::Real => "real",
            Self::Oscillatory => "oscillatory",
        })
    }
}
