//! The equations of motion as a system of first order.

use nalgebra::{Matrix4, Matrix4x2};

use super::at_speed::{System, require_in_range};
use super::coefficients::Matrix;
use super::error::SystemError;

/// The state-space form `x' = A x + B f` with the state x = (q, q') and the generalized forces f as inputs.
///
/// A is 2N x 2N and B is 2N x N, in blocks of N x N:
///
/// ```text
/// A = [     0         I     ]    B = [   0    ]
///     [ stiffness  damping  ]        [ input  ]
/// ```
///
/// ```
/// use carvallo::{Matrix, System};
///
/// // 2 q1'' + 4 q1' + 8 q1 = f1 and q2'' + q1 = f2.
/// let system = System {
///     m: Matrix::<f64, 2>::new(2.0, 0.0, 0.0, 1.0),
///     c: Matrix::<f64, 2>::new(4.0, 0.0, 0.0, 0.0),
///     k: Matrix::<f64, 2>::new(8.0, 0.0, 1.0, 0.0),
/// };
/// let state_space = system.state_space()?;
/// assert_eq!(state_space.a().row(2).transpose().as_slice(), [-4.0, 0.0, -2.0, 0.0]);
/// assert_eq!(state_space.b().row(2).transpose().as_slice(), [0.5, 0.0]);
/// # Ok::<(), carvallo::SystemError>(())
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
        self.require_finite()?;
        let [stiffness, damping, input] = self.solve([-self.k, -self.c, Matrix::identity()])?;
        for (quantity, block) in [("M^-1 K", &stiffness), ("M^-1 C", &damping), ("M^-1", &input)] {
            require_in_range(quantity, block)?;
        }
        Ok(StateSpace { stiffness, damping, input })
    }

    /// The solutions X of `M X = B` for several B, by elimination with pivots that are the largest relative to their rows.
    ///
    /// M is singular if a pivot is no more than the rounding of the terms that were subtracted to form it, whatever the
    /// scale of its rows and columns.
    #[inline]
    pub(crate) fn solve<const COUNT: usize>(
        &self,
        mut x: [Matrix<f64, N>; COUNT],
    ) -> Result<[Matrix<f64, N>; COUNT], SystemError> {
        let mut m = self.m;
        let mut terms = m.abs();
        for step in 0..N {
            let relative = |row: usize| {
                let largest = (step..N).fold(0.0, |largest: f64, column| largest.max(m[(row, column)].abs()));
                if largest > 0.0 { m[(row, step)].abs() / largest } else { 0.0 }
            };
            let (mut pivot, mut size) = (step, relative(step));
            for row in step + 1..N {
                let candidate = relative(row);
                if candidate >= size {
                    (pivot, size) = (row, candidate);
                }
            }
            m.swap_rows(step, pivot);
            terms.swap_rows(step, pivot);
            x.iter_mut().for_each(|x| x.swap_rows(step, pivot));
            if m[(step, step)].abs() <= 8.0 * f64::EPSILON * terms[(step, step)] {
                return Err(SystemError::SingularMass);
            }
            for row in (0..N).filter(|&row| row != step) {
                let factor = m[(row, step)] / m[(step, step)];
                for column in step + 1..N {
                    let product = factor * m[(step, column)];
                    m[(row, column)] -= product;
                    terms[(row, column)] += product.abs();
                }
                for x in &mut x {
                    for column in 0..N {
                        x[(row, column)] -= factor * x[(step, column)];
                    }
                }
            }
        }
        Ok(x.map(|x| Matrix::from_fn(|row, column| x[(row, column)] / m[(row, row)])))
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
