//! Where motions end before their time.

/// A range that a position is to stay in: a motion ends where the position leaves it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// The position, by its place in [`MotionInfo::positions`](crate::motion::MotionInfo::positions).
    pub position: usize,
    /// What it comes to be below, in its unit.
    pub low: f64,
    /// What it comes to be above.
    pub high: f64,
}

impl Limit {
    /// As much to both sides of zero.
    #[must_use]
    pub fn symmetric(position: usize, most: f64) -> Self {
        Self { position, low: -most, high: most }
    }

    /// Whether a value is out of it; what is no number is not.
    pub(super) fn excludes(&self, value: f64) -> bool {
        value < self.low || value > self.high
    }
}
