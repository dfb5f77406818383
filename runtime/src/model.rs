//! The trait that every compiled model implements, and the errors of its parameters.

use core::fmt;

use crate::{Coefficients, Domain, Evaluator, ModelInfo, Number, Scalar};

/// A model with N coordinates: its parameters are the fields of the type.
///
/// The macro `model!` and the models compiled ahead of time implement it; nothing else needs to.
pub trait Model<const N: usize>: Copy {
    /// The number type of the parameters and of the matrices.
    type Scalar: Scalar;

    /// An array with an element for each parameter.
    type Array<U: Copy>: Copy + AsRef<[U]> + AsMut<[U]>;

    /// The same model over another kind of number.
    type Over<T: Number>: Evaluator<T, N>;

    /// Names, units, documentation and domains.
    const INFO: &'static ModelInfo;

    /// The parameters from a slice in declared order.
    ///
    /// # Errors
    /// If the slice has another length than there are parameters.
    fn from_slice(values: &[Self::Scalar]) -> Result<Self, LengthError>;

    /// Writes the parameters to a slice in declared order.
    ///
    /// # Errors
    /// If the slice has another length than there are parameters.
    fn write_to(&self, values: &mut [Self::Scalar]) -> Result<(), LengthError>;

    /// An array whose elements follow from the positions of the parameters in declared order.
    fn array<U: Copy>(element: impl FnMut(usize) -> U) -> Self::Array<U>;

    /// The parameters in declared order.
    fn parameters(&self) -> Self::Array<Self::Scalar>;

    /// Whether every parameter lies in its domain and every requirement of the declaration holds.
    ///
    /// # Errors
    /// The first parameter or requirement that fails.
    fn validate(&self) -> Result<(), ParameterError>;

    /// The coefficient matrices, each N x N; matrices that the declaration omits are zero.
    ///
    /// The parameters are not validated.
    fn coefficients(&self) -> Coefficients<Self::Scalar, N>;

    /// The gravitational field strength g in N/kg, if it is a parameter of the model.
    fn gravity(&self) -> Option<Self::Scalar>;
}

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

impl fmt::Display for LengthError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { model, expected, found } = self;
        write!(f, "{model}: {found} values given; it has {expected} parameters")
    }
}

impl core::error::Error for LengthError {}
