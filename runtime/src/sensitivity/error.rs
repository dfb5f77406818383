//! What can keep derivatives and deviations from being had.

use core::fmt;

use crate::system::SystemError;

/// Why derivatives cannot be told, or standard deviations not be propagated.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum SensitivityError {
    /// The system itself has no answer.
    System(SystemError),
    /// Fewer numbers than there are parameters for them.
    TooFew {
        /// What they are, such as `standard deviations`.
        quantity: &'static str,
        /// How many there must be.
        expected: usize,
        /// How many there are.
        found: usize,
    },
    /// A model that was compiled without its derivatives.
    WithoutDerivatives {
        /// The name of the model's type.
        model: &'static str,
    },
    /// A standard deviation that is negative or not finite.
    NotADeviation {
        /// Its value.
        value: f64,
    },
    /// No parameters can be correlated so: the matrix of the correlations has a negative eigenvalue.
    NotCorrelations {
        /// The position of the first parameter that cannot be correlated so with those before it.
        parameter: usize,
    },
}

impl From<SystemError> for SensitivityError {
    fn from(error: SystemError) -> Self {
        Self::System(error)
    }
}

impl fmt::Display for SensitivityError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::System(error) => error.fmt(f),
            Self::TooFew { quantity, expected, found } => {
                write!(f, "{found} {quantity} are given; there must be {expected}")
            }
            Self::WithoutDerivatives { model } => {
                write!(
                    f,
                    "the model `{model}` was compiled without derivatives; add `derivatives;` to its declaration and \
                     compile it again"
                )
            }
            Self::NotADeviation { value } => {
                write!(f, "a standard deviation is {value}; it must be finite and >= 0")
            }
            Self::NotCorrelations { parameter } => {
                write!(f, "the parameter at position {parameter} cannot be correlated so with those before it")
            }
        }
    }
}

impl core::error::Error for SensitivityError {
    fn source(&self) -> Option<&(dyn core::error::Error + 'static)> {
        match self {
            Self::System(error) => Some(error),
            _ => None,
        }
    }
}
