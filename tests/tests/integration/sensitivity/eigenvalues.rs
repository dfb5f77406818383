//! Derivatives of eigenvalues.

use carvallo::{CriticalDerivative, CriticalKind, EigenvalueDerivative, Model, Stability};
use carvallo_models::Whipple;
use carvallo_tests::differences::Exact;
use carvallo_tests::{bicycles, designs};

use super::{name, sensitivity};

/// Fails unless all eigenvalues at a speed are simple and have the derivatives of exact ones, to as many digits as their
/// condition leaves.
fn check(label: &str, design: &Whipple, speed: f64) {
    let (exact, sensitivity) = (Exact::of(design), sensitivity(design));
    for found in sensitivity.eigenvalues(speed).unwrap() {
        let EigenvalueDerivative::Simple { gradient, condition } = &found.derivative else {
            panic!("{label} at {speed}: {found:?}")
        };
        let derivatives = std::iter::once((None, gradient.speed));
        let derivatives = derivatives.chain(gradient.parameters.iter().enumerate().map(|(i, &d)| (Some(i), d)));
        for (parameter, derivative) in derivatives {
            let expected = exact.eigenvalue_derivative(speed, found.value, parameter);
            let (off, allowed) = ((derivative - expected).norm() / expected.norm(), 16.0 * f64::EPSILON * condition);
            let what = format!("{label}, {} at {speed} by {}", found.value, parameter.map_or("v", name));
            // Terms that cancel in the derivative of a parameter cost digits as well.
            let is_good = expected == derivative || off <= allowed.max(1e-11);
            assert!(is_good, "{what}: {derivative} is not {expected} ({off:e} {condition:e})");
        }
    }
}

#[test]
fn simple_ones_have_as_many_digits_as_their_condition_leaves() {
    for (label, bicycle) in bicycles::all() {
        for speed in [0.3, 4.0] {
            check(label, &bicycle, speed);
        }
    }
    for number in 0..4 {
        check(&format!("design {number}"), &designs::numbered(number), 3.0);
    }
}

/// From ten nanometres per second to a centimetre per second beside the double-root speed.
#[test]
fn digits_are_lost_near_double_roots_as_told() {
    let bicycle = bicycles::named("benchmark");
    for distance in [1e-2, 1e-5, 1e-8] {
        for speed in [0.684_283_078_892_455_8 - distance, 0.684_283_078_892_455_8 + distance] {
            check("benchmark", &bicycle, speed);
        }
    }
}

/// Along the double-root speed the two stay together: the square of half their difference stays zero, and their mean is
/// the eigenvalue that goes with the speed.
#[test]
fn at_double_roots_mean_and_square_agree_with_the_critical_speed() {
    let mut checked = 0;
    for (label, bicycle) in bicycles::all() {
        let (exact, sensitivity) = (Exact::of(&bicycle), sensitivity(&bicycle));
        for critical in Stability::new(&bicycle.coefficients(), bicycle.g).unwrap().critical_speeds {
            if critical.kind != CriticalKind::DoubleRoot {
                continue;
            }
            let at = exact.critical(critical.kind, critical.speed.into(), critical.eigenvalue);
            let all = sensitivity.eigenvalues(critical.speed).unwrap();
            let doubles = all.iter().filter_map(|found| match &found.derivative {
                EigenvalueDerivative::Double { mean, square } => Some((mean, square)),
                _ => None,
            });
            let doubles: Vec<_> = doubles.collect();
            assert_eq!(doubles.len(), 2, "{label}: {critical:?}: {all:#?}");
            for (mean, square) in doubles {
                for parameter in 0..26 {
                    let (speed, eigenvalue) = exact.critical_derivative(critical.kind, &at, parameter);
                    let (found, rest) = (square.parameters[parameter], square.speed * speed);
                    let what = format!("{label}: {critical:?} by {}", name(parameter));
                    assert!((found + rest).norm() <= 1e-9 * rest.norm(), "{what}: {found} is not {}", -rest);
                    let (found, expected) = (mean.parameters[parameter] + mean.speed * speed, eigenvalue);
                    let size = (mean.speed * speed).norm().max(expected.norm());
                    assert!((found - expected).norm() <= 1e-9 * size, "{what}: {found} is not {expected}");
                    checked += 1;
                }
            }
            let smooth = sensitivity.critical_speed(&critical).unwrap();
            assert!(matches!(smooth, CriticalDerivative::Smooth { .. }), "{label}: {critical:?}");
        }
    }
    assert!(checked > 1000, "{checked}");
}
