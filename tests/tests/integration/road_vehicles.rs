//! The motorcycle and the car that ship, against print and closed forms.

use carvallo::{Complex, CriticalKind, CriticalSpeed, Model, Stability, States};
use carvallo_models::{Car, Motorcycle};

const FOOT: f64 = 0.3048;

fn critical<const N: usize>(model: &impl Model<N>) -> Vec<CriticalSpeed> {
    let gravity = model.gravity().map_or(0.0, carvallo::Scalar::to_f64);
    let stability = Stability::new(&model.coefficients(), gravity).expect("a regular system");
    stability.critical_speeds.into_iter().filter(|critical| critical.kind != CriticalKind::DoubleRoot).collect()
}

/// The eigenvalues that Sharp prints for the motorcycle, in 1/s, by speed in ft/s: capsize, weave and wobble.
const PRINTED: [(f64, f64, [f64; 2], [f64; 2]); 8] = [
    (10.0, -3.56, [2.01, 1.63], [-5.20, 55.7]),
    (20.0, -2.83, [-0.18, 2.09], [-5.91, 55.8]),
    (30.0, -0.13, [-3.36, 4.56], [-6.42, 55.5]),
    (50.0, 0.08, [-6.59, 11.4], [-6.52, 54.6]),
    (70.0, 0.08, [-3.97, 16.8], [-5.70, 54.0]),
    (100.0, 0.07, [-1.82, 19.2], [-3.94, 54.3]),
    (130.0, 0.05, [-1.13, 20.4], [-2.24, 55.6]),
    (160.0, 0.04, [-0.96, 21.2], [-0.82, 57.5]),
];

/// Half a unit of the last of the digits that are printed of a number: two behind the point, or three in all.
fn half_a_unit(printed: f64) -> f64 {
    if printed.abs() < 10.0 { 0.005 } else { 0.05 }
}

#[test]
fn the_motorcycle_has_the_eigenvalues_that_sharp_prints() {
    let states: Vec<States> = Motorcycle::INFO.coordinates.iter().map(|coordinate| coordinate.states).collect();
    assert_eq!(states, [States::Rate, States::Rate, States::Both, States::Both, States::Position, States::Position]);
    let matrices = Motorcycle::STANDARD.coefficients();
    let mut checked = 0;
    for (speed, capsize, weave, wobble) in PRINTED {
        let system = matrices.at(speed * FOOT, Motorcycle::STANDARD.g);
        let found = system.and_then(|system| system.eigenvalues()).expect("a regular system");
        assert_eq!(found.len(), 8);
        for (re, im) in [(capsize, 0.0), (weave[0], weave[1]), (wobble[0], wobble[1])] {
            let expected = Complex::new(re, im);
            let nearest = found.iter().min_by(|a, b| (*a - expected).norm().total_cmp(&(*b - expected).norm()));
            let nearest = nearest.expect("eight of them");
            let fits = (nearest.re - re).abs() <= half_a_unit(re) && (nearest.im - im).abs() <= half_a_unit(im);
            assert!(fits, "at {speed} ft/s {nearest} is printed as {expected}");
            checked += 1;
        }
    }
    assert_eq!(checked, 24);
}

/// Those below 300 ft/s, the range that he looks at, are those of the equations of R. S. Sharp, The stability and control of motorcycles, J. Mech. Eng. Sci. 13 (1971), for the parameters that
/// he prints, solved with 25 digits: in ft/s and 1/s. Far beyond, the wobble becomes stable again.
#[test]
fn the_motorcycle_has_three_critical_speeds() {
    let expected = [
        (CriticalKind::Weave, 19.440_006_372_816_047, 2.0855133306714593),
        (CriticalKind::Capsize, 35.210_269_211_458_69, 0.0),
        (CriticalKind::Weave, 181.684_761_720_011_5, 59.281_250_592_044_735),
    ];
    let all = critical::<6>(&Motorcycle::STANDARD);
    let (found, beyond): (Vec<_>, Vec<_>) = all.into_iter().partition(|critical| critical.speed < 300.0 * FOOT);
    let unstable = |speed: f64| {
        let system = Motorcycle::STANDARD.coefficients().at(speed, Motorcycle::STANDARD.g).expect("a regular system");
        system.eigenvalues().expect("eight of them").iter().filter(|eigenvalue| eigenvalue.re > 0.0).count()
    };
    for critical in beyond {
        assert_eq!(unstable(0.99 * critical.speed), unstable(1.01 * critical.speed) + 2, "{critical:?}");
    }
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, (kind, speed, frequency)) in found.iter().zip(expected) {
        assert_eq!(found.kind, kind);
        let bound = (1e-11 * speed * FOOT).max(found.error);
        assert!((found.speed - speed * FOOT).abs() <= bound, "{found:?} is not at {speed} ft/s");
        assert!((found.eigenvalue.im - frequency).abs() <= 1e-10 * frequency, "{found:?} has not {frequency}/s");
    }
}

/// `v² = (a + b)² Cf Cr/(m (a Cf - b Cr))`, if that is positive.
#[test]
fn a_car_that_oversteers_has_a_critical_speed() {
    let found = critical::<2>(&Car::OVERSTEERING);
    let Car { m, a, b, Cf, Cr, .. } = Car::OVERSTEERING;
    let expected = ((a + b).powi(2) * Cf * Cr / (m * (a * Cf - b * Cr))).sqrt();
    assert!((expected - 63.354_163_241_258_46).abs() < 1e-12);
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].kind == CriticalKind::Capsize && (found[0].speed - expected).abs() < 1e-11, "{found:?}");
    assert!(critical::<2>(&Car::UNDERSTEERING).is_empty());
}
