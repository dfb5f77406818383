//! How measured parameters vary together.

use super::deviation::{in_range, require, root_sum_square};
use super::error::SensitivityError;

/// How the measurements of parameters vary together: each deviation from its mean is a sum of parts, of which each comes from a
/// source of its own, independent of the others and of unit variance.
///
/// The covariance of two parameters is the sum of the products of their parts. Kept as parts, no variance can be negative.
#[derive(Clone, Debug, PartialEq)]
pub struct Covariance {
    /// For each parameter, its parts; what is missing at the end is zero.
    parts: Vec<Vec<f64>>,
}

impl Covariance {
    /// Of parameters that vary each by itself, with these standard deviations.
    ///
    /// # Errors
    /// If one is negative or not finite.
    pub fn independent(deviations: &[f64]) -> Result<Self, SensitivityError> {
        require(0, deviations)?;
        let part = |(index, &deviation): (usize, &f64)| {
            let mut parts = vec![0.0; index + 1];
            parts[index] = deviation;
            parts
        };
        Ok(Self { parts: deviations.iter().enumerate().map(part).collect() })
    }

    /// Of parameters by their parts, one row for each, which may be of different lengths.
    ///
    /// # Errors
    /// If one is not finite.
    pub fn of_parts(parts: Vec<Vec<f64>>) -> Result<Self, SensitivityError> {
        match parts.iter().flatten().find(|part| !part.is_finite()) {
            Some(&value) => Err(SensitivityError::NotADeviation { value }),
            None => Ok(Self { parts }),
        }
    }

    /// Of parameters with these standard deviations, and these correlations between pairs of them, each by the positions of
    /// the two; all others are zero. It is the factor of Cholesky of their matrix.
    ///
    /// ```
    /// use carvallo::Covariance;
    ///
    /// // The sum of two parameters that move against each other varies less than either.
    /// let covariance = Covariance::of_correlations(&[3.0, 4.0], &[(0, 1, -0.8)])?;
    /// assert!((covariance.standard_deviation(&[1.0, 1.0])? - 5.8_f64.sqrt()).abs() < 1e-15);
    /// # Ok::<(), carvallo::SensitivityError>(())
    /// ```
    ///
    /// # Errors
    /// If a deviation is negative or not finite, or if no parameters can be correlated so.
    ///
    /// # Panics
    /// If a position is beyond the deviations.
    pub fn of_correlations(deviations: &[f64], correlations: &[(usize, usize, f64)]) -> Result<Self, SensitivityError> {
        let mut parts = Self::independent(deviations)?.parts;
        let count = deviations.len();
        let mut matrix = vec![vec![0.0; count]; count];
        for (index, row) in matrix.iter_mut().enumerate() {
            row[index] = 1.0;
        }
        for &(first, second, correlation) in correlations {
            matrix[first][second] = correlation;
            matrix[second][first] = correlation;
        }
        // The factor of the correlations, row by row; a row of which nothing of its own is left adds no source.
        let mut factor: Vec<Vec<f64>> = Vec::new();
        for row in 0..count {
            let mut own = vec![0.0; row + 1];
            for column in 0..row {
                let known: f64 = own[..column].iter().zip(&factor[column]).map(|(a, b)| a * b).sum();
                let rest = matrix[row][column] - known;
                let pivot = factor[column][column];
                if pivot > 0.0 {
                    own[column] = rest / pivot;
                } else if rest.abs() > ROUNDING.sqrt() {
                    return Err(SensitivityError::NotCorrelations { parameter: row });
                }
            }
            let rest = 1.0 - own.iter().map(|part| part * part).sum::<f64>();
            if rest.is_nan() || rest < -ROUNDING {
                return Err(SensitivityError::NotCorrelations { parameter: row });
            }
            own[row] = if rest > ROUNDING { rest.sqrt() } else { 0.0 };
            factor.push(own);
        }
        for ((parts, factor), deviation) in parts.iter_mut().zip(factor).zip(deviations) {
            *parts = factor.into_iter().map(|part| part * deviation).collect();
        }
        Ok(Self { parts })
    }

    /// The parts of each parameter.
    pub fn parts(&self) -> &[Vec<f64>] {
        &self.parts
    }

    /// The standard deviation of each parameter.
    pub fn deviations(&self) -> Vec<f64> {
        self.parts.iter().map(|parts| root_sum_square(parts.iter().copied())).collect()
    }

    /// The correlation of two parameters, by their positions: between -1 and 1, and 0 where one of them does not vary.
    pub fn correlation(&self, first: usize, second: usize) -> f64 {
        let [a, b] = [first, second].map(|index| &self.parts[index]);
        let [size_a, size_b] = [a, b].map(|parts| root_sum_square(parts.iter().copied()));
        if size_a == 0.0 || size_b == 0.0 {
            return 0.0;
        }
        a.iter().zip(b).map(|(a, b)| (a / size_a) * (b / size_b)).sum::<f64>().clamp(-1.0, 1.0)
    }

    /// The pairs of parameters that vary together, each by the positions of the two, the second one less than the first, with
    /// their correlation; what rounding leaves of none is left out.
    pub fn correlations(&self) -> Vec<(usize, usize, f64)> {
        let pairs = (0..self.parts.len()).flat_map(|first| (0..first).map(move |second| (first, second)));
        let all = pairs.map(|(first, second)| (first, second, self.correlation(first, second)));
        all.filter(|(.., correlation)| correlation.abs() > ROUNDING).collect()
    }

    /// The standard deviation of a quantity to first order, from its derivatives with respect to each parameter.
    ///
    /// # Errors
    /// If there are fewer parameters here than derivatives, or if the result leaves the range of `f64`.
    pub fn standard_deviation(&self, derivatives: &[f64]) -> Result<f64, SensitivityError> {
        in_range(root_sum_square(self.propagated(derivatives)?.into_iter()))
    }

    /// The share of the variance of a quantity that comes from each parameter, from its derivatives with respect to each: half
    /// of what two share belongs to each of them, so that a share is negative where the parameter makes up for others. They
    /// sum to one; all are zero if there is no variance.
    ///
    /// # Errors
    /// As [`standard_deviation`](Self::standard_deviation).
    pub fn variance_shares(&self, derivatives: &[f64]) -> Result<Vec<f64>, SensitivityError> {
        let sum = self.propagated(derivatives)?;
        let total = in_range(root_sum_square(sum.iter().copied()))?;
        let share = |(by, parts): (&f64, &Vec<f64>)| {
            if total == 0.0 {
                return 0.0;
            }
            parts.iter().zip(&sum).map(|(part, sum)| (by * (part / total)) * (sum / total)).sum()
        };
        Ok(derivatives.iter().zip(&self.parts).map(share).collect())
    }

    /// The parts of a quantity.
    fn propagated(&self, derivatives: &[f64]) -> Result<Vec<f64>, SensitivityError> {
        let (expected, found) = (derivatives.len(), self.parts.len());
        if found < expected {
            return Err(SensitivityError::TooFew { quantity: "standard deviations", expected, found });
        }
        let mut sum = vec![0.0; self.parts.iter().map(Vec::len).max().unwrap_or(0)];
        for (by, parts) in derivatives.iter().zip(&self.parts) {
            for (sum, part) in sum.iter_mut().zip(parts) {
                *sum += by * part;
            }
        }
        Ok(sum)
    }
}

/// What rounding may leave where the variance of a parameter is all that of others, relative to it.
const ROUNDING: f64 = 1e-12;

#[cfg(test)]
mod tests {
    use super::Covariance;
    use crate::sensitivity::{SensitivityError, standard_deviation, variance_shares};

    /// Of three parameters of which the third is the sum of the first two: by hand, var = 1 + 4, and cov = 1 and 4.
    #[test]
    fn a_parameter_may_follow_from_others() {
        let sum = 5_f64.sqrt();
        let given = [(2, 0, 1.0 / sum), (2, 1, 2.0 / sum)];
        let covariance = Covariance::of_correlations(&[1.0, 2.0, sum], &given).unwrap();
        assert!(covariance.standard_deviation(&[1.0, 1.0, -1.0]).unwrap() < 1e-6);
        assert!((covariance.standard_deviation(&[1.0, 1.0, 1.0]).unwrap() - 2.0 * sum).abs() < 1e-12);
        let back = covariance.correlations();
        assert_eq!(back.len(), 2);
        for (found, given) in back.iter().zip(given) {
            assert!((found.2 - given.2).abs() < 1e-15 && (found.0, found.1) == (given.0, given.1));
        }
    }

    #[test]
    fn without_correlations_it_is_as_it_was() {
        let (by, deviations) = ([3.0, -40.0, 7.0], [1.0, 0.1, 0.0]);
        let covariance = Covariance::independent(&deviations).unwrap();
        assert_eq!(covariance.standard_deviation(&by), standard_deviation(&by, &deviations));
        let [shares, others] = [covariance.variance_shares(&by), variance_shares(&by, &deviations)].map(Result::unwrap);
        for (share, other) in shares.into_iter().zip(others) {
            assert!((share - other).abs() < 1e-15);
        }
        assert!(covariance.correlations().is_empty());
    }

    #[test]
    fn what_no_parameters_can_be_is_refused() {
        let contradiction = [(1, 0, 0.9), (2, 0, 0.9), (2, 1, -0.9)];
        let refused = Err(SensitivityError::NotCorrelations { parameter: 2 });
        assert_eq!(Covariance::of_correlations(&[1.0; 3], &contradiction), refused);
        let refused = Err(SensitivityError::NotCorrelations { parameter: 1 });
        for correlation in [1.1, -2.0, f64::NAN] {
            assert_eq!(Covariance::of_correlations(&[1.0; 2], &[(1, 0, correlation)]), refused);
        }
        assert!(Covariance::independent(&[-1.0]).is_err());
    }
}
