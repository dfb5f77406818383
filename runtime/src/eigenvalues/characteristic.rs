//! The characteristic quartic of two coordinates, at any scale of the matrices.

use nalgebra::Complex;

use super::Quartic;
#[cfg(feature = "batch")]
use super::four::Four;
use crate::number::lane::Lane;
use crate::numeric::{equilibrate, exponent, ldexp};
use crate::system::{Matrix, System, SystemError};

/// The entries of a matrix by rows.
pub(crate) type Rows<T = f64> = [[T; 2]; 2];

/// Between these magnitudes, or at zero, products and quotients of entries, as they occur here, stay in the range of `f64`.
const SMALL: f64 = 1e-30;
const LARGE: f64 = 1e30;

impl System<2> {
    /// The four eigenvalues as the roots of two quadratic factors: in each half two real ones, ascending, or a conjugate
    /// pair, the negative imaginary part first.
    #[inline]
    pub(crate) fn factored_eigenvalues(&self) -> Result<[[Complex<f64>; 2]; 2], SystemError> {
        let [m, c, k] = [rows(&self.m), rows(&self.c), rows(&self.k)];
        // Without a branch for each entry.
        if are_moderate(m) & are_moderate(c) & are_moderate(k) {
            return Ok(regular_quartic(m, c, k)?.roots());
        }
        self.require_finite()?;
        scaled(m, c, k)
    }
}

/// The sorted eigenvalues of the equations of motion in each lane, and whether they are as exact as those of the scalar
/// [`System::quartic_eigenvalues`], which are then the same to the last bit; where they are not, it has to be asked.
#[cfg(feature = "batch")]
#[inline(always)]
pub(crate) fn quick_eigenvalues<T: Lane>(m: Rows<T>, c: Rows<T>, k: Rows<T>) -> (Four<T>, T::Mask) {
    let (quartic, is_singular) = quartic(m, c, k);
    let is_regular = !is_singular & quartic.is_moderate() & are_moderate(m) & are_moderate(c) & are_moderate(k);
    let (factors, are_exact) = quartic.quick_factors();
    (Four::new(factors), is_regular & are_exact)
}

fn rows(matrix: &Matrix<f64, 2>) -> Rows {
    [[matrix.m11, matrix.m12], [matrix.m21, matrix.m22]]
}

#[inline(always)]
fn are_moderate<T: Lane>(matrix: Rows<T>) -> T::Mask {
    let [[x11, x12], [x21, x22]] = matrix;
    (is_moderate(x11) & is_moderate(x12)) & (is_moderate(x21) & is_moderate(x22))
}

#[inline(always)]
fn is_moderate<T: Lane>(entry: T) -> T::Mask {
    let magnitude = entry.abs();
    let limit = |value| entry.like(value);
    (limit(SMALL).less_or_equal(magnitude) & magnitude.less_or_equal(limit(LARGE)))
        | magnitude.less_or_equal(limit(0.0))
}

/// The quartic `det(M s^2 + C s + K) / det M`, and whether M is singular.
#[inline(always)]
fn quartic<T: Lane>(m: Rows<T>, c: Rows<T>, k: Rows<T>) -> (Quartic<T>, T::Mask) {
    let (forward, backward) = (m[0][0] * m[1][1], m[0][1] * m[1][0]);
    let det = forward - backward;
    // Below this the determinant is no more than the rounding of the entries.
    let rounding = det.like(8.0 * f64::EPSILON) * (forward.abs() + backward.abs());
    let scale = det.like(1.0) / det;
    let quartic = Quartic {
        a: mixed(m, c) * scale,
        b: (mixed(m, k) + determinant(c)) * scale,
        c: mixed(c, k) * scale,
        d: determinant(k) * scale,
    };
    (quartic, det.abs().less_or_equal(rounding))
}

/// What M s^2 + C s + K has of two of them in its determinant.
#[inline(always)]
fn mixed<T: Lane>(x: Rows<T>, y: Rows<T>) -> T {
    (x[0][0] * y[1][1] - x[0][1] * y[1][0]) + (y[0][0] * x[1][1] - y[0][1] * x[1][0])
}

#[inline(always)]
fn determinant<T: Lane>(x: Rows<T>) -> T {
    x[0][0] * x[1][1] - x[0][1] * x[1][0]
}

#[inline]
fn regular_quartic(m: Rows, c: Rows, k: Rows) -> Result<Quartic, SystemError> {
    let (quartic, is_singular) = quartic(m, c, k);
    if is_singular { Err(SystemError::SingularMass) } else { Ok(quartic) }
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
    let roots = regular_quartic(scale(m, 0), scale(c, 1), scale(k, 2))?.roots();
    let eigenvalues = roots.map(|half| half.map(|root| Complex::new(ldexp(root.re, unit), ldexp(root.im, unit))));
    if eigenvalues.as_flattened().iter().any(|root| !(root.re.is_finite() && root.im.is_finite())) {
        return Err(SystemError::OutOfRange { quantity: "an eigenvalue" });
    }
    Ok(eigenvalues)
}
