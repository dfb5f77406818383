//! The eigenvalues of any matrix.

use nalgebra::{Complex, DMatrix};

use super::general::Spectrum;
use crate::characteristic::units::to_per_second;
use crate::numeric::{Square, exponent, ldexp, sort_by};
use crate::system::{SystemError, require_finite};

/// The eigenvalues of a square matrix, such as the state matrix of a closed loop, sorted by real part, then by imaginary part.
///
/// The matrix is balanced, and its eigenvalues come from the QR algorithm with a bound on its iterations; jointly they are the
/// exact ones of a matrix that differs from the balanced one by rounding, relative to its norm. Real ones have an imaginary part
/// of exactly zero, and pairs are exactly conjugate. An eigenvalue that stands alone in its row or column, but for the diagonal, is
/// that entry: of integrals it is exactly zero, however many of them follow each other.
///
/// ```
/// use carvallo::nalgebra::DMatrix;
///
/// let values = carvallo::matrix_eigenvalues(&DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -4.0, 0.0]))?;
/// assert_eq!(values, [carvallo::Complex::new(0.0, -2.0), carvallo::Complex::new(0.0, 2.0)]);
/// # Ok::<(), carvallo::SystemError>(())
/// ```
///
/// # Errors
/// If an entry is not finite, if an eigenvalue leaves the range of `f64`, or if the iteration does not converge.
///
/// # Panics
/// If the matrix is not square.
pub fn matrix_eigenvalues(matrix: &DMatrix<f64>) -> Result<Vec<Complex<f64>>, SystemError> {
    assert!(matrix.is_square(), "eigenvalues are those of a square matrix");
    matrix.iter().try_for_each(|&entry| require_finite("an entry of the matrix", entry))?;
    let (coupled, mut values) = without_isolated(matrix);
    let largest = coupled.iter().fold(0.0, |largest: f64, &row| {
        coupled.iter().fold(largest, |largest, &column| largest.max(matrix[(row, column)].abs()))
    });
    // In a unit that brings entries to at most one.
    let unit = exponent(largest).unwrap_or(0);
    let scaled = |row: usize, column: usize| ldexp(matrix[(coupled[row], coupled[column])], -unit);
    let mut found = Spectrum::of(Square::from_fn(coupled.len(), scaled), 0)?.values;
    to_per_second(&mut found, unit)?;
    values.extend(found);
    sort_by(&mut values, |x, y| x.re.total_cmp(&y.re).then(x.im.total_cmp(&y.im)));
    Ok(values)
}

/// The rows that are left when each that is coupled to no other left one, or to which no other left one is coupled, has been
/// taken out; and the eigenvalues of these.
fn without_isolated(matrix: &DMatrix<f64>) -> (Vec<usize>, Vec<Complex<f64>>) {
    let mut left: Vec<usize> = (0..matrix.nrows()).collect();
    let mut values = Vec::new();
    loop {
        let isolated = left.iter().position(|&state| {
            let mut others = left.iter().filter(|&&other| other != state);
            others.clone().all(|&other| matrix[(state, other)] == 0.0)
                || others.all(|&other| matrix[(other, state)] == 0.0)
        });
        let Some(place) = isolated else { return (left, values) };
        let state = left.remove(place);
        // Adding zero turns -0 into 0.
        values.push(Complex::new(matrix[(state, state)] + 0.0, 0.0));
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Complex, DMatrix};

    use super::matrix_eigenvalues;

    /// Of the companion matrix of (s - 1)(s + 2)((s + 3)² + 16), in units that differ by 1e100.
    #[test]
    fn units_do_not_matter() {
        let rows = [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 50.0, -13.0, -29.0, -7.0];
        let units = [1.0, 1e75, 1e-25, 1e-10];
        let matrix = DMatrix::from_fn(4, 4, |i, j| rows[4 * i + j] * units[i] / units[j]);
        let found = matrix_eigenvalues(&matrix).expect("eigenvalues");
        let expected = [(-3.0, -4.0), (-3.0, 4.0), (-2.0, 0.0), (1.0, 0.0)];
        for (found, (re, im)) in found.into_iter().zip(expected) {
            assert!((found - Complex::new(re, im)).norm() < 1e-13, "{found}");
        }
    }

    /// Two integrals, one of the other, behind a motion that grows: a double eigenvalue with one eigenvector.
    #[test]
    fn integrals_are_exactly_zero() {
        let matrix =
            DMatrix::from_row_slice(4, 4, &[0.1, 1.0, 0., 0., -2.0, 0.3, 0., 0., 5.0, 6.0, 0., 0., 0., 0., 7.0, 0.]);
        let found = matrix_eigenvalues(&matrix).expect("eigenvalues");
        assert_eq!(found[..2], [Complex::new(0.0, 0.0); 2]);
        assert_eq!((found[2].re, found[3].re), (0.2, 0.2));
    }
}
