//! Stable ranges and verdicts against signs of exact eigenvalues.

use carvallo::{Coefficients, Model, Stability, Verdict};
use carvallo_compare::Real;
use carvallo_tests::quartic::characteristic_at;
use carvallo_tests::roots::Signature;
use carvallo_tests::{bicycles, designs, facts};
use proptest::prelude::*;

fn signature(coefficients: &Coefficients<f64, 2>, gravity: f64, speed: f64) -> Signature {
    Signature::of(characteristic_at(coefficients, gravity, Real::from(speed)))
}

fn is_in_a_range(stability: &Stability, speed: f64) -> bool {
    stability.stable_ranges.iter().any(|range| range.from < speed && range.to.is_none_or(|to| speed < to))
}

/// Speeds between critical ones: three in each gap, and three beyond the last.
fn speeds_between(stability: &Stability) -> Vec<[f64; 3]> {
    let mut ends = vec![0.0];
    ends.extend(stability.critical_speeds.iter().map(|critical| critical.speed));
    ends.push(2.0 * ends[ends.len() - 1] + 10.0);
    // Not too near the ends, and at no round fractions of the gap.
    ends.windows(2).map(|gap| [0.013, 0.451, 0.971].map(|fraction| gap[0] + fraction * (gap[1] - gap[0]))).collect()
}

/// Fails unless the number of eigenvalues of each kind is the same throughout each gap, and the verdict is theirs.
fn check(coefficients: &Coefficients<f64, 2>, gravity: f64) -> Result<(), TestCaseError> {
    let stability = Stability::new(coefficients, gravity).unwrap();
    for speeds in speeds_between(&stability) {
        let signatures = speeds.map(|speed| signature(coefficients, gravity, speed));
        prop_assert_eq!(signatures, [signatures[0]; 3], "between {:?}: {:#?}", speeds, stability);
        for speed in speeds {
            let stable = signatures[0].is_stable();
            let verdict = if stable { Verdict::Stable } else { Verdict::Unstable };
            prop_assert_eq!(stability.verdict(speed).unwrap(), verdict, "at {}: {:#?}", speed, stability);
            prop_assert_eq!(is_in_a_range(&stability, speed), stable, "at {}: {:#?}", speed, stability);
        }
    }
    Ok(())
}

#[test]
fn every_bicycle_changes_at_critical_speeds_only() {
    for (name, bicycle) in bicycles::all() {
        check(&bicycle.coefficients(), bicycle.g).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

proptest! {
    #![proptest_config(designs::config(60))]

    #[test]
    fn random_designs_change_at_critical_speeds_only(design in designs::regular()) {
        check(&design.coefficients(), design.g)?;
    }

    #[test]
    fn a_verdict_is_that_of_the_eigenvalues(design in designs::regular(), speed in 0.1..30.0) {
        let coefficients = design.coefficients();
        let stable = signature(&coefficients, design.g, speed).is_stable();
        let verdict = Stability::new(&coefficients, design.g).unwrap().verdict(speed).unwrap();
        prop_assert_eq!(verdict, if stable { Verdict::Stable } else { Verdict::Unstable });
    }

    #[test]
    fn edge_designs_have_a_verdict_everywhere(design in designs::any(), speed in 0.0..30.0) {
        let coefficients = design.coefficients();
        let stability = Stability::new(&coefficients, design.g).unwrap();
        let verdict = stability.verdict(speed).unwrap();
        prop_assert_eq!(verdict == Verdict::Stable, is_in_a_range(&stability, speed), "{:#?}", stability);
        prop_assert!(stability.critical_speeds.iter().all(|critical| critical.speed.is_finite() && critical.speed >= 0.0));
    }
}

#[test]
fn stable_ranges_are_those_of_the_table() {
    let expected = facts::stable_ranges();
    for (name, bicycle) in bicycles::all() {
        let expected: Vec<_> = expected.iter().filter(|range| range.bicycle == name).collect();
        let found = Stability::new(&bicycle.coefficients(), bicycle.g).unwrap().stable_ranges;
        assert_eq!(found.len(), expected.len(), "{name}: {found:?}");
        for (expected, found) in expected.iter().zip(found) {
            assert!((found.from - expected.from).abs() <= 1e-13 * expected.from, "{name}: {found:?}");
            match (expected.to, found.to) {
                (None, None) => {}
                (Some(expected), Some(found)) => {
                    assert!((found - expected).abs() <= 1e-13 * expected, "{name}: {found}")
                }
                _ => panic!("{name}: {found:?} instead of {expected:?}"),
            }
        }
    }
}

#[test]
fn at_rest_a_bicycle_falls() {
    for (name, bicycle) in bicycles::all() {
        let stability = Stability::new(&bicycle.coefficients(), bicycle.g).unwrap();
        assert_eq!(stability.verdict(0.0).unwrap(), Verdict::Unstable, "{name}");
    }
}

#[test]
fn at_the_ends_of_a_range_it_is_not_stable() {
    for (name, bicycle) in bicycles::all() {
        let stability = Stability::new(&bicycle.coefficients(), bicycle.g).unwrap();
        for range in &stability.stable_ranges {
            for end in [Some(range.from), range.to].into_iter().flatten() {
                assert_ne!(stability.verdict(end).unwrap(), Verdict::Stable, "{name} at {end}");
            }
        }
    }
}
