//! The equations of motion as a system of first order.

use nalgebra::{Matrix4, Matrix4x2};

use super::at_speed::{System, require_in_range};
use super::coefficients::Matrix;
use super::elimination::solve_in_place;
use super::error::SystemError;
use super::states::States;
use crate::number::Scalar;

/// The state-space form `x' = A x + B f` with the state x = (q, q') and the generalized forces f as inputs.
///
/// Where of a coordinate only the position or only the rate is a [state](States), the row and the column of the other one are
/// zero; of one of first order the row of its position is that of its rate in the blocks below.
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
/// let system = System::new(
///     Matrix::<f64, 2>::new(2.0, 0.0, 0.0, 1.0),
///     Matrix::<f64, 2>::new(4.0, 0.0, 0.0, 0.0),
///     Matrix::<f64, 2>::new(8.0, 0.0, 1.0, 0.0),
/// );
/// let state_space = system.state_space()?;
/// assert_eq!(state_space.a().row(2).transpose().as_slice(), [-4.0, 0.0, -2.0, 0.0]);
/// assert_eq!(state_space.b().row(2).transpose().as_slice(), [0.5, 0.0]);
/// # Ok::<(), carvallo::SystemError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateSpace<const N: usize, T: Scalar = f64> {
    /// The block -M^-1 K of A.
    pub stiffness: Matrix<T, N>,
    /// The block -M^-1 C of A.
    pub damping: Matrix<T, N>,
    /// The block M^-1 of B.
    pub input: Matrix<T, N>,
    /// Which of the position and the rate of each coordinate are states.
    pub states: [States; N],
}

impl<const N: usize, T: Scalar> System<N, T> {
    /// The state-space form.
    ///
    /// # Errors
    /// If the mass matrix is singular as far as `T` can tell, an entry is not finite, or a block leaves the range of `T`.
    pub fn state_space(&self) -> Result<StateSpace<N, T>, SystemError> {
        // On a microcontroller it takes longer to be ready to say which entry it is than to look at all of them.
        if !self.is_finite() {
            self.require_finite()?;
        }
        // What is solved is solved in the place of the result: on a microcontroller copies take longer than operations.
        let mut space = StateSpace {
            stiffness: self.k.map(|entry| -entry),
            damping: self.c.map(|entry| -entry),
            input: identity(),
            states: self.states,
        };
        space.clear_columns_of_no_state();
        self.solve_in_place(&mut space)?;
        require_in_range("M^-1 K", &space.stiffness)?;
        require_in_range("M^-1 C", &space.damping)?;
        require_in_range("M^-1", &space.input)?;
        Ok(space)
    }

    /// The [solutions](solve_in_place) X of `M X = B` for all blocks, with columns of C in the place of those of M for
    /// coordinates of first order.
    fn solve_in_place(&self, space: &mut StateSpace<N, T>) -> Result<(), SystemError> {
        let (mut m, mut terms) = (self.leading(), self.m);
        let at = |row: usize, column: usize| row + N * column;
        let StateSpace { stiffness, damping, input, states: _ } = space;
        let mut blocks = [stiffness, damping, input].map(|block| block.as_mut_slice());
        solve_in_place(N, at, [m.as_mut_slice(), terms.as_mut_slice()], &mut blocks)
    }
}

impl<const N: usize, T: Scalar> StateSpace<N, T> {
    fn clear_columns_of_no_state(&mut self) {
        for (column, states) in self.states.iter().enumerate() {
            match states {
                States::Both => {}
                States::Position => self.damping.column_mut(column).fill(T::from_f64(0.0)),
                States::Rate => self.stiffness.column_mut(column).fill(T::from_f64(0.0)),
            }
        }
    }
}

impl<T: Scalar> StateSpace<2, T> {
    /// The state matrix A.
    pub fn a(&self) -> Matrix4<T> {
        Matrix4::from_fn(|row, column| {
            let solved = |row: usize| match column {
                0 | 1 => self.stiffness[(row, column)],
                _ => self.damping[(row, column - 2)],
            };
            match (self.states[row % 2], row) {
                (States::Position, 0 | 1) | (States::Rate | States::Both, 2 | 3) => solved(row % 2),
                (States::Both, _) => if_equal(row + 2, column),
                (States::Position | States::Rate, _) => T::from_f64(0.0),
            }
        })
    }

    /// The input matrix B.
    pub fn b(&self) -> Matrix4x2<T> {
        Matrix4x2::from_fn(|row, column| match (self.states[row % 2], row) {
            (States::Position, 0 | 1) | (States::Rate | States::Both, 2 | 3) => self.input[(row % 2, column)],
            _ => T::from_f64(0.0),
        })
    }
}

/// The same numbers, exactly.
impl<const N: usize> From<StateSpace<N, f32>> for StateSpace<N> {
    fn from(StateSpace { stiffness, damping, input, states }: StateSpace<N, f32>) -> Self {
        let [stiffness, damping, input] = [stiffness, damping, input].map(|block| block.map(f64::from));
        Self { stiffness, damping, input, states }
    }
}

fn identity<T: Scalar, const N: usize>() -> Matrix<T, N> {
    Matrix::from_fn(if_equal)
}

/// An entry of the identity matrix.
fn if_equal<T: Scalar>(row: usize, column: usize) -> T {
    T::from_f64(if row == column { 1.0 } else { 0.0 })
}
