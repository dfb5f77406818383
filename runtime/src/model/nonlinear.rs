//! Models with nonlinear equations of motion.

use super::traits::Model;
use crate::motion::{Motion, Unchecked};
use crate::number::Number;

/// A model whose declaration says `nonlinear;`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model with {N} coordinates that was compiled with its nonlinear equations",
    label = "a model without nonlinear equations",
    note = "add `nonlinear;` to its declaration, which needs a `mechanism`"
)]
pub trait Nonlinear<const N: usize>: Model<N> {
    /// The mechanism with its parameters.
    type Motion: Motion<Scalar = Self::Scalar>;

    /// The same over another kind of number.
    type MotionOver<T: Number>: Unchecked<Scalar = T>;

    /// The mechanism with these parameters, which are not validated: all that does not depend on its state is computed
    /// here, once.
    #[must_use]
    fn motion(&self) -> Self::Motion;

    /// The same over another kind of number.
    #[must_use]
    fn motion_over<T: Number>(model: &Self::Over<T>) -> Self::MotionOver<T>;
}
