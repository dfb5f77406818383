//! The left and right eigenvectors of an eigenvalue, as null vectors of a small complex matrix.

use nalgebra::Complex;
use nalgebra::SVector;

use super::pencil::ComplexMatrix;
use crate::system::Matrix;

/// Vectors with `Q x = 0` and `y^T Q = 0`, for the Q that is nearest to being singular under elimination.
pub(super) struct NullVectors<const N: usize> {
    pub(super) right: SVector<Complex<f64>, N>,
    /// Not conjugated: y^H of the textbooks is the transpose of this.
    pub(super) left: SVector<Complex<f64>, N>,
}

/// The null vectors of a matrix that is singular up to rounding, by elimination with complete pivoting.
///
/// Rows and columns are first brought to a common size by the sizes of the terms of their entries, so that their units do
/// not matter to the choice of pivots. The last pivot, which should be zero, is left out; with it left out, both vectors
/// are exact null vectors of a matrix that differs from the given one in that pivot alone.
pub(super) fn find_null_vectors<const N: usize>(matrix: &ComplexMatrix<N>, size: &Matrix<f64, N>) -> NullVectors<N> {
    let inverse = |size: f64| if size > 0.0 { 1.0 / size } else { 1.0 };
    let rows: [f64; N] = core::array::from_fn(|i| inverse(size.row(i).max()));
    let columns: [f64; N] =
        core::array::from_fn(|j| inverse((0..N).map(|i| rows[i] * size[(i, j)]).fold(0.0, f64::max)));
    let mut u: ComplexMatrix<N> = Matrix::from_fn(|i, j| matrix[(i, j)] * (rows[i] * columns[j]));
    // Below its diagonal, u keeps the factors of the elimination.
    let (mut row_order, mut column_order): ([usize; N], [usize; N]) =
        (core::array::from_fn(|i| i), core::array::from_fn(|i| i));
    for step in 0..N - 1 {
        let places = (step..N).flat_map(|i| (step..N).map(move |j| (i, j)));
        let pivot = places.max_by(|x, y| u[*x].norm_sqr().total_cmp(&u[*y].norm_sqr()));
        let (row, column) = pivot.unwrap_or((step, step));
        u.swap_rows(step, row);
        u.swap_columns(step, column);
        row_order.swap(step, row);
        column_order.swap(step, column);
        if u[(step, step)].norm_sqr() == 0.0 {
            break;
        }
        for i in step + 1..N {
            let factor = u[(i, step)] / u[(step, step)];
            u[(i, step)] = factor;
            for j in step + 1..N {
                let product = factor * u[(step, j)];
                u[(i, j)] -= product;
            }
        }
    }
    let (mut right, mut left) = (SVector::zeros(), SVector::zeros());
    let one = Complex::new(1.0, 0.0);
    let mut solved: [Complex<f64>; N] = [one; N];
    for i in (0..N - 1).rev() {
        let sum: Complex<f64> = (i + 1..N).map(|j| u[(i, j)] * solved[j]).sum();
        // A zero pivot leaves its unknown free.
        solved[i] = if u[(i, i)].norm_sqr() == 0.0 { Complex::new(0.0, 0.0) } else { -sum / u[(i, i)] };
    }
    for (i, &column) in column_order.iter().enumerate() {
        right[column] = solved[i] * columns[column];
    }
    let mut solved: [Complex<f64>; N] = [one; N];
    for j in (0..N - 1).rev() {
        solved[j] = -(j + 1..N).map(|i| u[(i, j)] * solved[i]).sum::<Complex<f64>>();
    }
    for (i, &row) in row_order.iter().enumerate() {
        left[row] = solved[i] * rows[row];
    }
    NullVectors { right, left }
}

#[cfg(test)]
mod tests {
    use nalgebra::Complex;

    use super::find_null_vectors;
    use crate::system::Matrix;

    /// A matrix of rank 2, whose second row is the sum of the first and i times the third.
    #[test]
    fn both_sides_are_null_vectors() {
        let z = Complex::new;
        let (first, third) = ([z(1.0, 2.0), z(0.0, -1.0), z(3.0, 0.5)], [z(-2.0, 0.0), z(4.0, 1.0), z(0.25, 0.0)]);
        let rows = [first, core::array::from_fn(|j| first[j] + z(0.0, 1.0) * third[j]), third];
        let matrix = Matrix::<Complex<f64>, 3>::from_fn(|i, j| rows[i][j]);
        let vectors = find_null_vectors(&matrix, &matrix.map(|entry| entry.norm()));
        assert!((matrix * vectors.right).norm() < 1e-15 * vectors.right.norm());
        assert!((vectors.left.transpose() * matrix).norm() < 1e-15 * vectors.left.norm());
        let expected = [z(-1.0, 0.0), z(1.0, 0.0), z(0.0, -1.0)];
        for (left, expected) in vectors.left.iter().zip(expected) {
            assert!((left / vectors.left[1] - expected).norm() < 1e-15);
        }
    }

    /// Rows in units that differ by a factor of 2^600 change nothing but the units of the vectors.
    #[test]
    fn units_do_not_matter() {
        let matrix = Matrix::<Complex<f64>, 2>::new(1.0.into(), 3.0.into(), 2.0.into(), 6.0.into());
        let unit = 2f64.powi(300);
        let scaled = Matrix::from_fn(|i, j| matrix[(i, j)] * [unit, 1.0 / unit][i] * [1.0, unit][j]);
        let [plain, scaled] =
            [matrix, scaled].map(|matrix| find_null_vectors(&matrix, &matrix.map(|entry| entry.norm())));
        let ratio = |vector: &nalgebra::SVector<Complex<f64>, 2>| vector[0] / vector[1];
        assert_eq!(ratio(&scaled.right), ratio(&plain.right) * unit);
        assert_eq!(ratio(&scaled.left), ratio(&plain.left) / unit / unit);
    }
}
