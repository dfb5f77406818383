//! Operations by kinds.

use std::fmt;
use std::ops::{Add, AddAssign};

use serde::Serialize;

/// How many operations on numbers a function does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Operations {
    /// Additions and subtractions.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Changes of sign.
    pub negations: usize,
    /// Square roots.
    pub roots: usize,
    /// Sines, cosines and tangents.
    pub trigonometric: usize,
}

impl Operations {
    /// None.
    pub const NONE: Self =
        Self { additions: 0, multiplications: 0, divisions: 0, negations: 0, roots: 0, trigonometric: 0 };

    /// All of them.
    #[must_use]
    pub fn total(self) -> usize {
        self.kinds().iter().sum()
    }

    /// Those of each kind, in the order of the fields.
    #[must_use]
    pub fn kinds(self) -> [usize; 6] {
        let Self { additions, multiplications, divisions, negations, roots, trigonometric } = self;
        [additions, multiplications, divisions, negations, roots, trigonometric]
    }
}

impl Add for Operations {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self {
            additions: self.additions + other.additions,
            multiplications: self.multiplications + other.multiplications,
            divisions: self.divisions + other.divisions,
            negations: self.negations + other.negations,
            roots: self.roots + other.roots,
            trigonometric: self.trigonometric + other.trigonometric,
        }
    }
}

impl AddAssign for Operations {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

/// The kinds and the total as columns.
impl fmt::Display for Operations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.kinds().iter().try_for_each(|count| write!(f, "{count}\t"))?;
        write!(f, "{}", self.total())
    }
}
