//! How equations of motion change with the parameters.

use std::fmt::Debug;

use carvallo::{Covariance, CriticalDerivative, CriticalSpeed, Sensitivity, SensitivityError, SystemError};

use super::equations::Equations;

/// How the equations of motion change with the parameters, for any number of coordinates.
pub trait Sensitive: Debug {
    /// The derivatives of a critical speed.
    ///
    /// # Errors
    /// If one leaves the range of doubles.
    fn critical_speed(&self, critical: &CriticalSpeed) -> Result<CriticalDerivative, SystemError>;

    /// The derivatives of M, C and K at a speed in m/s with respect to a parameter, by its position, row by row.
    ///
    /// # Errors
    /// If an entry is not finite, as at rest with a derivative of C-1.
    fn system(&self, parameter: usize, speed: f64) -> Result<[Vec<f64>; 3], SystemError>;

    /// The standard deviations of the entries of the matrices, from those of the parameters in their order.
    ///
    /// # Errors
    /// If one leaves the range of doubles.
    fn matrix_deviations(&self, deviations: &[f64]) -> Result<Box<dyn Equations>, SensitivityError>;

    /// The same for parameters that vary together.
    ///
    /// # Errors
    /// If one leaves the range of doubles.
    fn correlated_matrix_deviations(&self, covariance: &Covariance) -> Result<Box<dyn Equations>, SensitivityError>;
}

impl<const N: usize> Sensitive for Sensitivity<N> {
    fn critical_speed(&self, critical: &CriticalSpeed) -> Result<CriticalDerivative, SystemError> {
        Sensitivity::critical_speed(self, critical)
    }

    fn system(&self, parameter: usize, speed: f64) -> Result<[Vec<f64>; 3], SystemError> {
        let matrices = Sensitivity::system(self, parameter, speed)?;
        Ok(matrices.map(|matrix| matrix.transpose().as_slice().to_vec()))
    }

    fn matrix_deviations(&self, deviations: &[f64]) -> Result<Box<dyn Equations>, SensitivityError> {
        Ok(Box::new(Sensitivity::matrix_deviations(self, deviations)?))
    }

    fn correlated_matrix_deviations(&self, covariance: &Covariance) -> Result<Box<dyn Equations>, SensitivityError> {
        Ok(Box::new(Sensitivity::correlated_matrix_deviations(self, covariance)?))
    }
}
