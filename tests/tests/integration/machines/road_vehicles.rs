//! The motorcycle and the car that ship, against print and closed forms.

use carvallo::{Change, CriticalKind, CriticalSpeed, Model, Stability, States};
use carvallo_models::{Car, Motorcycle};
use carvallo_tests::published::{EIGENVALUES_1971, FOOT, units_off};

fn critical<const N: usize>(model: &impl Model<N>) -> Vec<CriticalSpeed> {
    let gravity = model.gravity().map_or(0.0, carvallo::Scalar::to_f64);
    let stability = Stability::new(&model.coefficients(), gravity).expect("a regular system");
    stability.critical_speeds.into_iter().filter(|critical| critical.kind != CriticalKind::DoubleRoot).collect()
}

#[test]
fn the_motorcycle_has_the_eigenvalues_that_sharp_prints() {
    let states: Vec<States> = Motorcycle::INFO.coordinates.iter().map(|coordinate| coordinate.states).collect();
    assert_eq!(states, [States::Rate, States::Rate, States::Both, States::Both, States::Position, States::Position]);
    let matrices = Motorcycle::STANDARD.coefficients();
    let mut checked = 0;
    for (speed, printed) in EIGENVALUES_1971 {
        let system = matrices.at(speed * FOOT, Motorcycle::STANDARD.g);
        let found = system.and_then(|system| system.eigenvalues()).expect("a regular system");
        assert_eq!(found.len(), 8);
        for expected in printed {
            let units = units_off(&found, expected);
            assert!(units <= 0.5, "at {speed} ft/s {expected:?} is printed, {units} units from {found:?}");
            checked += 1;
        }
    }
    assert_eq!(checked, 24);
}

/// Those of the equations of R. S. Sharp, The stability and control of motorcycles, J. Mech. Eng. Sci. 13 (1971), for the
/// parameters that he prints, solved with 25 digits: in ft/s and 1/s. The last is far beyond the range that he looks at:
/// there the wobble becomes stable again.
#[test]
fn the_motorcycle_has_four_critical_speeds() {
    let expected = [
        (CriticalKind::Weave, 19.440_006_372_816_047, 2.0855133306714593),
        (CriticalKind::Capsize, 35.210_269_211_458_69, 0.0),
        (CriticalKind::Weave, 181.684_761_720_011_5, 59.281_250_592_044_735),
        (CriticalKind::Weave, 706.189_700_548_180_2, 130.954_309_695_381_4),
    ];
    let found = critical::<6>(&Motorcycle::STANDARD);
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
    assert_eq!((found[0].kind, found[0].change), (CriticalKind::Capsize, Change::Destabilizes));
    assert!((found[0].speed - expected).abs() < 1e-11, "{found:?}");
    assert!(critical::<2>(&Car::UNDERSTEERING).is_empty());
}
