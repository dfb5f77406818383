//! Backward errors of eigenvalues of any number of coordinates, at 320 bits.
//!
//! Time is measured in units in which the state matrix `A = [0, I; -M^-1 K, -M^-1 C]` of the equations has blocks of at
//! most size one; its norm is then a few units, and an eigenvalue is backward stable if it is one of `A + E` with E of the
//! size of rounding.

use carvallo::{Matrix, System};

use crate::roots::Complex;
use carvallo_compare::Real;

type Rows = Vec<Vec<Complex>>;

/// The state matrix at 320 bits, in a unit of time.
pub struct StateMatrix {
    rows: Rows,
    /// The unit of eigenvalues in 1/s, a power of two.
    unit: f64,
    /// The norm of Frobenius.
    norm: f64,
}

impl StateMatrix {
    /// Of a system with a regular mass matrix.
    pub fn new<const N: usize>(system: &System<N>) -> Self {
        let mass = Factors::new(complex(&system.m));
        let quotient = |matrix: &Matrix<f64, N>| {
            let column = |j: usize| (0..N).map(|i| real(-matrix[(i, j)])).collect::<Vec<_>>();
            (0..N).map(|j| mass.solve(&column(j))).collect::<Rows>()
        };
        // By columns.
        let (stiffness, damping) = (quotient(&system.k), quotient(&system.c));
        let largest =
            |columns: &Rows| columns.iter().flatten().map(|entry| entry.re.abs().to_f64()).fold(0.0, f64::max);
        let size = largest(&stiffness).sqrt().max(largest(&damping));
        let unit = if size > 0.0 { size.log2().ceil().exp2() } else { 1.0 };
        let per_unit = Real::from(1.0 / unit);
        let entry = |i: usize, j: usize| match (i < N, j < N) {
            (true, _) => real(f64::from(u8::from(j == i + N))),
            (false, true) => scale(stiffness[j][i - N], per_unit * per_unit),
            (false, false) => scale(damping[j - N][i - N], per_unit),
        };
        let rows: Rows = (0..2 * N).map(|i| (0..2 * N).map(|j| entry(i, j)).collect()).collect();
        let norm = length(&rows.concat()).to_f64();
        Self { rows, unit, norm }
    }

    /// How far, relative to the norm and in units of the precision of `f64`, the nearest matrix is that has an eigenvalue:
    /// the smallest singular value of `A - s`, from above, by inverse iteration.
    pub fn error_of(&self, eigenvalue: nalgebra::Complex<f64>) -> f64 {
        let shifted = Factors::new(self.minus(eigenvalue));
        let mut vector: Vec<_> = (0..self.rows.len()).map(|i| real(1.0 + 0.1 * (i as f64).sin())).collect();
        let mut smallest = f64::INFINITY;
        for _ in 0..2 {
            let left = normalized(shifted.solve_adjoint(&normalized(vector)));
            vector = shifted.solve(&left);
            smallest = smallest.min((Real::from(1.0) / length(&vector)).to_f64());
        }
        smallest / self.norm / f64::EPSILON
    }

    /// How far the polynomial with the given roots is from the characteristic one, on a circle of twice the norm, relative
    /// to it and in units of the precision of `f64` for each root: what shows roots that are missing or there twice.
    pub fn joint_error(&self, eigenvalues: &[nalgebra::Complex<f64>]) -> f64 {
        let n = self.rows.len();
        assert_eq!(eigenvalues.len(), n);
        let errors = (0..n).map(|k| {
            let (sin, cos) = (0.3 + std::f64::consts::TAU * k as f64 / n as f64).sin_cos();
            let radius = 2.0 * self.norm * self.unit;
            let point = nalgebra::Complex::new(radius * cos, radius * sin);
            let per_unit = Real::from(1.0 / self.unit);
            let exact = Factors::new(self.minus(point)).determinant();
            let product = eigenvalues.iter().fold(real(1.0), |product, root| {
                let [root, point] =
                    [root, &point].map(|z| scale(Complex { re: Real::from(z.re), im: Real::from(z.im) }, per_unit));
                product * (root - point)
            });
            length(&[(product - exact) / exact]).to_f64()
        });
        errors.fold(0.0, f64::max) / (f64::EPSILON * n as f64)
    }

    fn minus(&self, eigenvalue: nalgebra::Complex<f64>) -> Rows {
        let per_unit = Real::from(1.0 / self.unit);
        let shift = Complex { re: Real::from(eigenvalue.re) * per_unit, im: Real::from(eigenvalue.im) * per_unit };
        let mut shifted = self.rows.clone();
        for (i, row) in shifted.iter_mut().enumerate() {
            row[i] = row[i] - shift;
        }
        shifted
    }
}

fn real(value: f64) -> Complex {
    Complex { re: Real::from(value), im: Real::from(0.0) }
}

fn scale(value: Complex, factor: Real) -> Complex {
    Complex { re: value.re * factor, im: value.im * factor }
}

fn conjugate(value: Complex) -> Complex {
    Complex { re: value.re, im: -value.im }
}

fn complex<const N: usize>(matrix: &Matrix<f64, N>) -> Rows {
    (0..N).map(|i| (0..N).map(|j| real(matrix[(i, j)])).collect()).collect()
}

fn length(vector: &[Complex]) -> Real {
    let square = vector.iter().fold(Real::from(0.0), |sum, entry| sum + entry.norm_sqr());
    square.sqrt()
}

fn normalized(vector: Vec<Complex>) -> Vec<Complex> {
    let factor = Real::from(1.0) / length(&vector);
    vector.into_iter().map(|entry| scale(entry, factor)).collect()
}

/// The factors of a matrix with its rows in the order of its pivots: L below the diagonal, with ones on it, and U.
struct Factors {
    lu: Rows,
    order: Vec<usize>,
    /// Of the permutation of the rows.
    sign: f64,
}

impl Factors {
    /// A pivot that is exactly zero, at an eigenvalue that is exact, becomes negligible instead.
    fn new(mut a: Rows) -> Self {
        let n = a.len();
        let mut order: Vec<usize> = (0..n).collect();
        let mut sign = 1.0;
        for step in 0..n {
            let larger = |i: usize, j: usize| a[i][step].norm_sqr() > a[j][step].norm_sqr();
            let pivot = (step..n).fold(step, |best, i| if larger(i, best) { i } else { best });
            if pivot != step {
                a.swap(step, pivot);
                order.swap(step, pivot);
                sign = -sign;
            }
            if a[step][step].norm_sqr() == Real::from(0.0) {
                a[step][step] = real(2f64.powi(-280));
            }
            let (above, below) = a.split_at_mut(step + 1);
            let pivot_row = &above[step];
            for row in below {
                let factor = row[step] / pivot_row[step];
                row[step] = factor;
                for (entry, pivot) in row.iter_mut().zip(pivot_row).skip(step + 1) {
                    *entry = *entry - factor * *pivot;
                }
            }
        }
        Self { lu: a, order, sign }
    }

    /// The solution of `A x = b`.
    fn solve(&self, b: &[Complex]) -> Vec<Complex> {
        let (lu, n) = (&self.lu, b.len());
        let mut x: Vec<_> = self.order.iter().map(|&row| b[row]).collect();
        for i in 0..n {
            x[i] = (0..i).fold(x[i], |rest, j| rest - lu[i][j] * x[j]);
        }
        for i in (0..n).rev() {
            x[i] = (i + 1..n).fold(x[i], |rest, j| rest - lu[i][j] * x[j]) / lu[i][i];
        }
        x
    }

    /// The solution of `A* x = b` with the conjugate transpose.
    fn solve_adjoint(&self, b: &[Complex]) -> Vec<Complex> {
        let (lu, n) = (&self.lu, b.len());
        let mut y = b.to_vec();
        for i in 0..n {
            y[i] = (0..i).fold(y[i], |rest, j| rest - conjugate(lu[j][i]) * y[j]) / conjugate(lu[i][i]);
        }
        for i in (0..n).rev() {
            y[i] = (i + 1..n).fold(y[i], |rest, j| rest - conjugate(lu[j][i]) * y[j]);
        }
        let mut x = y.clone();
        self.order.iter().zip(y).for_each(|(&row, entry)| x[row] = entry);
        x
    }

    fn determinant(&self) -> Complex {
        (0..self.lu.len()).fold(real(self.sign), |product, i| product * self.lu[i][i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Complex as C, Matrix2};

    #[test]
    fn tells_how_far_off_eigenvalues_are() {
        // s^2 = -1 and (s + 1/4)(s + 1/2) = 0, in units that need no scaling.
        let c = Matrix2::new(0.0, 0.0, 0.0, 0.75);
        let state = StateMatrix::new(&System::new(Matrix2::identity(), c, Matrix2::new(1.0, 0.0, 0.0, 0.125)));
        let exact = [C::new(0.0, 1.0), C::new(0.0, -1.0), C::new(-0.25, 0.0), C::new(-0.5, 0.0)];
        assert!(exact.iter().all(|value| state.error_of(*value) < 1e-60));
        assert!(state.joint_error(&exact) < 1e-60);
        // The undamped block is normal: an eigenvalue that is off by 1e-10 needs just that in the matrix.
        let off = state.error_of(C::new(0.0, 1.0 + 1e-10)) * f64::EPSILON * state.norm;
        assert!((off / 1e-10 - 1.0).abs() < 1e-6, "{off}");
        let twice = [C::new(0.0, 1.0), C::new(0.0, -1.0), C::new(-0.25, 0.0), C::new(-0.25, 0.0)];
        assert!(state.joint_error(&twice) > 1e12);
    }
}
