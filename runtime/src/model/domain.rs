//! The values that a parameter may take.

use core::fmt;

/// One end of a [`Domain`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// No bound: any finite value.
    Unbounded,
    /// The bound itself is not allowed.
    Open(f64),
    /// The bound itself is allowed.
    Closed(f64),
}

/// The values that a parameter may take: finite, between two bounds, and where it says so not zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// The lower end.
    pub lower: Bound,
    /// The upper end.
    pub upper: Bound,
    /// Whether zero is left out.
    pub nonzero: bool,
}

impl Domain {
    /// Any finite value.
    pub const FINITE: Self = Self { lower: Bound::Unbounded, upper: Bound::Unbounded, nonzero: false };
    /// Any finite value but zero.
    pub const NONZERO: Self = Self::FINITE.without_zero();
    /// Greater than zero.
    pub const POSITIVE: Self = Self::between(Bound::Open(0.0), Bound::Unbounded);
    /// Zero and what is greater.
    pub const NONNEGATIVE: Self = Self::between(Bound::Closed(0.0), Bound::Unbounded);

    /// Between two bounds.
    pub const fn between(lower: Bound, upper: Bound) -> Self {
        Self { lower, upper, nonzero: false }
    }

    /// The same without zero.
    pub const fn without_zero(self) -> Self {
        Self { nonzero: true, ..self }
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

/// Reads as the end of a sentence "it must be …": `finite`, `> 0`, `> -1.5 and < 1.5`, `not 0`, `< 1 and not 0`.
impl fmt::Display for Domain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lower = match self.lower {
            Bound::Unbounded => None,
            Bound::Open(bound) => Some((">", bound)),
            Bound::Closed(bound) => Some((">=", bound)),
        };
        let upper = match self.upper {
            Bound::Unbounded => None,
            Bound::Open(bound) => Some(("<", bound)),
            Bound::Closed(bound) => Some(("<=", bound)),
        };
        match (lower, upper) {
            (None, None) if self.nonzero => return f.write_str("not 0"),
            (None, None) => return f.write_str("finite"),
            (Some((sign, bound)), None) | (None, Some((sign, bound))) => write!(f, "{sign} {bound}")?,
            (Some((low, a)), Some((high, b))) => write!(f, "{low} {a} and {high} {b}")?,
        }
        if self.nonzero { f.write_str(" and not 0") } else { Ok(()) }
    }
}
