//! The values that a parameter, or a formula in several, may have.

use crate::report::number;

/// Finite values between two bounds, with or without zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// The lower end.
    pub lower: Bound,
    /// The upper end.
    pub upper: Bound,
    /// Whether zero is left out.
    pub nonzero: bool,
}

/// One end of a domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// Any finite value.
    Unbounded,
    /// Without the bound itself.
    Open(f64),
    /// With the bound itself.
    Closed(f64),
}

impl Domain {
    /// Any finite value but zero.
    pub const NONZERO: Self = Self { lower: Bound::Unbounded, upper: Bound::Unbounded, nonzero: true };
    /// What radii are.
    pub const POSITIVE: Self = Self { lower: Bound::Open(0.0), upper: Bound::Unbounded, nonzero: false };
    /// What a square root takes, and masses are.
    pub const NONNEGATIVE: Self = Self { lower: Bound::Closed(0.0), upper: Bound::Unbounded, nonzero: false };

    /// Whether zero is not inside.
    pub fn excludes_zero(&self) -> bool {
        !self.contains(0.0)
    }

    /// Whether `value` is finite and inside.
    pub fn contains(&self, value: f64) -> bool {
        let above = match self.lower {
            Bound::Unbounded => true,
            Bound::Open(bound) => value > bound,
            Bound::Closed(bound) => value >= bound,
        };
        let below = match self.upper {
            Bound::Unbounded => true,
            Bound::Open(bound) => value < bound,
            Bound::Closed(bound) => value <= bound,
        };
        value.is_finite() && above && below && !(self.nonzero && value == 0.0)
    }
}

/// Reads as the end of a sentence "expected …".
impl std::fmt::Display for Domain {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let lower = match self.lower {
            Bound::Unbounded => None,
            Bound::Open(bound) => Some(format!("> {}", number(bound))),
            Bound::Closed(bound) => Some(format!(">= {}", number(bound))),
        };
        let upper = match self.upper {
            Bound::Unbounded => None,
            Bound::Open(bound) => Some(format!("< {}", number(bound))),
            Bound::Closed(bound) => Some(format!("<= {}", number(bound))),
        };
        match (lower, upper) {
            (None, None) if self.nonzero => return f.write_str("not 0"),
            (None, None) => return f.write_str("any finite value"),
            (Some(one), None) | (None, Some(one)) => f.write_str(&one)?,
            (Some(low), Some(high)) => write!(f, "{low} and {high}")?,
        }
        if self.nonzero { f.write_str(" and not 0") } else { Ok(()) }
    }
}
