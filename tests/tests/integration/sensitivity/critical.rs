//! Derivatives of critical speeds.

use carvallo::{CriticalDerivative, Model, Stability};
use carvallo_compare::Real;
use carvallo_models::Whipple;
use carvallo_tests::differences::Exact;
use carvallo_tests::{bicycles, designs};

use super::{name, sensitivity};

/// Fails unless every critical speed and its eigenvalue have every derivative to a relative precision, and returns how
/// many critical speeds there are.
fn check(label: &str, design: &Whipple, precision: f64) -> usize {
    let (exact, sensitivity) = (Exact::of(design), sensitivity(design));
    let critical_speeds = Stability::new(&design.coefficients(), design.g).unwrap().critical_speeds;
    for critical in &critical_speeds {
        let found = sensitivity.critical_speed(critical).unwrap();
        let CriticalDerivative::Smooth { speed, eigenvalue, condition } = found else {
            panic!("{label}: {critical:?}: {found:?}")
        };
        let at = exact.critical(critical.kind, Real::from(critical.speed), critical.eigenvalue);
        assert_eq!((speed.len(), eigenvalue.len()), (26, 26));
        for parameter in 0..26 {
            let (expected, expected_eigenvalue) = exact.critical_derivative(critical.kind, &at, parameter);
            let what = format!("{label}: {critical:?} by {} ({condition:e})", name(parameter));
            let off = (speed[parameter] - expected).abs();
            assert!(off <= precision * expected.abs(), "{what}: {} is not {expected}", speed[parameter]);
            let off = (eigenvalue[parameter] - expected_eigenvalue).norm();
            let found = eigenvalue[parameter];
            assert!(off <= precision * expected_eigenvalue.norm(), "{what}: {found} is not {expected_eigenvalue}");
        }
    }
    critical_speeds.len()
}

#[test]
fn those_of_every_bicycle_are_good_to_eleven_digits() {
    let found: usize = bicycles::all().into_iter().map(|(name, bicycle)| check(name, &bicycle, 1e-11)).sum();
    assert!(found > 50, "{found}");
}

#[test]
fn those_of_random_designs_are_good_to_ten_digits() {
    for number in 0..20 {
        check(&format!("design {number}"), &designs::numbered(number), 1e-10);
    }
}

/// At any gravity critical speeds scale with its root.
#[test]
fn gravity_scales_critical_speeds_with_its_root() {
    for (label, bicycle) in bicycles::all() {
        let (sensitivity, position) = (sensitivity(&bicycle), Whipple::INFO.gravity.unwrap());
        for critical in Stability::new(&bicycle.coefficients(), bicycle.g).unwrap().critical_speeds {
            let found = sensitivity.critical_speed(&critical).unwrap();
            let CriticalDerivative::Smooth { speed, eigenvalue, .. } = found else { panic!("{label}: {critical:?}") };
            let expected = critical.speed / (2.0 * bicycle.g);
            assert!((speed[position] - expected).abs() <= 1e-12 * expected, "{label}: {critical:?}");
            let expected = critical.eigenvalue / (2.0 * bicycle.g);
            assert!((eigenvalue[position] - expected).norm() <= 1e-12 * expected.norm(), "{label}: {critical:?}");
        }
    }
}
