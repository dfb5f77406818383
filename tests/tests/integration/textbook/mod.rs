//! The mechanisms of books and papers, held against what else is known of them.

mod disc;
mod pendulum;
mod rider;
mod skateboard;
mod tyres;

use carvallo::{Coefficients, Matrix};

const G: f64 = 9.81;

/// Fails if an entry is off by more than 4 epsilons of the largest entry.
fn same<const N: usize>(found: Matrix<f64, N>, expected: Matrix<f64, N>, what: &str) {
    let off = (found - expected).amax();
    assert!(off <= 4.0 * f64::EPSILON * expected.amax(), "{what} is {found} instead of {expected}");
}

fn largest_real_part<const N: usize>(coefficients: &Coefficients<f64, N>, speed: f64) -> f64 {
    let eigenvalues = coefficients.at(speed, G).unwrap().eigenvalues().unwrap();
    eigenvalues.iter().map(|value| value.re).fold(f64::NEG_INFINITY, f64::max)
}
