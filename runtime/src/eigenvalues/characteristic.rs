//! The characteristic quartic of two coordinates, at any scale of the matrices.

use super::Quartic;
use crate::numeric::{equilibrate, exponent, ldexp};
use crate::{Complex, Matrix, System, SystemError};

type Rows = [[f64; 2]; 2];

impl System<2> {
    /// The four eigenvalues as the roots of two quadratic factors: in each half two real ones, ascending, or a conjugate
    /// pair, the negative imaginary part first.
    #[inline]
    pub(crate) fn factored_eigenvalues(&self) -> Result<[[Complex<f64>; 2]; 2], SystemError> {
        let [m, c, k] = [rows(&self.m), rows(&self.c), rows(&self.k)];
        // Without a branch for each entry.
        if [m, c, k].as_flattened().as_flattened().iter().fold(true, |all, &entry| all & is_moderate(entry)) {
            return Ok(quartic(m, c, k)?.roots());
        }
        self.require_finite()?;
        scaled(m, c, k)
    }
}

fn rows(matrix: &Matrix<f64, 2>) -> Rows {
    [[matrix.m11, matrix.m12], [matrix.m21, matrix.m22]]
}

/// Whether products and quotients of such numbers, as they occur here, stay in the range of `f64`.
#[inline]
fn is_moderate(entry: f64) -> bool {
    let magnitude = entry.abs();
    (1e-30..=1e30).contains(&magnitude) | (magnitude == 0.0)
}

/// The quartic `det(M s^2 + C s + K) / det M`.
#[inline]
fn quartic(m: Rows, c: Rows, k: Rows) -> Result<Quartic, SystemError> {
    let (forward, backward) = (m[0][0] * m[1][1], m[0][1] * m[1][0]);
    let det = forward - backward;
    // Below this the determinant is no more than the rounding of the entries.
    if det.abs() <= 8.0 * f64::EPSILON * (forward.abs() + backward.abs()) {
        return Err(SystemError::SingularMass);
    }
    let mixed = |x: Rows, y: Rows| (x[0][0] * y[1][1] - x[0][1] * y[1][0]) + (y[0][0] * x[1][1] - y[0][1] * x[1][0]);
    let determinant = |x: Rows| x[0][0] * x[1][1] - x[0][1] * x[1][0];
    let scale = 1.0 / det;
    Ok(Quartic {
        a: mixed(m, c) * scale,
        b: (mixed(m, k) + determinant(c)) * scale,
        c: mixed(c, k) * scale,
        d: determinant(k) * scale,
    })
}

/// Eigenvalues of matrices of any scale: rows, columns and time are measured in units that bring all entries to at most
/// one, all of them powers of two.
#[cold]
fn scaled(m: Rows, c: Rows, k: Rows) -> Result<[[Complex<f64>; 2]; 2], SystemError> {
    let (row, column) = equilibrate(m).ok_or(SystemError::SingularMass)?;
    let largest = |matrix: Rows| {
        let exponents = (0..4).filter_map(|i| Some(exponent(matrix[i / 2][i % 2])? + row[i / 2] + column[i % 2]));
        exponents.max()
    };
    // The power of two in 1/s that eigenvalues are measured in.
    let unit = largest(c).max(largest(k).map(|e| (e + 1).div_euclid(2))).unwrap_or(0);
    let scale = |matrix: Rows, power: i32| {
        let entry = |i: usize, j: usize| ldexp(matrix[i][j], row[i] + column[j] - power * unit);
        [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
    };
    let roots = quartic(scale(m, 0), scale(c, 1), scale(k, 2))?.roots();
    let eigenvalues = roots.map(|half| half.map(|root| Complex::new(ldexp(root.re, unit), ldexp(root.im, unit))));
    if eigenvalues.as_flattened().iter().any(|root| !(root.re.is_finite() && root.im.is_finite())) {
        return Err(SystemError::OutOfRange { quantity: "an eigenvalue" });
    }
    Ok(eigenvalues)
}
