//! The trait of models that were compiled with their derivatives.

use core::sync::atomic::{Ordering, compiler_fence};

use super::traits::{Evaluator, Model};
use crate::number::{Number, Scalar};
use crate::system::{Coefficients, MatrixName};

/// A model whose declaration says `derivatives;`: the exact derivatives of its matrices with respect to its parameters.
///
/// They are derived symbolically and computed together with the matrices, which share most of the arithmetic. The
/// inherent method `matrices_and_derivatives` of such a model gives only those that are not identically zero, without
/// filling in all the others.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a model with {N} coordinates that was compiled with its derivatives",
    label = "a model without derivatives",
    note = "add `derivatives;` to its declaration, by itself: all of them are needed"
)]
pub trait Differentiable<const N: usize>: Model<N> {
    /// An array with one item for each parameter, in declared order.
    type Derivatives: AsRef<[Coefficients<Self::Scalar, N>]>;

    /// The same model over another kind of number.
    type WithDerivativesOver<T: Number>: EvaluatorWithDerivatives<T, N>;

    /// Those derivatives that are not identically zero, by parameters.
    const PARTIALS: &'static [Partial];

    /// The coefficient matrices, and for each parameter, in declared order, the partial derivatives of all their entries
    /// with respect to it, each in the unit of the entry divided by that of the parameter.
    ///
    /// The parameters are not validated; at valid ones every derivative exists.
    fn coefficients_and_derivatives(&self) -> (Coefficients<Self::Scalar, N>, Self::Derivatives);
}

/// The parameters of a model over one kind of number, and the program that makes its matrices and their derivatives of them.
///
/// The macro `model!` implements it beside [`Differentiable`], for all kinds of numbers at once.
pub trait EvaluatorWithDerivatives<T: Number, const N: usize>: Evaluator<T, N> {
    /// Gives each of the entries that differ, in the order of [`ModelInfo::entries`](crate::ModelInfo::entries), and each
    /// value of their derivatives to a function, with its position, as soon as it is computed: [`Differentiable::PARTIALS`]
    /// says which derivative has which value.
    fn each_result(&self, put_entry: impl FnMut(usize, T), put_derivative: impl FnMut(usize, T));
}

/// What was computed so far is written where it belongs before anything else is computed.
///
/// Compilers put off what is written to the end of a program, and keep hundreds of results outside of registers until then.
#[doc(hidden)]
#[inline(always)]
pub fn write_now() {
    compiler_fence(Ordering::SeqCst);
}

/// One derivative: that of an entry of a matrix with respect to a parameter.
///
/// Many derivatives of a model are equal or opposite to each other, so its program computes and stores each value once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Partial {
    /// The matrix.
    pub matrix: MatrixName,
    /// The row of the entry, from 0.
    pub row: usize,
    /// The column of the entry, from 0.
    pub column: usize,
    /// The position of the parameter in declared order, from 0.
    pub parameter: usize,
    /// The position of its value among those that the program computes.
    pub value: usize,
    /// Whether it is the negative of that value.
    pub negative: bool,
}

impl Partial {
    /// The derivative of the entry in a row and a column with respect to the parameter at a position, whose value stands
    /// at another position.
    pub const fn new(matrix: MatrixName, row: usize, column: usize, parameter: usize, value: usize) -> Self {
        Self { matrix, row, column, parameter, value, negative: false }
    }

    /// The same, but the negative of the value.
    pub const fn negative(self) -> Self {
        Self { negative: true, ..self }
    }

    /// What it is among the values that the program computes.
    ///
    /// # Panics
    /// If they are fewer than those of the model.
    #[inline]
    pub fn of<T: Number>(&self, values: &[T]) -> T {
        let value = values[self.value];
        if self.negative { -value } else { value }
    }

    /// Writes it to where it belongs among the derivatives with respect to each parameter.
    ///
    /// # Panics
    /// If there is no such parameter, row or column.
    #[inline]
    pub fn write<T: Scalar, const N: usize>(&self, values: &[T], derivatives: &mut [Coefficients<T, N>]) {
        let matrix = derivatives[self.parameter].matrix_mut(self.matrix);
        matrix[(self.row, self.column)] = self.of(values);
    }
}
