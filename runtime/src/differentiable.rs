//! The trait of models that were compiled with their derivatives.

use crate::{Coefficients, Model};

/// A model whose declaration says `derivatives;`: the exact derivatives of its matrices with respect to its parameters.
///
/// They are derived symbolically and computed together with the matrices, which share most of the arithmetic. The
/// inherent method `matrices_and_derivatives` of such a model gives only those that are not identically zero, without
/// filling in all the others.
pub trait Differentiable<const N: usize>: Model<N> {
    /// An array with one item for each parameter, in declared order.
    type Derivatives: AsRef<[Coefficients<Self::Scalar, N>]>;

    /// The coefficient matrices, and for each parameter, in declared order, the partial derivatives of all their entries
    /// with respect to it, each in the unit of the entry divided by that of the parameter.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    fn coefficients_and_derivatives(&self) -> (Coefficients<Self::Scalar, N>, Self::Derivatives);
}
