//! What a state space does between all of its inputs and outputs together.

use carvallo::{Complex, SystemError};
use nalgebra::DMatrix;

use crate::balance::Channel;
use crate::state_space::StateSpace;
use crate::transfer::TransferFunction;
use crate::zeros::{ROUNDING, zeros};

/// The transmission zeros of a state space in 1/s, sorted by real part, then by imaginary part: where the matrix of its transfer
/// functions loses its rank, so that inputs `u e^(st)` of some directions leave all outputs zero. Hidden modes, which an input does not
/// excite or no output shows, are among them, as they are among the poles.
///
/// `None` where there are not as many outputs as inputs, and where the matrix has no full rank at any s, as with outputs that depend on
/// each other.
///
/// # Errors
/// If the iteration for eigenvalues does not converge, or one leaves the range of `f64`.
pub fn transmission_zeros(space: &StateSpace) -> Result<Option<Vec<Complex<f64>>>, SystemError> {
    if space.inputs.len() != space.outputs.len() || space.inputs.is_empty() {
        return Ok(None);
    }
    let (zeros, gain) = zeros(Channel::whole(space))?;
    Ok((gain != 0.0).then_some(zeros))
}

/// The singular values of the matrix `G(iω)` at a frequency in rad/s, descending: the largest and smallest gain from inputs to outputs
/// over all directions of these, and those between. They are in the units of outputs by those of inputs, and change with these.
///
/// What is no more than rounding of the largest is zero, as where outputs depend on each other.
///
/// `functions` are those from each input to each output, those of one input one after the other. At a pole there are none.
pub fn singular_values(functions: &[TransferFunction], inputs: usize, frequency: f64) -> Option<Vec<f64>> {
    let s = Complex::new(0.0, frequency);
    let outputs = functions.len().checked_div(inputs)?;
    let matrix = DMatrix::from_iterator(outputs, inputs, functions.iter().map(|function| function.at(s)));
    // In units of about one, where squares are in range.
    let size = matrix.iter().map(|value| value.norm()).fold(0.0, f64::max);
    if !size.is_finite() || matrix.iter().any(|value| value.is_nan()) {
        return None;
    }
    if size == 0.0 {
        return Some(vec![0.0; inputs.min(outputs)]);
    }
    // As a real matrix of twice the size, which has each singular value twice.
    let real = DMatrix::from_fn(2 * outputs, 2 * inputs, |row, column| {
        let value = matrix[(row % outputs, column % inputs)] / size;
        match (row < outputs, column < inputs) {
            (true, false) => -value.im,
            (false, true) => value.im,
            _ => value.re,
        }
    });
    let mut values: Vec<f64> = real.singular_values().iter().copied().collect();
    values.sort_by(|a, b| b.total_cmp(a));
    let rounding = ROUNDING * values[0];
    let told = values.into_iter().step_by(2);
    Some(told.map(|value| if value <= rounding { 0.0 } else { size * value }).collect())
}
