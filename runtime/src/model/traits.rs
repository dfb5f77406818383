//! What every compiled model implements.

use super::error::{LengthError, ParameterError};
use super::info::ModelInfo;
use crate::motion::{Motion, NoMotion};
use crate::number::{Number, Scalar};
use crate::system::Coefficients;

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

    /// The parameter set called `name`, each value rounded to the nearest. Upper and lower case, `_`, `-` and spaces make
    /// no difference, as [`ModelInfo::set`] has it.
    #[must_use]
    fn set(name: &str) -> Option<Self> {
        let values = ModelInfo::set(Self::INFO, name)?.values;
        Self::from_slice(Self::array(|position| Self::Scalar::from_f64(values[position])).as_ref()).ok()
    }

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

    /// The coefficient matrices, and their derivatives with respect to each parameter in declared order, as
    /// [`Differentiable`](crate::Differentiable) has them; nothing for a model whose declaration does not say
    /// `derivatives;`.
    ///
    /// For code that takes any model. What needs derivatives takes a [`Differentiable`](crate::Differentiable) one.
    fn derivatives(&self) -> Option<WithDerivatives<Self, N>> {
        None
    }

    /// The nonlinear equations of motion with these parameters, as [`Nonlinear`](crate::Nonlinear) has them; nothing for a
    /// model whose declaration does not say `nonlinear;`.
    ///
    /// For code that takes any model. What needs them takes a [`Nonlinear`](crate::Nonlinear) one.
    fn nonlinear(&self) -> Option<impl Motion<Scalar = Self::Scalar>> {
        None::<NoMotion<Self::Scalar>>
    }

    /// The generalized forces on the coordinates that a force of one of its mechanism makes, by its place among
    /// [`ModelInfo::forces`](crate::ModelInfo::forces), to first order: of a motor on a wheel those by which it drives the machine.
    /// Nothing if there is no such force.
    fn shares(&self, _force: usize) -> Option<[Self::Scalar; N]> {
        None
    }

    /// The gravitational field strength g in N/kg, if it is a parameter of the model.
    fn gravity(&self) -> Option<Self::Scalar>;
}

/// The coefficient matrices of a model, and those derived with respect to each of its parameters.
pub type WithDerivatives<M, const N: usize> =
    (Coefficients<<M as Model<N>>::Scalar, N>, <M as Model<N>>::Array<Coefficients<<M as Model<N>>::Scalar, N>>);

/// The parameters of a model over one kind of number, and the program that makes its matrices of them.
///
/// The macro `model!` implements it beside [`Model`], for all kinds of numbers at once; functions over many
/// designs run it in lanes.
pub trait Evaluator<T: Number, const N: usize>: Copy {
    /// An array of T.
    type Entries: Copy + AsRef<[T]>;

    /// The parameters, each by its position in declared order.
    fn from_parameters(parameter: impl FnMut(usize) -> T) -> Self;

    /// The entries of the matrices that differ, in the order of [`ModelInfo::entries`](crate::ModelInfo::entries).
    fn entries(&self) -> Self::Entries;

    /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
    fn rows(&self) -> [[[T; N]; N]; 8];
}
