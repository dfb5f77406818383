//! Critical speeds of random systems of 1 to 8 coordinates against certain references: none lost, none extra.

use carvallo::{Change, Coefficients, CriticalKind, CriticalSpeed, Model, Stability};
use carvallo_tests::facts::{RandomSystem, RandomSystemSpeed, random_systems};
use carvallo_tests::{bicycles, designs};

/// The error relative to the speed that is allowed where the estimate is smaller.
const ACCURACY: f64 = 1e-11;

/// Frequencies are no better than the speeds.
const FREQUENCY: f64 = 1e-9;

fn check_speed(found: &CriticalSpeed, expected: &RandomSystemSpeed) {
    let &RandomSystemSpeed { kind, speed, frequency, way } = expected;
    let off = (found.speed - speed).abs();
    assert!(off <= found.error.max(ACCURACY * speed), "{kind} at {speed}: off by {off:e}, {found:?}");
    let off = (found.eigenvalue.im - frequency).abs();
    assert!(found.eigenvalue.re == 0.0 && off <= FREQUENCY * frequency, "{kind} at {speed}: {found:?}");
    match way {
        "up" => assert_eq!(found.change, Change::Destabilizes, "{kind} at {speed}"),
        "down" => assert_eq!(found.change, Change::Stabilizes, "{kind} at {speed}"),
        _ => {}
    }
}

fn check<const N: usize>(system: &RandomSystem) {
    let stability = Stability::general(&system.coefficients::<N>(), RandomSystem::GRAVITY).expect("an answer");
    for kind in [CriticalKind::Weave, CriticalKind::Capsize, CriticalKind::DoubleRoot] {
        let found: Vec<_> = stability.critical_speeds.iter().filter(|critical| critical.kind == kind).collect();
        let name = kind.to_string();
        let expected: Vec<_> = system.critical_speeds.iter().filter(|critical| critical.kind == name).collect();
        assert_eq!(found.len(), expected.len(), "{}: {name}: {found:?} where there are {expected:?}", system.name);
        for (found, expected) in found.into_iter().zip(expected) {
            check_speed(found, expected);
        }
    }
    assert!(stability.undecided.is_empty(), "{}: {:?}", system.name, stability.undecided);
}

#[test]
fn no_critical_speed_is_lost_and_none_is_extra() {
    let systems = random_systems();
    assert!(systems.len() >= 200);
    for system in systems {
        match system.coordinates {
            1 => check::<1>(&system),
            2 => check::<2>(&system),
            3 => check::<3>(&system),
            4 => check::<4>(&system),
            5 => check::<5>(&system),
            6 => check::<6>(&system),
            7 => check::<7>(&system),
            8 => check::<8>(&system),
            other => panic!("{}: {other} coordinates", system.name),
        }
    }
}

/// Two coordinates, for which there are two ways: by exact polynomials, and as for any number.
fn check_two_ways(name: &str, coefficients: &Coefficients<f64, 2>, gravity: f64) {
    let exact = Stability::new(coefficients, gravity).expect("an answer");
    let general = Stability::general(coefficients, gravity).expect("an answer");
    let crossings = |stability: &Stability| {
        let speeds = stability.critical_speeds.iter().copied();
        speeds.filter(|critical| critical.kind != CriticalKind::DoubleRoot).collect::<Vec<_>>()
    };
    let (exact_speeds, general_speeds) = (crossings(&exact), crossings(&general));
    assert_eq!(exact_speeds.len(), general_speeds.len(), "{name}: {exact_speeds:?} and {general_speeds:?}");
    for (exact, general) in exact_speeds.iter().zip(&general_speeds) {
        let off = (exact.speed - general.speed).abs();
        let allowed = exact.error.max(general.error).max(ACCURACY * exact.speed);
        assert!(exact.kind == general.kind && off <= allowed, "{name}: {exact:?} and {general:?}");
        assert_eq!(exact.change, general.change, "{name}: {exact:?} and {general:?}");
    }
    let speeds = exact_speeds.windows(2).map(|pair| 0.5 * (pair[0].speed + pair[1].speed));
    for speed in speeds.chain([0.0, 1e-3, 1e3]) {
        assert_eq!(exact.verdict(speed), general.verdict(speed), "{name} at {speed}");
    }
    assert_eq!(exact.stable_ranges.len(), general.stable_ranges.len(), "{name}");
    assert!(general.undecided.is_empty(), "{name}: {:?}", general.undecided);
}

#[test]
fn the_way_for_any_number_agrees_with_the_exact_one_for_two() {
    for (name, bicycle) in bicycles::all() {
        check_two_ways(name, &bicycle.coefficients(), bicycle.g);
    }
    for number in 0..1000 {
        let design = designs::numbered(number);
        check_two_ways(&format!("design {number}"), &design.coefficients(), design.g);
    }
}
