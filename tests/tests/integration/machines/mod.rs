//! Shipped models of machines that are no bicycles, and of a bicycle with flywheels, against print, closed forms and second
//! derivations.

mod balancing;
mod flywheel;
mod motor;
mod pipe;
mod road_vehicles;
mod rotor;
mod section;
mod towed_wheel;
mod trailer;
mod wheelset;

use carvallo::{Coefficients, Complex, Matrix, Stability};

#[track_caller]
fn assert_near(found: f64, expected: f64, accuracy: f64) {
    assert!((found - expected).abs() <= accuracy * expected.abs(), "{found} where {expected} is expected");
}

/// Fails if an entry is off by more than some epsilons of the largest entry.
#[track_caller]
fn assert_same<const N: usize>(found: Matrix<f64, N>, expected: Matrix<f64, N>) {
    let off = (found - expected).amax();
    assert!(off <= 8.0 * f64::EPSILON * expected.amax(), "{found} instead of {expected}");
}

fn eigenvalues<const N: usize>(coefficients: &Coefficients<f64, N>, speed: f64, gravity: f64) -> Vec<Complex<f64>> {
    coefficients.at(speed, gravity).and_then(|system| system.eigenvalues()).expect("a regular system")
}

/// Critical speeds and the like of a model in which gravity has no part, with nothing undecided.
fn stability<const N: usize>(coefficients: &Coefficients<f64, N>) -> Stability {
    let stability = Stability::new(coefficients, 0.0).expect("an answer");
    assert!(stability.undecided.is_empty(), "{stability:?}");
    stability
}

/// Fails unless these are all of the eigenvalues, each as often as it is listed.
#[track_caller]
fn assert_eigenvalues(mut found: Vec<Complex<f64>>, expected: &[Complex<f64>], accuracy: f64) {
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for expected in expected {
        let distance = |value: &Complex<f64>| (value - expected).norm();
        let nearest = (0..found.len()).min_by(|&i, &j| distance(&found[i]).total_cmp(&distance(&found[j])));
        let nearest = found.swap_remove(nearest.expect("one that is left"));
        assert!(distance(&nearest) <= accuracy * expected.norm().max(1.0), "{nearest} where {expected} is expected");
    }
}
