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

    fn matrix_deviations(&self, deviations: &[f64]) -> Result<Box<dyn Equations>, SensitivityError> {
        Ok(Box::new(Sensitivity::matrix_deviations(self, deviations)?))
    }

    fn correlated_matrix_deviations(&self, covariance: &Covariance) -> Result<Box<dyn Equations>, SensitivityError> {
        Ok(Box::new(Sensitivity::correlated_matrix_deviations(self, covariance)?))
    }
}
