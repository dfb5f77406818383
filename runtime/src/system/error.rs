//! What can keep a system from having an answer.

use core::fmt;

/// Why a system, its eigenvalues or its stability cannot be computed.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SystemError {
    /// An argument or a matrix entry is infinite or not a number.
    NotFinite {
        /// What it is, such as `speed` or `C1`.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// A speed below zero where the analysis runs over the speeds from zero.
    NegativeSpeed {
        /// The speed in m/s.
        speed: f64,
    },
    /// The speed is zero where damping is divided by it: there is a C-1.
    AtRest,
    /// There is a C-1 or a K1, or a coordinate of which only the position or the rate is a state: modes are not followed, and
    /// [certain](crate::CertainStability) critical speeds not found.
    OddPowers,
    /// The mass matrix M cannot be inverted: its determinant is zero as far as its entries can tell.
    SingularMass,
    /// The critical speeds are not [certain](crate::CertainStability) in `f64`.
    NotCertain,
    /// The numbers differ so much in size that an intermediate result leaves the range of its type, `f64` or
    /// `f32`.
    OutOfRange {
        /// The result that left the range, such as `C-1/v + C0 + v C1`.
        quantity: &'static str,
    },
    /// The eigenvalue iteration did not converge within its bound.
    NotConverged {
        /// The bound.
        iterations: usize,
    },
}

impl fmt::Display for SystemError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { quantity, value } => write!(f, "{quantity} is {value}; it must be finite"),
            Self::NegativeSpeed { speed } => write!(f, "the speed is {speed} m/s; it must be >= 0"),
            Self::AtRest => {
                f.write_str("the speed is 0 m/s, and the damping C-1/v has no value there; it must not be 0")
            }
            Self::OddPowers => {
                f.write_str(
                "with C-1, K1 or coordinates that are not of second order modes are not followed, and critical speeds not certain",
            )
            }
            Self::SingularMass => f.write_str("the mass matrix M is singular; it must be invertible"),
            Self::NotCertain => f.write_str("the critical speeds are not certain in f64; they need feature `std`"),
            Self::OutOfRange { quantity } => write!(f, "{quantity} leaves the range of floating-point numbers"),
            Self::NotConverged { iterations } => {
                write!(f, "the eigenvalues did not converge within {iterations} iterations")
            }
        }
    }
}

impl core::error::Error for SystemError {}
