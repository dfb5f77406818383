//! Ranges of speed.

/// An open range of speeds in which every eigenvalue has a negative real part.
///
/// The ends do not belong to it, with one exception: a range from zero contains zero if the motion is stable at rest,
/// which [`Stability::verdict`](crate::Stability::verdict) tells.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct StableRange {
    /// The lower end in m/s.
    pub from: f64,
    /// The upper end in m/s; `None` if the range has no end.
    pub to: Option<f64>,
}

/// A range of speeds in which no motion grows and some do not die away, as those of a rolling disc above its critical
/// speed.
///
/// [`Stability::verdict`](crate::Stability::verdict) tells what holds at its ends.
#[cfg(feature = "std")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct MarginalRange {
    /// The lower end in m/s.
    pub from: f64,
    /// The upper end in m/s; `None` if the range has no end.
    pub to: Option<f64>,
}

/// An open range of speeds in which something is missing: as many eigenvalues are unstable at its ends as the critical
/// speeds in it do not explain, and what they do between them is within rounding of the imaginary axis.
#[cfg(feature = "std")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize), serde(deny_unknown_fields))]
pub struct UndecidedRange {
    /// The lower end in m/s.
    pub from: f64,
    /// The upper end in m/s.
    pub to: f64,
}
