//! The eigenvalues of any number of coordinates, by the QR algorithm.

use nalgebra::{DMatrix, Schur};

use crate::numeric::{exponent, ldexp};
use crate::{Complex, System, SystemError};

/// The bound per eigenvalue that LAPACK uses; two or three are usual.
const ITERATIONS_PER_EIGENVALUE: usize = 30;

pub(super) fn eigenvalues<const N: usize>(system: &System<N>) -> Result<Vec<Complex<f64>>, SystemError> {
    let state_space = system.state_space()?;
    // Time in units that make the blocks of stiffness and damping comparable.
    let largest = |matrix: &crate::Matrix<f64, N>| matrix.iter().filter_map(|&entry| exponent(entry)).max();
    let stiffness = largest(&state_space.stiffness).map(|e| (e + 1).div_euclid(2));
    let unit = stiffness.max(largest(&state_space.damping)).unwrap_or(0);
    let mut state_matrix = DMatrix::zeros(2 * N, 2 * N);
    for i in 0..N {
        state_matrix[(i, N + i)] = 1.0;
        for j in 0..N {
            state_matrix[(N + i, j)] = ldexp(state_space.stiffness[(i, j)], -2 * unit);
            state_matrix[(N + i, N + j)] = ldexp(state_space.damping[(i, j)], -unit);
        }
    }
    let iterations = ITERATIONS_PER_EIGENVALUE * 2 * N;
    let schur = Schur::try_new(state_matrix, f64::EPSILON, iterations);
    let (_, triangular) = schur.ok_or(SystemError::NotConverged { iterations })?.unpack();
    let eigenvalues: Vec<_> =
        blocks(&triangular).into_iter().map(|root| Complex::new(ldexp(root.re, unit), ldexp(root.im, unit))).collect();
    if eigenvalues.iter().any(|root| !(root.re.is_finite() && root.im.is_finite())) {
        return Err(SystemError::OutOfRange { quantity: "an eigenvalue" });
    }
    Ok(eigenvalues)
}

/// The eigenvalues of the blocks, of one or two rows, on the diagonal of a real Schur form.
fn blocks(t: &DMatrix<f64>) -> Vec<Complex<f64>> {
    let mut eigenvalues = Vec::with_capacity(t.nrows());
    let mut i = 0;
    while i < t.nrows() {
        if i + 1 == t.nrows() || t[(i + 1, i)] == 0.0 {
            eigenvalues.push(Complex::new(t[(i, i)], 0.0));
            i += 1;
        } else {
            let mean = 0.5 * (t[(i, i)] + t[(i + 1, i + 1)]);
            let half = 0.5 * (t[(i, i)] - t[(i + 1, i + 1)]);
            let discriminant = half * half + t[(i, i + 1)] * t[(i + 1, i)];
            let root = discriminant.abs().sqrt();
            let offset = if discriminant < 0.0 { Complex::new(0.0, root) } else { Complex::new(root, 0.0) };
            eigenvalues.extend([Complex::from(mean) - offset, Complex::from(mean) + offset]);
            i += 2;
        }
    }
    eigenvalues
}
