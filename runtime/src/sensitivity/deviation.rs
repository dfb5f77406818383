//! How measured standard deviations of parameters propagate.

use super::Sensitivity;
use super::covariance::Covariance;
use super::error::SensitivityError;
use crate::system::{Coefficients, MatrixName, SystemError};

/// The standard deviation of a quantity to first order, from its derivatives with respect to each parameter and the standard
/// deviations of the parameters, which are taken to be independent: the root of the sum of the squares of their products.
///
/// ```
/// assert_eq!(carvallo::standard_deviation(&[3.0, -40.0, 7.0], &[1.0, 0.1, 0.0])?, 5.0);
/// # Ok::<(), carvallo::SensitivityError>(())
/// ```
///
/// # Errors
/// If there are fewer deviations than derivatives, or if one is negative or not finite, or if the
/// result leaves the range of `f64`.
pub fn standard_deviation(derivatives: &[f64], deviations: &[f64]) -> Result<f64, SensitivityError> {
    require(derivatives.len(), deviations)?;
    in_range(root_sum_square(derivatives.iter().zip(deviations).map(|(derivative, deviation)| derivative * deviation)))
}

/// The share of the variance of a quantity that comes from each parameter, from its derivatives with respect to each and
/// the standard deviations of the parameters, which are taken to be independent. They sum to one; all are zero if there is
/// no variance.
///
/// ```
/// let shares = carvallo::variance_shares(&[3.0, -40.0, 7.0], &[1.0, 0.1, 0.0])?;
/// assert!((shares[0] - 0.36).abs() < 1e-15 && (shares[1] - 0.64).abs() < 1e-15 && shares[2] == 0.0);
/// # Ok::<(), carvallo::SensitivityError>(())
/// ```
///
/// # Errors
/// As [`standard_deviation`].
pub fn variance_shares(derivatives: &[f64], deviations: &[f64]) -> Result<Vec<f64>, SensitivityError> {
    let total = standard_deviation(derivatives, deviations)?;
    let share = |(by, deviation): (&f64, &f64)| if total > 0.0 { (by * (deviation / total)).powi(2) } else { 0.0 };
    Ok(derivatives.iter().zip(deviations).map(share).collect())
}

impl<const N: usize> Sensitivity<N> {
    /// The standard deviation of every entry of the matrices to first order, in the unit of the entry, from those of the
    /// parameters in their order, which are taken to be independent. The entries themselves are not: they vary together.
    ///
    /// K0 is without gravity, as the coefficients are.
    ///
    /// # Errors
    /// If there are fewer deviations than parameters, or if one is negative or not finite, or if a
    /// result leaves the range of `f64`.
    pub fn matrix_deviations(&self, deviations: &[f64]) -> Result<Coefficients<f64, N>, SensitivityError> {
        require(self.derivatives.len(), deviations)?;
        self.each_entry(&|by| {
            in_range(root_sum_square(by.zip(deviations).map(|(derivative, deviation)| derivative * deviation)))
        })
    }

    /// The same for parameters that vary together.
    ///
    /// # Errors
    /// If there are fewer parameters there than here, or if a result leaves the range of `f64`.
    pub fn correlated_matrix_deviations(
        &self,
        covariance: &Covariance,
    ) -> Result<Coefficients<f64, N>, SensitivityError> {
        self.each_entry(&|by| covariance.standard_deviation(&by.collect::<Vec<f64>>()))
    }

    /// What is made of the derivatives of each entry of the matrices with respect to each parameter.
    fn each_entry(
        &self,
        make: &dyn Fn(&mut dyn Iterator<Item = f64>) -> Result<f64, SensitivityError>,
    ) -> Result<Coefficients<f64, N>, SensitivityError> {
        let mut made = Coefficients { states: self.coefficients.states, ..Default::default() };
        for name in MatrixName::ALL {
            for (place, entry) in made.matrix_mut(name).as_mut_slice().iter_mut().enumerate() {
                *entry = make(&mut self.derivatives.iter().map(|by| by.matrix(name).as_slice()[place]))?;
            }
        }
        Ok(made)
    }
}

pub(super) fn in_range(deviation: f64) -> Result<f64, SensitivityError> {
    if deviation.is_finite() {
        Ok(deviation)
    } else {
        Err(SystemError::OutOfRange { quantity: "a standard deviation" }.into())
    }
}

pub(super) fn require(parameters: usize, deviations: &[f64]) -> Result<(), SensitivityError> {
    let (expected, found) = (parameters, deviations.len());
    if found < expected {
        return Err(SensitivityError::TooFew { quantity: "standard deviations", expected, found });
    }
    match deviations.iter().find(|deviation| !(deviation.is_finite() && **deviation >= 0.0)) {
        Some(&value) => Err(SensitivityError::NotADeviation { value }),
        None => Ok(()),
    }
}

/// Without overflow of the squares.
pub(super) fn root_sum_square(terms: impl Iterator<Item = f64>) -> f64 {
    terms.fold(0.0, f64::hypot)
}

#[cfg(test)]
mod tests {
    use super::standard_deviation;
    use crate::sensitivity::SensitivityError;

    #[test]
    fn squares_stay_in_range() {
        let large = standard_deviation(&[3e200, 4e200], &[1.0, 1.0]).unwrap();
        assert!((large / 5e200 - 1.0).abs() < 1e-15);
        assert_eq!(standard_deviation(&[], &[]), Ok(0.0));
    }

    #[test]
    fn errors_name_what_is_wrong() {
        let too_few = SensitivityError::TooFew { quantity: "standard deviations", expected: 2, found: 1 };
        assert_eq!(standard_deviation(&[1.0, 2.0], &[1.0]), Err(too_few));
        assert_eq!(standard_deviation(&[1.0], &[-1.0]), Err(SensitivityError::NotADeviation { value: -1.0 }));
        assert!(standard_deviation(&[1.0], &[f64::NAN]).is_err());
    }
}
