//! Whether a turn is stable.

use nalgebra::Complex;

use super::balance::Balance;
use crate::eigenvalues::matrix_eigenvalues;
use crate::motion::MotionError;

/// The eigenvalues of the motion near a turn, without the one that is zero since from circle to circle nothing drives back;
/// none if they cannot be found.
pub(super) fn eigenvalues(balance: &Balance, free: &[f64], speeds: &[f64]) -> Result<Vec<Complex<f64>>, MotionError> {
    let Ok(mut found) = matrix_eigenvalues(&balance.slopes(free, speeds)?) else { return Ok(Vec::new()) };
    let smallest = found.iter().enumerate().min_by(|(_, a), (_, b)| a.norm().total_cmp(&b.norm()));
    if let Some((place, _)) = smallest {
        found.remove(place);
    }
    Ok(found)
}
