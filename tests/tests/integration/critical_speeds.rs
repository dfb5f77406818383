//! Critical speeds of all bicycles against a table that was found in another way, and of random designs against signs.

use carvallo::{Coefficients, CriticalSpeed, Model, Stability};
use carvallo_compare::Real;
use carvallo_tests::published::CRITICAL_SPEEDS_2007;
use carvallo_tests::quartic::characteristic_at;
use carvallo_tests::roots::Signature;
use carvallo_tests::{bicycles, designs, facts};
use proptest::prelude::*;

/// The table ends here.
const LAST: f64 = 60.0;

fn found(bicycle: &str) -> Vec<CriticalSpeed> {
    let bicycle = bicycles::named(bicycle);
    let stability = Stability::new(&bicycle.coefficients(), bicycle.g).unwrap();
    stability.critical_speeds.into_iter().filter(|critical| critical.speed <= LAST).collect()
}

/// Runs a check on every critical speed that should be found with the one that is.
fn on_each(check: impl Fn(&facts::CriticalSpeed, &CriticalSpeed)) {
    let expected = facts::critical_speeds();
    for (name, _) in bicycles::all() {
        let expected: Vec<_> = expected.iter().filter(|critical| critical.bicycle == name).collect();
        let found = found(name);
        assert_eq!(found.len(), expected.len(), "{name}: {found:#?}");
        for (expected, found) in expected.into_iter().zip(&found) {
            check(expected, found);
        }
    }
}

#[test]
fn none_is_lost_or_invented_and_each_is_of_its_kind() {
    on_each(|expected, found| {
        assert_eq!(found.kind.to_string(), expected.kind, "{expected:?}");
        assert_eq!(found.change.to_string(), expected.change, "{expected:?}");
    });
}

#[test]
fn they_are_good_to_thirteen_digits() {
    on_each(|expected, found| {
        let off = (found.speed - expected.speed).abs();
        assert!(off <= 1e-13 * expected.speed, "{expected:?} is off by {off:e}");
    });
}

/// Fails unless the kinds of eigenvalues change within the estimated error of each critical speed, and that is small.
fn check_errors(coefficients: &Coefficients<f64, 2>, gravity: f64, small: f64) -> Result<(), TestCaseError> {
    for critical in Stability::new(coefficients, gravity).unwrap().critical_speeds {
        let (speed, error) = (Real::from(critical.speed), Real::from(critical.error));
        let signature = |speed| Signature::of(characteristic_at(coefficients, gravity, speed));
        prop_assert!(critical.error <= small * critical.speed, "{:?}", critical);
        prop_assert!(signature(speed - error) != signature(speed + error), "{:?}", critical);
    }
    Ok(())
}

#[test]
fn their_errors_are_as_estimated() {
    for (name, bicycle) in bicycles::all() {
        check_errors(&bicycle.coefficients(), bicycle.g, 1e-12).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

proptest! {
    #![proptest_config(designs::config(60))]

    #[test]
    fn their_errors_are_as_estimated_on_random_designs(design in designs::regular()) {
        // Some designs have critical speeds that hardly any digit of a coefficient determines.
        check_errors(&design.coefficients(), design.g, 1e-6)?;
    }
}

#[test]
fn the_critical_eigenvalue_comes_with_them() {
    on_each(|expected, found| {
        let off = (found.eigenvalue - expected.eigenvalue).norm();
        assert!(off <= 1e-12 * expected.eigenvalue.norm(), "{expected:?}: {}", found.eigenvalue);
    });
}

#[test]
fn the_benchmark_has_the_published_ones() {
    let found = found("benchmark");
    assert_eq!(found.len(), CRITICAL_SPEEDS_2007.len());
    for (published, found) in CRITICAL_SPEEDS_2007.iter().zip(found) {
        // A unit of the last printed digit (exactly, capsize is at 6.02426201538835889), and a rounding.
        assert!((found.speed - published).abs() <= 1e-14 + 4.0 * f64::EPSILON * published, "{found:?}");
    }
}
