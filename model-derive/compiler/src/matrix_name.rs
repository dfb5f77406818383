//! The names of the matrices of the equation of motion, and of their sums, which all stages use.

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

/// What multiplies q' or q as a whole: a matrix with the speed and gravity in it, in whose powers the coefficient matrices
/// are its coefficients.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Whole {
    Damping,
    Stiffness,
}

impl Whole {
    /// As it is written in a declaration.
    pub fn name(self) -> &'static str {
        match self {
            Self::Damping => "C",
            Self::Stiffness => "K",
        }
    }

    /// The whole called `name`.
    pub fn from_name(name: &str) -> Option<Self> {
        [Self::Damping, Self::Stiffness].into_iter().find(|whole| whole.name() == name)
    }

    /// The coefficient matrices that it is the sum of.
    pub fn parts(self) -> &'static [MatrixName] {
        match self {
            Self::Damping => &[MatrixName::Cm1, MatrixName::C0, MatrixName::C1],
            Self::Stiffness => &[MatrixName::Kc, MatrixName::K0, MatrixName::K1, MatrixName::K2],
        }
    }

    /// The part that neither the speed nor gravity multiplies: in its unit is the whole.
    pub fn plain(self) -> MatrixName {
        match self {
            Self::Damping => MatrixName::C0,
            Self::Stiffness => MatrixName::Kc,
        }
    }

    /// The part that a power of the speed multiplies.
    pub fn part(self, power: i64) -> Option<MatrixName> {
        match (self, power) {
            (Self::Damping, -1) => Some(MatrixName::Cm1),
            (Self::Damping, 1) => Some(MatrixName::C1),
            (Self::Stiffness, 1) => Some(MatrixName::K1),
            (Self::Stiffness, 2) => Some(MatrixName::K2),
            (_, 0) => Some(self.plain()),
            _ => None,
        }
    }
}
