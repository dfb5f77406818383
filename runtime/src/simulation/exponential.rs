//! What a linear system does in a step, exactly.

use nalgebra::linalg::balancing::balance_parlett_reinsch;
use nalgebra::{DMatrix, DVector};

use super::error::SimulationError;

/// Beyond this many halvings a step is too long for what moves fastest.
const MOST_HALVINGS: i32 = 64;

/// The sum of squares of larger entries leaves the range of doubles.
const LARGEST_ENTRY: f64 = 1e150;

/// The last power of the series: beyond it terms of a matrix whose norm is at most 1/2 are below rounding.
const LAST_POWER: u32 = 16;

/// The solution of `x' = A x + u` after a step, with u linear in it, for any number of states: exact, by the matrix exponential.
///
/// ```
/// use carvallo::nalgebra::{DMatrix, DVector};
/// use carvallo::simulation::Propagator;
///
/// // x' = 1 - x from 0, and what it is after half a second.
/// let half = Propagator::new(&DMatrix::from_element(1, 1, -1.0), 0.5).unwrap();
/// let x = half.advance(&DVector::zeros(1), &DVector::from_element(1, 1.0), &DVector::zeros(1));
/// assert!((x[0] - (1.0 - (-0.5_f64).exp())).abs() < 1e-16);
/// ```
#[derive(Clone, Debug)]
pub struct Propagator {
    /// The length of the step in s.
    pub(super) step: f64,
    /// exp(h A) - 1.
    from_state: DMatrix<f64>,
    /// h φ1(h A), with φ1(z) = (exp z - 1) / z: of what u is at the beginning.
    from_first: DMatrix<f64>,
    /// h φ2(h A), with φ2(z) = (φ1(z) - 1) / z: of by how much u grows in the step.
    from_growth: DMatrix<f64>,
}

/// Why there is no solution after a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PropagatorError {
    /// It leaves the range of doubles, as a motion that grows does.
    OutOfRange,
    /// The step is so many times as long as what moves fastest takes, some 1e19, that doubles do not tell what that does.
    TooLong,
}

impl PropagatorError {
    /// Of a motion that is asked for at a time in s.
    #[must_use]
    pub fn at(self, time: f64) -> SimulationError {
        match self {
            Self::OutOfRange => SimulationError::OutOfRange { time },
            Self::TooLong => SimulationError::TooLong { time },
        }
    }
}

impl Propagator {
    /// For a state matrix A and a step.
    ///
    /// All three are blocks of one exponential,
    ///
    /// ```text
    /// exp [ h A  1  0 ]   [ exp(h A)  φ1(h A)  φ2(h A) ]
    ///     [  0   0  1 ] = [     0         1        1   ]
    ///     [  0   0  0 ]   [     0         0        1   ]
    /// ```
    ///
    /// (Van Loan 1978), which asks for no eigenvector, so that double eigenvalues are as good as others, and divides by
    /// no eigenvalue, so that zero is.
    ///
    /// # Errors
    /// If it leaves the range of doubles, or if the step is too long beside what moves fastest.
    pub fn new(a: &DMatrix<f64>, step: f64) -> Result<Self, PropagatorError> {
        let states = a.nrows();
        let mut scaled = a * step;
        // Balancing squares the entries, and does not end where a square is infinite.
        if !is_finite(&scaled) || scaled.amax() > LARGEST_ENTRY {
            return Err(PropagatorError::TooLong);
        }
        // Coordinates in units that are alike, by powers of two: else the exponential errs relative to the largest entry.
        let units = balance_parlett_reinsch(&mut scaled);
        let mut blocks = DMatrix::zeros(3 * states, 3 * states);
        blocks.view_mut((0, 0), (states, states)).copy_from(&scaled);
        blocks.view_mut((0, states), (states, states)).fill_with_identity();
        blocks.view_mut((states, 2 * states), (states, states)).fill_with_identity();
        let grown = growth(blocks)?;
        let block = |place: usize, factor: f64| {
            let entry = |i, j| grown[(i, place * states + j)] * (units[i] / units[j]) * factor;
            DMatrix::from_fn(states, states, entry)
        };
        let [from_state, from_first, from_growth] = [block(0, 1.0), block(1, step), block(2, step)];
        let all_finite = [&from_state, &from_first, &from_growth].into_iter().all(is_finite);
        let propagator = Self { step, from_state, from_first, from_growth };
        if all_finite { Ok(propagator) } else { Err(PropagatorError::OutOfRange) }
    }

    /// The state after the step, with u at its beginning and by how much that grows until its end.
    pub fn advance(&self, state: &DVector<f64>, first: &DVector<f64>, growth: &DVector<f64>) -> DVector<f64> {
        state + (&self.from_state * state + &self.from_first * first + &self.from_growth * growth)
    }
}

/// exp(X) - 1, by its series for X halved until that is short, and `exp(2X) - 1 = (exp(X) - 1)^2 + 2 (exp(X) - 1)`.
///
/// Of a motion that is slow beside others, exp(X) of a small part of the step differs from 1 in its last digits alone, and
/// squaring it again and again keeps no more of it than these (`exp` of nalgebra is off by 1e-11 where the fastest motion is
/// 1e5 times as fast); of the difference itself all digits are there.
fn growth(mut x: DMatrix<f64>) -> Result<DMatrix<f64>, PropagatorError> {
    let norm = x.column_iter().map(|column| column.iter().map(|entry| entry.abs()).sum()).fold(0.0, f64::max);
    let halvings = if norm > 0.5 { (norm.log2() + 1.0).ceil() as i32 } else { 0 };
    if halvings > MOST_HALVINGS {
        return Err(PropagatorError::TooLong);
    }
    x *= 0.5_f64.powi(halvings);
    // X (1 + X/2 (1 + X/3 (…))).
    let mut sum = &x / f64::from(LAST_POWER);
    for power in (1..LAST_POWER).rev() {
        sum = (&x + &x * sum) / f64::from(power);
    }
    for _ in 0..halvings {
        sum = &sum * &sum + &sum * 2.0;
    }
    if is_finite(&sum) { Ok(sum) } else { Err(PropagatorError::OutOfRange) }
}

fn is_finite(matrix: &DMatrix<f64>) -> bool {
    matrix.iter().all(|entry| entry.is_finite())
}
