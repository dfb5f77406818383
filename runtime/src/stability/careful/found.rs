//! What the search for critical speeds finds.

use crate::number::real::Real;
use crate::numeric::{DoubleDouble, NOISE};
use crate::stability::critical::CriticalSpeed;
use crate::stability::verdict::Verdict;

/// A critical speed and what the search knows beyond it.
#[derive(Clone, Copy, Debug)]
pub(super) struct FoundSpeed {
    pub(super) critical: CriticalSpeed,
    /// The scaled speed.
    pub(super) at: DoubleDouble,
    /// The verdict at that very speed; `None` where no eigenvalue is on the imaginary axis by construction.
    pub(super) there: Option<Verdict>,
    /// Whether the change is still to be read from both sides.
    pub(super) undecided: bool,
}

/// Whether two speeds are the same to the precision of the search.
pub(super) fn is_same(x: DoubleDouble, y: DoubleDouble) -> bool {
    (x - y).abs() <= y.abs() * NOISE.into()
}
