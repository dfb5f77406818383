//! Zeros and gain of a single-input, single-output state space.

use carvallo::{Complex, SystemError, matrix_eigenvalues};
use nalgebra::{DMatrix, DVector};

use crate::balance::{Balanced, Channel};

/// What is smaller than this beside what it was computed from is its rounding.
const ROUNDING: f64 = 1e-13;

/// The zeros of `d + c (s - A)^-1 b` in 1/s, sorted by real part, then by imaginary part, and the number k with which it is
/// `k Π (s - zero) / Π (s - eigenvalue of A)`. Where the output does not depend on the input, k is zero and there are none.
///
/// The zeros are the numbers at which the pencil of Rosenbrock is singular,
///
/// ```text
/// [ A - s  b ]
/// [   c    d ]
/// ```
///
/// which is deflated of its infinite eigenvalues by reflections (Emami-Naeini & Van Dooren 1982, for one input and one output):
/// while d is zero, the states are turned such that c reaches the last one alone. That one is then as good as an output that is
/// zero, so its row takes the place of c and d, and it is a state no longer. A d that is not zero leaves the eigenvalues of
/// `A - b c / d`. A state that is taken out lowers the degree of the numerator by one, and k is the product of what c was and d.
///
/// # Errors
/// If the iteration for eigenvalues does not converge, or one leaves the range of `f64`.
pub fn zeros(channel: Channel) -> Result<(Vec<Complex<f64>>, f64), SystemError> {
    let Balanced { channel: Channel { mut a, b, c, mut d }, power } = channel.balanced();
    let (mut b, mut c) = (b.column(0).into_owned(), c.row(0).transpose());
    let mut gain = 2_f64.powi(power);
    let [of_input, of_states] = [b.amax(), a.amax()].map(|largest| ROUNDING * largest);
    while d == 0.0 {
        let size = c.norm();
        let Some(last) = a.nrows().checked_sub(1).filter(|_| size > 0.0) else { return Ok((Vec::new(), 0.0)) };
        gain *= turn(&mut a, &mut b, &c, last);
        let row = a.row(last).transpose();
        (d, c) = (b[last], row.rows(0, last).into_owned());
        (a, b) = (a.view((0, 0), (last, last)).into_owned(), b.rows(0, last).into_owned());
        if d.abs() <= of_input {
            d = 0.0;
        }
        if c.amax() <= of_states {
            c.fill(0.0);
        }
    }
    let zeros = matrix_eigenvalues(&(a - b * c.transpose() / d))?;
    Ok((zeros, gain * d))
}

/// Turns the states by a reflection such that c is along the last one; what c is there.
fn turn(a: &mut DMatrix<f64>, b: &mut DVector<f64>, c: &DVector<f64>, last: usize) -> f64 {
    let size = c.norm();
    let along = if c[last] > 0.0 { -size } else { size };
    let mut mirror = c.clone();
    mirror[last] -= along;
    let square = mirror.norm_squared();
    let reflected = |vector: DVector<f64>| {
        let share = 2.0 * mirror.dot(&vector) / square;
        vector - &mirror * share
    };
    for column in 0..a.ncols() {
        let turned = reflected(a.column(column).into_owned());
        a.set_column(column, &turned);
    }
    for row in 0..a.nrows() {
        let turned = reflected(a.row(row).transpose());
        a.set_row(row, &turned.transpose());
    }
    *b = reflected(b.clone());
    along
}
