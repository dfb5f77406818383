//! How eigenvalues and critical speeds change with the speed and with the parameters of a model.

mod condition;
mod covariance;
mod critical;
mod deviation;
mod eigenvalue;
mod error;
mod implicit;
mod null_vectors;
mod pencil;
mod quartic;
mod scaled;
#[cfg(test)]
mod tests;
mod uncertain;
mod unfolding;

use pencil::Direction;

use crate::model::{Differentiable, Model};
use crate::number::Scalar;
use crate::system::require_finite;
use crate::system::{Coefficients, Matrix, SystemError};

pub use covariance::Covariance;
pub use critical::{CriticalDerivative, NotDifferentiable};
pub use deviation::{standard_deviation, variance_shares};
pub use eigenvalue::{EigenvalueDerivative, EigenvalueSensitivity};
pub use error::SensitivityError;
pub use uncertain::{Sources, Uncertain};

/// The derivatives of a quantity with respect to the forward speed and to each parameter.
///
/// Each is in the unit of the quantity divided by m/s, or by the unit of the parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Gradient<T> {
    /// With respect to the forward speed.
    pub speed: T,
    /// With respect to each parameter, in the order in which the derivatives of the matrices were given.
    pub parameters: Vec<T>,
}

/// The coefficient matrices of a model together with their derivatives: what is needed to tell how eigenvalues
/// ([`eigenvalues`](Self::eigenvalues)) and critical speeds ([`critical_speed`](Sensitivity::critical_speed)) change with
/// each parameter.
///
/// Nothing is differenced. An eigenvalue s of the quadratic eigenvalue problem `(s^2 M + s C + K) x = 0` with the right
/// eigenvector x and the left one y changes by
///
/// ```text
/// ds = - y^H (s^2 dM + s dC + dK) x / y^H (2 s M + C) x
/// ```
///
/// (Lancaster 1964; Tisseur 2000), and a critical speed by implicit differentiation of the condition that defines it.
///
/// The gravity parameter, if the model has one, changes K = Kc + g K0 + v^2 K2 also through its factor g: say which one it
/// is, and it is taken into account.
///
/// ```
/// use carvallo::{Coefficients, CriticalDerivative, Sensitivity, Stability};
///
/// // q1'' + q1' + (p - v^2) q1 = 0 capsizes at v = sqrt(p), and q2'' + q2' + q2 = 0 never does.
/// let zero = [[0.0; 2]; 2];
/// let one = [[1.0, 0.0], [0.0, 1.0]];
/// let with = |p: f64| [[p, 0.0], [0.0, 1.0]];
/// let k2 = [[-1.0, 0.0], [0.0, 0.0]];
/// let coefficients = Coefficients::from_rows([one, zero, one, zero, with(9.0), zero, zero, k2]);
/// let by_p = Coefficients::from_rows([zero, zero, zero, zero, [[1.0, 0.0], [0.0, 0.0]], zero, zero, zero]);
///
/// let sensitivity = Sensitivity::new(&coefficients, &[by_p], 0.0, None)?;
/// let stability = Stability::new(&coefficients, 0.0)?;
/// let capsize = stability.critical_speeds.last().unwrap();
/// let CriticalDerivative::Smooth { speed, .. } = sensitivity.critical_speed(capsize)? else { panic!("smooth") };
/// assert!((capsize.speed - 3.0).abs() < 1e-15);
/// assert!((speed[0] - 1.0 / 6.0).abs() < 1e-15);
/// # Ok::<(), carvallo::SensitivityError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity<const N: usize> {
    coefficients: Coefficients<f64, N>,
    derivatives: Vec<Coefficients<f64, N>>,
    /// What is not zero of the derivatives of two coordinates, one after the other, and where each begins and ends.
    changes: Vec<Change>,
    ends: Vec<usize>,
    gravity: f64,
    gravity_parameter: Option<usize>,
}

impl<const N: usize> Sensitivity<N> {
    /// From the coefficient matrices, their derivatives with respect to each parameter, and the gravitational field
    /// strength in N/kg, of which `gravity_parameter` tells the position among the parameters, if it is one.
    ///
    /// # Errors
    /// If gravity, an entry or a derivative is not finite, or if there is no parameter at the position of gravity.
    pub fn new<T: Scalar>(
        coefficients: &Coefficients<T, N>,
        derivatives: &[Coefficients<T, N>],
        gravity: f64,
        gravity_parameter: Option<usize>,
    ) -> Result<Self, SensitivityError> {
        require_finite("gravity", gravity)?;
        if let Some(position) = gravity_parameter.filter(|&position| position >= derivatives.len()) {
            let (expected, found) = (position + 1, derivatives.len());
            return Err(SensitivityError::TooFew { quantity: "derivatives", expected, found });
        }
        let coefficients = coefficients.widen();
        coefficients.require_finite()?;
        let derivatives: Vec<_> = derivatives.iter().map(Coefficients::widen).collect();
        if !derivatives.iter().all(is_finite) {
            return Err(SystemError::OutOfRange { quantity: "a derivative of a matrix" }.into());
        }
        let (mut changes, mut ends) = (Vec::new(), Vec::new());
        if N == 2 {
            changes.reserve(8 * derivatives.len());
            ends.reserve(derivatives.len());
            for derivative in &derivatives {
                add_changes(derivative, &mut changes);
                ends.push(changes.len());
            }
        }
        Ok(Self { coefficients, derivatives, changes, ends, gravity, gravity_parameter })
    }

    /// Of a model that was compiled with its derivatives, at its own gravity; at none if that is no parameter of it.
    ///
    /// # Errors
    /// If an entry or a derivative is not finite, as they may be for parameters that were not validated.
    pub fn of<M: Differentiable<N>>(model: &M) -> Result<Self, SensitivityError> {
        Self::of_any(model)
    }

    /// The same for any model, where only the program that runs finds out whether it has derivatives.
    ///
    /// # Errors
    /// If the model was compiled without derivatives, and those of [`of`](Self::of).
    pub fn of_any<M: Model<N>>(model: &M) -> Result<Self, SensitivityError> {
        let without = SensitivityError::WithoutDerivatives { model: M::INFO.name };
        let (coefficients, derivatives) = Model::derivatives(model).ok_or(without)?;
        let gravity = Model::gravity(model).map_or(0.0, Scalar::to_f64);
        Self::new(&coefficients, derivatives.as_ref(), gravity, M::INFO.gravity)
    }

    /// The derivatives of M, C and K of [`Coefficients::at`] a speed in m/s with respect to a parameter, by its position.
    ///
    /// # Errors
    /// If an entry is not finite, as at rest with a derivative of C-1.
    ///
    /// # Panics
    /// If there is no such parameter.
    pub fn system(&self, parameter: usize, speed: f64) -> Result<[Matrix<f64, N>; 3], SystemError> {
        let Direction { m, c, k } = self.direction(parameter, speed)?;
        Ok([m, c, k])
    }

    /// The derivatives of the equations of motion at a speed: with respect to it, and then to each parameter.
    fn directions(&self, speed: f64) -> Result<Vec<Direction<N>>, SystemError> {
        let Coefficients { cm1, c1, k1, k2, .. } = self.coefficients;
        let over_speed = cm1.map(|entry| if entry == 0.0 { entry } else { entry / speed / speed });
        let by_speed = Direction { m: nalgebra::SMatrix::zeros(), c: c1 - over_speed, k: k1 + k2 * speed * 2.0 };
        let parameters = (0..self.derivatives.len()).map(|index| self.direction(index, speed));
        core::iter::once(by_speed.finite()).chain(parameters).collect()
    }

    /// The derivative of the equations of motion at a speed with respect to a parameter.
    fn direction(&self, parameter: usize, speed: f64) -> Result<Direction<N>, SystemError> {
        let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, states: _ } = self.derivatives[parameter];
        let over_speed = cm1.map(|entry| if entry == 0.0 { entry } else { entry / speed });
        let mut k = kc + k0 * self.gravity + k1 * speed + k2 * speed * speed;
        if self.gravity_parameter == Some(parameter) {
            k += self.coefficients.k0;
        }
        Direction { m, c: over_speed + c0 + c1 * speed, k }.finite()
    }
}

/// A derivative of an entry of a coefficient matrix that is not zero.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Change {
    /// The place of the entry, column by column, in all matrices one after the other, in the order of
    /// [`MatrixName::ALL`](crate::MatrixName::ALL).
    place: usize,
    value: f64,
}

/// All matrices, in the order of [`MatrixName::ALL`](crate::MatrixName::ALL).
fn matrices<const N: usize>(coefficients: &Coefficients<f64, N>) -> [&Matrix<f64, N>; 8] {
    let Coefficients { m, cm1, c0, c1, kc, k0, k1, k2, states: _ } = coefficients;
    [m, cm1, c0, c1, kc, k0, k1, k2]
}

/// Whether all entries are finite, without a branch for each.
fn is_finite<const N: usize>(coefficients: &Coefficients<f64, N>) -> bool {
    // Sums of zeros, and of what is no zero where an entry is not finite: those of a place in all matrices side by side.
    let sums = matrices(coefficients).into_iter().fold(Matrix::<f64, N>::zeros(), |sums, matrix| sums + matrix * 0.0);
    sums.as_slice().iter().fold(true, |all, sum| all & (*sum == 0.0))
}

/// Adds what changes with a parameter: of most entries nothing.
fn add_changes<const N: usize>(derivative: &Coefficients<f64, N>, changes: &mut Vec<Change>) {
    for (which, matrix) in matrices(derivative).into_iter().enumerate() {
        let entries = matrix.as_slice();
        // One question for most of the matrices, and not one for each entry; without the signs.
        if entries.iter().fold(0, |bits, entry| bits | entry.to_bits()) << 1 == 0 {
            continue;
        }
        for (entry, &value) in entries.iter().enumerate() {
            if value != 0.0 {
                changes.push(Change { place: N * N * which + entry, value });
            }
        }
    }
}
