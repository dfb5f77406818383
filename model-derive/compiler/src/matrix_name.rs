//! The names of the matrices of the equation of motion, which all stages use.

use nanoserde::{DeBin, SerBin};

/// A coefficient matrix of the equation of motion
/// `M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f`, with the forward speed v and the gravitational
/// field strength g.
#[derive(Clone, Copy, Debug, DeBin, PartialEq, Eq, PartialOrd, Ord, Hash, SerBin)]
pub enum MatrixName {
    M,
    Cm1,
    C0,
    C1,
    Kc,
    K0,
    K1,
    K2,
}

impl MatrixName {
    /// All of them, in the order of the equation of motion.
    pub const ALL: [Self; 8] = [Self::M, Self::Cm1, Self::C0, Self::C1, Self::Kc, Self::K0, Self::K1, Self::K2];

    /// As it is written in a declaration.
    pub fn name(self) -> &'static str {
        match self {
            Self::M => "M",
            Self::Cm1 => "C-1",
            Self::C0 => "C0",
            Self::C1 => "C1",
            Self::Kc => "Kc",
            Self::K0 => "K0",
            Self::K1 => "K1",
            Self::K2 => "K2",
        }
    }

    /// As it is called in Rust.
    pub fn identifier(self) -> &'static str {
        match self {
            Self::Cm1 => "Cm1",
            other => other.name(),
        }
    }

    /// The matrix called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|matrix| matrix.name() == name)
    }
}
