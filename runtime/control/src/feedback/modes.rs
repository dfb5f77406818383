//! Modes of a state matrix, and whether inputs reach them and weights see them (Popov, Belevitch & Hautus).

use nalgebra::{Complex, DMatrix, Schur};

/// Steps of the QR algorithm before it is given up.
const STEPS: usize = 10_000;

/// Singular values below this part of the largest are zero but for rounding.
pub const ZERO: f64 = 1e-10;

/// Below this part gains grow beyond what doubles can tell.
pub const NEARLY_ZERO: f64 = 1e-5;

/// The eigenvalues in 1/s, sorted by real part, then by imaginary part; `None` if they are not found.
pub fn eigenvalues(a: DMatrix<f64>) -> Option<Vec<Complex<f64>>> {
    if !a.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let schur = Schur::try_new(a, f64::EPSILON, STEPS)?;
    let mut values: Vec<Complex<f64>> = schur.complex_eigenvalues().iter().copied().collect();
    values.sort_by(|x, y| x.re.total_cmp(&y.re).then(x.im.total_cmp(&y.im)));
    Some(values)
}

/// An eigenvalue whose mode does not die away by itself, and that no input reaches: `[A - s I, B]` has not full rank, or
/// singular values below a part of its largest.
pub fn unreached(a: &DMatrix<f64>, b: &DMatrix<f64>, part: f64) -> Option<Complex<f64>> {
    let size = a.norm();
    find(a, |value| value.re >= -ZERO * size, b, part)
}

/// An eigenvalue on the imaginary axis that no row of C sees.
pub fn unseen(a: &DMatrix<f64>, c: &DMatrix<f64>) -> Option<Complex<f64>> {
    let size = a.norm();
    find(&a.transpose(), |value| value.re.abs() <= ZERO * size, &c.transpose(), ZERO)
}

fn find(
    a: &DMatrix<f64>,
    matters: impl Fn(&Complex<f64>) -> bool,
    b: &DMatrix<f64>,
    part: f64,
) -> Option<Complex<f64>> {
    // Inputs are of any size: a force in N does less than one in MN.
    let size = a.norm();
    let columns = b.column_iter().filter(|column| column.norm() > 0.0).map(|column| column * (size / column.norm()));
    let columns: Vec<_> = columns.collect();
    let n = a.nrows();
    let values = eigenvalues(a.clone())?;
    values.into_iter().filter(|value| value.im >= 0.0 && matters(value)).find(|value| {
        // A complex matrix as a real one of twice the size, which has each singular value twice.
        let width = n + columns.len();
        let mut real = DMatrix::zeros(2 * n, 2 * width);
        for (row, column) in [(0, 0), (1, 1)] {
            let mut block = real.view_mut((row * n, column * width), (n, width));
            block.columns_mut(0, n).copy_from(&(a - DMatrix::identity(n, n) * value.re));
            for (index, input) in columns.iter().enumerate() {
                block.set_column(n + index, input);
            }
        }
        for index in 0..n {
            real[(index, width + index)] = value.im;
            real[(n + index, index)] = -value.im;
        }
        let singular = real.singular_values();
        singular.min() <= part * singular.max()
    })
}
