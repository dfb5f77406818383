//! Whether a turn is stable.

use nalgebra::{Complex, Schur};

use super::balance::Balance;
use crate::motion::MotionError;

/// The QR algorithm needs two or three sweeps for each eigenvalue.
const MOST_SWEEPS: usize = 1000;

/// The eigenvalues of the motion near a turn, without the one that is zero since from circle to circle nothing drives back;
/// none if they cannot be found.
pub(super) fn eigenvalues(balance: &Balance, free: &[f64], speeds: &[f64]) -> Result<Vec<Complex<f64>>, MotionError> {
    let Some(schur) = Schur::try_new(balance.slopes(free, speeds)?, f64::EPSILON, MOST_SWEEPS) else {
        return Ok(Vec::new());
    };
    let mut found: Vec<Complex<f64>> = schur.complex_eigenvalues().iter().copied().collect();
    found.sort_by(|a, b| a.norm().total_cmp(&b.norm()));
    found.remove(0);
    found.sort_by(|a, b| a.re.total_cmp(&b.re).then(a.im.total_cmp(&b.im)));
    Ok(found)
}
