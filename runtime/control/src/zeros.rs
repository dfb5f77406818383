//! Zeros and gain of a state space with as many outputs as inputs.

use carvallo::{Complex, SystemError, matrix_eigenvalues};
use nalgebra::{DMatrix, DVector};

use crate::balance::{Balanced, Channel};
use crate::rest::{take_out_zeros, with_rest};

/// What is smaller than this beside what it was computed from is its rounding.
pub const ROUNDING: f64 = 1e-13;

/// The zeros of the determinant of `D + C (s - A)^-1 B` in 1/s, sorted by real part, then by imaginary part, and the number k with
/// which it is `k Π (s - zero) / Π (s - eigenvalue of A)`. Where it is zero at all s, as where an output does not depend on the
/// inputs, or two depend on each other, k is zero and there are none.
///
/// The zeros are the numbers at which the pencil of Rosenbrock is singular,
///
/// ```text
/// [ A - s  B ]
/// [   C    D ]
/// ```
///
/// of which those at zero are [taken out](take_out_zeros) first. Then it is deflated of its infinite eigenvalues by reflections (Emami-Naeini & Van Dooren 1982, with one row at a time): while D is
/// singular, the outputs are turned such that the inputs do not reach the last one at once, and the states such that it is a
/// multiple of the last one alone. That one is then as good as an output that is zero, so its row takes the place of the output's,
/// and it is a state no longer. A D that is not singular leaves the eigenvalues of `A - B D^-1 C`. A state that is taken out lowers
/// the degree of the numerator by one, and k is the product of what the outputs were multiples by, and of the determinant of D.
///
/// # Errors
/// If the iteration for eigenvalues does not converge, or one leaves the range of `f64`.
///
/// # Panics
/// If there are not as many outputs as inputs.
pub fn zeros(channel: Channel) -> Result<(Vec<Complex<f64>>, f64), SystemError> {
    let Balanced { channel, power } = channel.balanced();
    assert!(channel.d.is_square() && channel.d.nrows() > 0, "as many outputs as inputs");
    let states = channel.a.nrows();
    let Channel { mut a, mut b, mut c, mut d } = take_out_zeros(channel);
    let at_rest = states - a.nrows();
    let mut gain = 2_f64.powi(power);
    let [of_inputs, of_states] = [b.amax(), a.amax()].map(|largest| ROUNDING * largest);
    let output = d.nrows() - 1;
    while let Some(mirrored) = turn_outputs(&mut c, &mut d) {
        let along = c.row(output).transpose();
        let Some(last) = a.nrows().checked_sub(1).filter(|_| along.norm() > 0.0) else { return Ok((Vec::new(), 0.0)) };
        gain *= mirrored * turn_states(&mut a, &mut b, &mut c, &along);
        c.set_row(output, &a.row(last));
        d.set_row(output, &b.row(last));
        (a, b) = (a.view((0, 0), (last, last)).into_owned(), b.rows(0, last).into_owned());
        c = c.columns(0, last).into_owned();
        if d.row(output).amax() <= of_inputs {
            d.row_mut(output).fill(0.0);
        }
        if c.row(output).iter().all(|entry| entry.abs() <= of_states) {
            c.row_mut(output).fill(0.0);
        }
    }
    let factors = d.full_piv_lu();
    let Some(inverse) = factors.try_inverse() else { return Ok((Vec::new(), 0.0)) };
    let others = matrix_eigenvalues(&(a - b * inverse * c))?;
    Ok((with_rest(others, at_rest), gain * factors.determinant()))
}

/// If D is singular, turns the outputs by reflections such that its last row is zero; -1 or 1, the determinant of these.
fn turn_outputs(c: &mut DMatrix<f64>, d: &mut DMatrix<f64>) -> Option<f64> {
    let last = d.nrows() - 1;
    let decomposed = d.clone().col_piv_qr();
    let (turned, triangular) = (decomposed.q(), decomposed.r());
    if triangular[(last, last)].abs() > ROUNDING * triangular[(0, 0)].abs() {
        return None;
    }
    *c = turned.tr_mul(c);
    *d = turned.tr_mul(d);
    d.row_mut(last).fill(0.0);
    // What is left of an output that is nothing but others.
    if c.row(last).amax() <= ROUNDING * c.amax() {
        c.row_mut(last).fill(0.0);
    }
    Some(turned.determinant().signum())
}

/// Turns the states by a reflection such that a row of C, which is not zero, is along the last one; what it is there.
fn turn_states(a: &mut DMatrix<f64>, b: &mut DMatrix<f64>, c: &mut DMatrix<f64>, row: &DVector<f64>) -> f64 {
    let last = a.nrows() - 1;
    let size = row.norm();
    let along = if row[last] > 0.0 { -size } else { size };
    let mut mirror = row.clone();
    mirror[last] -= along;
    let square = mirror.norm_squared();
    let reflect_columns = |matrix: &mut DMatrix<f64>| {
        let shares = mirror.tr_mul(matrix) * (2.0 / square);
        *matrix -= &mirror * shares;
    };
    let reflect_rows = |matrix: &mut DMatrix<f64>| {
        let shares = &*matrix * &mirror * (2.0 / square);
        *matrix -= shares * mirror.transpose();
    };
    reflect_columns(a);
    reflect_rows(a);
    reflect_columns(b);
    reflect_rows(c);
    along
}
