//! The trait of models that were compiled with their derivatives.

use crate::{Coefficients, Model, Scalar};

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

/// Which derivative it is: that of one entry of a matrix with respect to one parameter.
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
}

/// One of the coefficient matrices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MatrixName {
    /// Mass matrix M.
    M,
    /// Damping C0.
    C0,
    /// Damping C1, a coefficient of v.
    C1,
    /// Stiffness Kc.
    Kc,
    /// Stiffness K0, a coefficient of g.
    K0,
    /// Stiffness K2, a coefficient of v^2.
    K2,
}

impl Partial {
    /// The derivative of the entry in a row and a column with respect to the parameter at a position.
    pub const fn new(matrix: MatrixName, row: usize, column: usize, parameter: usize) -> Self {
        Self { matrix, row, column, parameter }
    }

    /// Writes its value to where it belongs among the derivatives with respect to each parameter.
    ///
    /// # Panics
    /// If there is no such parameter, row or column.
    pub fn write<T: Scalar, const N: usize>(&self, value: T, derivatives: &mut [Coefficients<T, N>]) {
        let coefficients = &mut derivatives[self.parameter];
        let matrix = match self.matrix {
            MatrixName::M => &mut coefficients.m,
            MatrixName::C0 => &mut coefficients.c0,
            MatrixName::C1 => &mut coefficients.c1,
            MatrixName::Kc => &mut coefficients.kc,
            MatrixName::K0 => &mut coefficients.k0,
            MatrixName::K2 => &mut coefficients.k2,
        };
        matrix[(self.row, self.column)] = value;
    }
}
