//! The names of the matrices of the equation of motion, which all stages use.

use nanoserde::{DeBin, SerBin};

/// A coefficient matrix of the equation of motion `M q'' + (C0 + v C1) q' + (Kc + g K0 + v^2 K2) q = f`, with the
/// forward speed v and the gravitational field strength g.
#[derive(Clone, Copy, Debug, DeBin, PartialEq, Eq, PartialOrd, Ord, Hash, SerBin)]
pub enum MatrixName {
    M,
    C0,
    C1,
    Kc,
    K0,
    K2,
}

impl MatrixName {
    /// All of them, in the order of the equation of motion.
    pub const ALL: [Self; 6] = [Self::M, Self::C0, Self::C1, Self::Kc, Self::K0, Self::K2];

    /// As it is written in a declaration.
    pub fn name(self) -> &'static str {
        match self {
            Self::M => "M",
            Self::C0 => "C0",
            Self::C1 => "C1",
            Self::Kc => "Kc",
            Self::K0 => "K0",
            Self::K2 => "K2",
        }
    }

    /// The matrix called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|matrix| matrix.name() == name)
    }
}
