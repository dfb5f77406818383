//! The equations of motion as a system of first order.

use nalgebra::{Matrix4, Matrix4x2};

use crate::{Matrix, System, SystemError};

/// The state-space form `x' = A x + B f` with the state x = (q, q') and the generalized forces f as inputs.
///
/// A is 2N x 2N and B is 2N x N, in blocks of N x N:
///
/// ```text
/// A = [     0         I     ]    B = [   0    ]
///     [ stiffness  damping  ]        [ input  ]
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateSpace<const N: usize> {
    /// The block -M^-1 K of A.
    pub stiffness: Matrix<f64, N>,
    /// The block -M^-1 C of A.
    pub damping: Matrix<f64, N>,
    /// The block M^-1 of B.
    pub input: Matrix<f64, N>,
}

impl<const N: usize> System<N> {
    /// The state-space form.
    ///
    /// # Errors
    /// If the mass matrix is singular, an entry is not finite, or a block leaves the range of `f64`.
    pub fn state_space(&self) -> Result<StateSpace<N>, SystemError> {
        todo!()
    }
}

impl StateSpace<2> {
    /// The state matrix A.
    pub fn a(&self) -> Matrix4<f64> {
        let mut a = Matrix4::zeros();
        a.fixed_view_mut::<2, 2>(0, 2).fill_with_identity();
        a.fixed_view_mut::<2, 2>(2, 0).copy_from(&self.stiffness);
        a.fixed_view_mut::<2, 2>(2, 2).copy_from(&self.damping);
        a
    }

    /// The input matrix B.
    pub fn b(&self) -> Matrix4x2<f64> {
        let mut b = Matrix4x2::zeros();
        b.fixed_view_mut::<2, 2>(2, 0).copy_from(&self.input);
        b
    }
}
