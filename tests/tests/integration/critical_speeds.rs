//! Critical speeds of all bicycles against a table that was found in another way.

use carvallo::{CriticalSpeed, Model, Stability};
use carvallo_tests::bicycles;
use carvallo_tests::facts;
use carvallo_tests::published::CRITICAL_SPEEDS_2007;

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

#[test]
fn their_errors_are_estimated_and_small() {
    on_each(|expected, found| {
        // What the parameters' own rounding to `f64` does to a critical speed is no error of the method.
        let off = (found.speed - expected.speed).abs() - 4.0 * f64::EPSILON * expected.speed;
        assert!(off <= found.error, "{expected:?}: off by {off:e}, estimated {:e}", found.error);
        assert!(found.error <= 1e-12 * expected.speed, "{expected:?}: estimated {:e}", found.error);
    });
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
        // Half a unit of the last printed digit, and a rounding.
        assert!((found.speed - published).abs() <= 5e-15 + 4.0 * f64::EPSILON * published, "{found:?}");
    }
}
