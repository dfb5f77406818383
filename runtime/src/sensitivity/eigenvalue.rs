//! The derivatives of eigenvalues.

use nalgebra::Complex;

use super::null_vectors::{NullVectors, find_null_vectors};
use super::pencil::{ComplexMatrix, Direction, Pencil, Weights};
use super::unfolding::{self, Neighbours};
use super::{Gradient, Sensitivity};
use crate::system::SystemError;

/// An eigenvalue and its derivatives.
#[derive(Clone, Debug, PartialEq)]
pub struct EigenvalueSensitivity {
    /// The eigenvalue in 1/s.
    pub value: Complex<f64>,
    /// How it changes.
    pub derivative: EigenvalueDerivative,
}

/// How an eigenvalue changes with the speed and with each parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum EigenvalueDerivative {
    /// The eigenvalue is apart from all others.
    Simple {
        /// Its derivatives, in 1/s per unit. That of the conjugate eigenvalue is the conjugate.
        gradient: Gradient<Complex<f64>>,
        /// How much of a relative rounding error of the matrix entries may reach the derivatives, relative to them:
        /// about `log10(condition)` of their digits are lost.
        ///
        /// It is the error of the eigenvalue s that such rounding leaves, or a larger one that its residual shows, in units
        /// of that rounding, times the sum of 1/|s - t| over all other eigenvalues t. It grows with the square as two of
        /// them come close. Units do not matter to it.
        condition: f64,
    },
    /// It coincides with another one as far as digits tell (a condition of 2^40 or more, so that fewer than about four
    /// digits of a derivative would be left), and with no third. Then it has no derivative: as a parameter changes, the two
    /// part like a square root. What has derivatives is their mean and the square of half their difference,
    ///
    /// ```text
    /// s = mean +- sqrt(square)
    /// ```
    Double {
        /// The derivatives of the mean, in 1/s per unit.
        mean: Gradient<Complex<f64>>,
        /// The derivatives of the square of half the difference, in 1/s^2 per unit. Where one is zero the two eigenvalues
        /// do not part at first order, as those of uncoupled coordinates do not.
        square: Gradient<Complex<f64>>,
    },
    /// Three or more coincide: nothing is told of their derivatives.
    Multiple,
}

/// From this condition on an eigenvalue counts as double.
pub(super) const DOUBLE: f64 = (1u64 << 40) as f64;

impl<const N: usize> Sensitivity<N> {
    /// The 2N eigenvalues at a speed in m/s, in the order of [`System::eigenvalues`](crate::System::eigenvalues), with
    /// their derivatives.
    ///
    /// # Errors
    /// If there are no eigenvalues, or if a derivative leaves the range of `f64`.
    pub fn eigenvalues(&self, speed: f64) -> Result<Vec<EigenvalueSensitivity>, SystemError> {
        let system = self.coefficients.at(speed, self.gravity)?;
        let values = system.eigenvalues()?;
        let pencil = Pencil::new(&system)?;
        let directions: Vec<_> = self.directions(speed)?.iter().map(|direction| pencil.scale(direction)).collect();
        let scaled: Vec<_> = values.iter().map(|&value| pencil.to_unit(value)).collect();
        let derivative = |index: usize| {
            let neighbours = Neighbours::of(&scaled, index);
            let (weights, condition) = find_simple_weights(&pencil, scaled[index], &neighbours);
            if condition < DOUBLE {
                let gradient = gradient(&pencil, &directions, &weights, 1)?;
                return Ok(EigenvalueDerivative::Simple { gradient, condition });
            }
            let Some([mean, square]) = unfolding::find_weights(&pencil, scaled[index], &neighbours) else {
                return Ok(EigenvalueDerivative::Multiple);
            };
            let [mean, square] = [(mean, 1), (square, 2)].map(|(w, power)| gradient(&pencil, &directions, &w, power));
            Ok(EigenvalueDerivative::Double { mean: mean?, square: square? })
        };
        let derivatives = (0..values.len()).map(derivative).collect::<Result<Vec<_>, SystemError>>()?;
        let both = values.into_iter().zip(derivatives);
        Ok(both.map(|(value, derivative)| EigenvalueSensitivity { value, derivative }).collect())
    }
}

/// What the directions are to be weighted with, and the condition of the result.
///
/// A step of Newton's iteration along the eigenvectors first takes the error out of the eigenvalue that it has beyond the
/// rounding of the matrix entries, unless another eigenvalue is near.
fn find_simple_weights<const N: usize>(
    pencil: &Pencil<N>,
    s: Complex<f64>,
    neighbours: &Neighbours,
) -> (Weights<N>, f64) {
    const SMALL: f64 = 1e-6;
    let mut found = Eigenvectors::new(pencil, s);
    let step = found.residual / found.slope;
    if step.norm() * neighbours.closeness <= SMALL {
        found = Eigenvectors::new(pencil, s - step);
    }
    let Eigenvectors { s, outer, slope, rounding, residual } = found;
    let error = rounding.max(residual.norm() / f64::EPSILON) / slope.norm();
    // Without a slope the eigenvalue is not simple, and the condition infinite or not a number.
    let condition = error * neighbours.closeness;
    let condition = if condition.is_nan() { f64::INFINITY } else { condition };
    (Weights::at(s, &outer.map(|weight| -weight / slope)), condition)
}

/// The left and right eigenvectors, and what they make of Q(s), of its slope, and of the rounding of its terms.
struct Eigenvectors<const N: usize> {
    s: Complex<f64>,
    /// The products of their entries.
    outer: ComplexMatrix<N>,
    slope: Complex<f64>,
    rounding: f64,
    residual: Complex<f64>,
}

impl<const N: usize> Eigenvectors<N> {
    fn new(pencil: &Pencil<N>, s: Complex<f64>) -> Self {
        let (matrix, size) = (pencil.at(s), pencil.size(s));
        let NullVectors { right, left } = find_null_vectors(&matrix, &size);
        let outer = left * right.transpose();
        Self {
            s,
            slope: outer.component_mul(&pencil.slope(s)).sum(),
            rounding: outer.map(|weight| weight.norm()).component_mul(&size).sum(),
            residual: outer.component_mul(&matrix).sum(),
            outer,
        }
    }
}

fn gradient<const N: usize>(
    pencil: &Pencil<N>,
    directions: &[Direction<N>],
    weights: &Weights<N>,
    power: i32,
) -> Result<Gradient<Complex<f64>>, SystemError> {
    let mut derivatives = directions.iter().map(|direction| pencil.per_second(weights.dot(direction), power));
    let speed = derivatives.next().unwrap_or(Ok(Complex::new(0.0, 0.0)))?;
    Ok(Gradient { speed, parameters: derivatives.collect::<Result<_, _>>()? })
}
