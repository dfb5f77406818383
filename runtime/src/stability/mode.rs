//! What modes are called.

use core::fmt;

/// A mode of the uncontrolled bicycle, or what an eigenvalue is where that has none of the names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(rename_all = "snake_case"))]
pub enum Mode {
    /// The front frame swings into line: one eigenvalue.
    Castering,
    /// Slow leaning over: one eigenvalue.
    Capsize,
    /// Oscillation of lean and steer: two eigenvalues.
    Weave,
    /// A real eigenvalue without a name.
    Real,
    /// One of a pair of eigenvalues without a name.
    Oscillatory,
}

/// Reads `castering`, `capsize`, `weave`, `real`, `oscillatory`.
impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Castering => "castering",
            Self::Capsize => "capsize",
            Self::Weave => "weave",
            Self::Real => "real",
            Self::Oscillatory => "oscillatory",
        })
    }
}
