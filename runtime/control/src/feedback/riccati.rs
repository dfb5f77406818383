//! The continuous algebraic Riccati equation.

use std::fmt;

use nalgebra::{DMatrix, DVector};

use super::modes::eigenvalues;

/// Steps of an iteration that converges quadratically, before it is given up.
const STEPS: usize = 100;

/// Steps of refinement at most.
const REFINEMENTS: usize = 20;

/// The solution X of `A' X + X A - X G X + Q = 0` for which `A - G X` is stable, with symmetric G and Q that are positive
/// semidefinite: of a linear quadratic regulator `G = B R^-1 B'`.
///
/// It is found from the invariant subspace of the Hamiltonian matrix `[A, -G; -Q, -A']` of the stable eigenvalues, which its
/// matrix sign function separates (Roberts 1980; Byers 1987), and refined by the method of Kleinman (1968) until rounding stops
/// it.
#[derive(Clone, Debug, PartialEq)]
pub struct Riccati {
    /// X, symmetric.
    pub solution: DMatrix<f64>,
    /// The size of what is left of the equation, relative to that of its terms, in the Frobenius norm.
    pub residual: f64,
}

/// Why there is no solution that stabilizes, or none was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RiccatiError {
    /// The Hamiltonian matrix has eigenvalues on the imaginary axis, as far as rounding tells.
    OnAxis,
    /// What was found does not stabilize, or does not solve the equation.
    NotStabilizing,
    /// Squares of entries leave the range of doubles.
    OutOfRange,
}

impl fmt::Display for RiccatiError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::OnAxis => "the Hamiltonian matrix has eigenvalues on the imaginary axis",
            Self::NotStabilizing => "no solution of the Riccati equation was found that stabilizes",
            Self::OutOfRange => {
                "weights of these sizes lead beyond the range of floating-point numbers; expected ones that are nearer to 1"
            }
        })
    }
}

impl std::error::Error for RiccatiError {}

impl Riccati {
    /// Solves the equation for square matrices of one size.
    ///
    /// # Errors
    /// If there is no solution that stabilizes: where an input reaches no unstable mode, or where an undamped one is seen by no
    /// weight.
    pub fn new(a: &DMatrix<f64>, g: &DMatrix<f64>, q: &DMatrix<f64>) -> Result<Self, RiccatiError> {
        let is_stable = |solution: &DMatrix<f64>| {
            eigenvalues(a - g * solution).is_some_and(|values| values.iter().all(|value| value.re < 0.0))
        };
        // Without weights nothing is gained by what costs, and there is no term to measure what is left by.
        let zero = DMatrix::zeros(a.nrows(), a.ncols());
        if *q == zero && is_stable(&zero) {
            return Ok(Self { solution: zero, residual: 0.0 });
        }
        let mut solution = symmetric(by_sign(a, g, q)?);
        let mut residual = residual(a, g, q, &solution);
        if !is_stable(&solution) {
            return Err(RiccatiError::NotStabilizing);
        }
        for _ in 0..REFINEMENTS {
            let closed = a - g * &solution;
            let weight = q + &solution * g * &solution;
            let Some(better) = lyapunov(&closed, &weight) else { break };
            let left = self::residual(a, g, q, &better);
            let is_better = left < residual && is_stable(&better);
            if !is_better {
                break;
            }
            (solution, residual) = (better, left);
        }
        // A solution that is right to its last digits leaves a few units in the last place.
        if residual.is_finite() && residual < f64::EPSILON.sqrt() {
            Ok(Self { solution, residual })
        } else {
            Err(RiccatiError::NotStabilizing)
        }
    }
}

/// The solution from the sign S of the Hamiltonian matrix: `S [I; X] = -[I; X]`.
fn by_sign(a: &DMatrix<f64>, g: &DMatrix<f64>, q: &DMatrix<f64>) -> Result<DMatrix<f64>, RiccatiError> {
    let n = a.nrows();
    let mut hamiltonian = DMatrix::zeros(2 * n, 2 * n);
    for (at, block) in [((0, 0), a.clone()), ((0, n), -g), ((n, 0), -q), ((n, n), -a.transpose())] {
        hamiltonian.view_mut(at, (n, n)).copy_from(&block);
    }
    let sign = sign(hamiltonian)?;
    let identity = DMatrix::<f64>::identity(n, n);
    let block = |row: usize, column: usize| sign.view((row * n, column * n), (n, n)).into_owned();
    let (mut left, mut right) = (DMatrix::zeros(2 * n, n), DMatrix::zeros(2 * n, n));
    left.rows_mut(0, n).copy_from(&block(0, 1));
    left.rows_mut(n, n).copy_from(&(block(1, 1) + &identity));
    right.rows_mut(0, n).copy_from(&-(block(0, 0) + &identity));
    right.rows_mut(n, n).copy_from(&-block(1, 0));
    let orthogonal = left.qr();
    orthogonal.r().solve_upper_triangular(&(orthogonal.q().transpose() * right)).ok_or(RiccatiError::OnAxis)
}

/// The matrix sign function by Newton's method, each step scaled by the determinant; there is none where an eigenvalue is on the
/// imaginary axis, as far as rounding tells.
fn sign(mut z: DMatrix<f64>) -> Result<DMatrix<f64>, RiccatiError> {
    if !z.norm_squared().is_finite() {
        return Err(RiccatiError::OutOfRange);
    }
    let size = z.nrows() as f64;
    let mut is_near = false;
    for _ in 0..STEPS {
        let decomposed = z.clone().lu();
        let logarithm: f64 = decomposed.u().diagonal().iter().map(|pivot| pivot.abs().ln()).sum();
        // Near the limit, scaling would keep from it.
        let scale = if is_near { 1.0 } else { (-logarithm / size).exp() };
        let next = 0.5 * (scale * &z + decomposed.try_inverse().ok_or(RiccatiError::OnAxis)? / scale);
        let change = (&next - &z).norm() / next.norm();
        z = next;
        if !change.is_finite() {
            return Err(RiccatiError::OutOfRange);
        }
        if is_near && change < 1e-10 {
            return Ok(z);
        }
        is_near |= change < 1e-3;
    }
    Err(RiccatiError::OnAxis)
}

/// The symmetric X with `A' X + X A + W = 0`, for a symmetric W, as a system of linear equations for its entries on and above the
/// diagonal.
pub fn lyapunov(a: &DMatrix<f64>, w: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let n = a.nrows();
    let place = |row: usize, column: usize| {
        let (low, high) = (row.min(column), row.max(column));
        high * (high + 1) / 2 + low
    };
    let entries = n * (n + 1) / 2;
    let (mut system, mut right) = (DMatrix::zeros(entries, entries), DVector::zeros(entries));
    for column in 0..n {
        for row in 0..=column {
            let equation = place(row, column);
            right[equation] = -w[(row, column)];
            for k in 0..n {
                system[(equation, place(k, column))] += a[(k, row)];
                system[(equation, place(row, k))] += a[(k, column)];
            }
        }
    }
    let solved = system.lu().solve(&right)?;
    Some(DMatrix::from_fn(n, n, |row, column| solved[place(row, column)]))
}

fn residual(a: &DMatrix<f64>, g: &DMatrix<f64>, q: &DMatrix<f64>, x: &DMatrix<f64>) -> f64 {
    let (linear, square) = (a.transpose() * x, x * g * x);
    let left = &linear + linear.transpose() - &square + q;
    left.norm() / (2.0 * linear.norm() + square.norm() + q.norm())
}

fn symmetric(x: DMatrix<f64>) -> DMatrix<f64> {
    0.5 * (&x + x.transpose())
}
