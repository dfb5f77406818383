//! Stability along speed.

#[cfg(feature = "std")]
mod along_speed;
#[cfg(feature = "std")]
mod at_any_speed;
#[cfg(feature = "std")]
mod branches;
#[cfg(feature = "std")]
mod careful;
mod certain;
#[cfg(feature = "serde")]
mod complex;
mod critical;
pub(crate) mod fast;
#[cfg(feature = "std")]
mod general;
mod mode;
#[cfg(feature = "std")]
mod modes;
#[cfg(feature = "std")]
mod naming;
#[cfg(feature = "std")]
mod parameter;
mod ranges;
#[cfg(feature = "std")]
mod stretches;
mod verdict;
mod verdicts;

#[cfg(feature = "std")]
pub use at_any_speed::Stability;
#[cfg(feature = "std")]
pub use branches::{Branches, Meeting};
pub use certain::CertainStability;
pub use critical::{Change, CriticalKind, CriticalSpeed};
pub use mode::Mode;
#[cfg(feature = "std")]
pub use modes::{ModeValue, Modes};
#[cfg(feature = "std")]
pub use parameter::{CriticalValue, ParameterRange, ParameterStability, ParameterStabilityError};
pub use ranges::StableRange;
#[cfg(feature = "std")]
pub use ranges::{MarginalRange, UndecidedRange};
pub use verdict::Verdict;
