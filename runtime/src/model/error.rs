//! What can be wrong with parameters.

use core::fmt;

use super::domain::Domain;

/// A parameter outside its domain, or a requirement on several parameters that does not hold.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParameterError {
    /// The name of the model.
    pub model: &'static str,
    /// The name of the parameter, or the expression of the requirement, such as `mH + mF`.
    pub subject: &'static str,
    /// Its value.
    pub value: f64,
    /// The unit of the value; empty where it is not declared.
    pub unit: &'static str,
    /// The values that are allowed.
    pub required: Domain,
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { model, subject, value, unit, required } = self;
        write!(f, "{model}: `{subject}` is {value}")?;
        if !matches!(*unit, "" | "1") {
            write!(f, " {unit}")?;
        }
        if *required == Domain::NONZERO && value.is_finite() {
            return f.write_str("; it must not be 0");
        }
        f.write_str("; it must be ")?;
        if !value.is_finite() && *required != Domain::FINITE {
            f.write_str("finite and ")?;
        }
        write!(f, "{required}")
    }
}

impl core::error::Error for ParameterError {}

/// A slice of parameters of the wrong length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LengthError {
    /// The name of the model.
    pub model: &'static str,
    /// The number of parameters that the model has.
    pub expected: usize,
    /// The length of the slice.
    pub found: usize,
}

impl LengthError {
    /// Whether `values` has one value for each of the `expected` parameters of a model.
    ///
    /// # Errors
    /// If it has not.
    pub fn check<T>(model: &'static str, expected: usize, values: &[T]) -> Result<(), Self> {
        let found = values.len();
        if found == expected { Ok(()) } else { Err(Self { model, expected, found }) }
    }
}

impl fmt::Display for LengthError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { model, expected, found } = self;
        write!(f, "{model}: {found} values given; it has {expected} parameters")
    }
}

impl core::error::Error for LengthError {}
