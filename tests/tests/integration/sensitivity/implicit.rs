//! Derivatives of critical speeds of any number of coordinates, against those of determinants at 60 digits and against the
//! way of two coordinates.

use carvallo::{Coefficients, CriticalDerivative, MatrixName, Model, Sensitivity, Stability};
use carvallo_tests::facts::{RandomSystem, random_derivatives, random_systems};
use carvallo_tests::{bicycles, designs};

use super::sensitivity;

/// The change that the derivatives are for, as the head of the table has it.
fn direction<const N: usize>(coefficients: &Coefficients<f64, N>) -> Coefficients<f64, N> {
    let mut direction = *coefficients;
    for (k, name) in MatrixName::ALL.into_iter().enumerate() {
        let matrix = direction.matrix_mut(name);
        for (i, j) in (0..N).flat_map(|i| (0..N).map(move |j| (i, j))) {
            matrix[(i, j)] /= (1 + i + j + k) as f64;
        }
    }
    direction
}

/// The number of critical speeds that were held against the table.
fn check<const N: usize>(system: &RandomSystem, expected: &[[f64; 2]]) -> usize {
    let coefficients = system.coefficients::<N>();
    let derivatives = [direction(&coefficients)];
    let sensitivity = Sensitivity::new(&coefficients, &derivatives, RandomSystem::GRAVITY, None).unwrap();
    let stability = Stability::general(&coefficients, RandomSystem::GRAVITY).unwrap();
    assert_eq!(stability.critical_speeds.len(), expected.len(), "{}", system.name);
    for (critical, [by_speed, by_frequency]) in stability.critical_speeds.iter().zip(expected) {
        let found = sensitivity.implicit(critical).unwrap();
        let CriticalDerivative::Smooth { speed, eigenvalue, condition } = found else {
            panic!("{}: {critical:?}: {found:?}", system.name)
        };
        let off = (speed[0] - by_speed).abs() / by_speed.abs();
        assert!(off <= 1e-12, "{}: {critical:?}: off by {off:e} ({condition:e})", system.name);
        let off = (eigenvalue[0].im - by_frequency).abs();
        assert!(off <= 1e-11 * by_frequency.abs(), "{}: {critical:?}: {} {by_frequency}", system.name, eigenvalue[0]);
        assert!(eigenvalue[0].re.abs() <= 1e-15 * by_frequency.abs(), "{}: {}", system.name, eigenvalue[0]);
    }
    expected.len()
}

#[test]
fn those_of_random_systems_are_good_to_twelve_digits() {
    let derivatives = random_derivatives();
    let mut count = 0;
    for system in random_systems() {
        let Some(expected) = derivatives.get(system.name) else { continue };
        count += match system.coordinates {
            1 => check::<1>(&system, expected),
            2 => check::<2>(&system, expected),
            3 => check::<3>(&system, expected),
            4 => check::<4>(&system, expected),
            5 => check::<5>(&system, expected),
            6 => check::<6>(&system, expected),
            7 => check::<7>(&system, expected),
            8 => check::<8>(&system, expected),
            other => panic!("{}: {other} coordinates", system.name),
        };
    }
    assert!(count > 1300, "{count}");
}

/// Double roots, too, off the axis.
#[test]
fn null_vectors_and_coefficients_of_the_quartic_agree() {
    let numbered = (0..50).map(|number| (format!("design {number}"), designs::numbered(number)));
    let all = bicycles::all().into_iter().map(|(name, bicycle)| (name.to_owned(), bicycle)).chain(numbered);
    for (name, design) in all {
        let sensitivity = sensitivity(&design);
        for critical in Stability::new(&design.coefficients(), design.g).unwrap().critical_speeds {
            let ways = [sensitivity.critical_speed(&critical), sensitivity.implicit(&critical)];
            let [Ok(CriticalDerivative::Smooth { speed, eigenvalue, .. }), Ok(other)] = ways else {
                panic!("{name}: {critical:?}")
            };
            let CriticalDerivative::Smooth { speed: other_speed, eigenvalue: other_eigenvalue, .. } = other else {
                panic!("{name}: {critical:?}: {other:?}")
            };
            for (parameter, (one, other)) in speed.iter().zip(&other_speed).enumerate() {
                let off = (one - other).abs();
                assert!(off <= 1e-10 * one.abs(), "{name}: {critical:?} by parameter {parameter}: {one} and {other}");
            }
            for (one, other) in eigenvalue.iter().zip(&other_eigenvalue) {
                assert!((one - other).norm() <= 1e-10 * one.norm(), "{name}: {critical:?}: {one} and {other}");
            }
        }
    }
}
