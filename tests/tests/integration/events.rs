//! What is told of a critical speed, of the modes there and of stability, against exact eigenvalues on both sides of it.

use carvallo::{Change, Coefficients, CriticalKind, CriticalSpeed, Mode, Model, Modes, Stability, Verdict};
use carvallo_compare::Real;
use carvallo_models::{RearSteered, Whipple};
use carvallo_tests::quartic::characteristic_at;
use carvallo_tests::roots::{Signature, roots};
use carvallo_tests::{bicycles, designs};
use nalgebra::Complex;
use proptest::prelude::*;

/// The eigenvalue nearest to another one.
fn nearest(to: Complex<f64>, among: impl IntoIterator<Item = Complex<f64>>) -> Complex<f64> {
    among.into_iter().min_by(|a, b| (a - to).norm().total_cmp(&(b - to).norm())).expect("eigenvalues")
}

/// What the eigenvalues are on one side of a critical speed.
struct Side {
    signature: Signature,
    /// The exact eigenvalue that is critical.
    critical: Complex<f64>,
    /// The name of the computed one.
    mode: Mode,
}

impl Side {
    fn new(coefficients: &Coefficients<f64, 2>, gravity: f64, modes: &Modes, speed: f64, at: Complex<f64>) -> Self {
        let polynomial = characteristic_at(coefficients, gravity, Real::from(speed));
        let critical = nearest(at, roots(polynomial).map(|root| root.to_f64()));
        let values = modes.at(speed).unwrap();
        let value = nearest(critical, values.map(|mode| mode.value));
        let mode = values.iter().find(|mode| mode.value == value).unwrap().mode;
        Self { signature: Signature::of(polynomial), critical, mode }
    }
}

fn verdict(signature: Signature) -> Verdict {
    if signature.is_stable() { Verdict::Stable } else { Verdict::Unstable }
}

/// Fails unless kind, mode, change and verdicts agree with the eigenvalues on both sides; says how many speeds there are.
fn check(coefficients: &Coefficients<f64, 2>, gravity: f64) -> Result<usize, TestCaseError> {
    let stability = Stability::new(coefficients, gravity).unwrap();
    let modes = Modes::new(coefficients, gravity).unwrap();
    let critical_speeds = &stability.critical_speeds;
    for (i, &critical) in critical_speeds.iter().enumerate() {
        let CriticalSpeed { kind, speed, eigenvalue, change, .. } = critical;
        let before = i.checked_sub(1).map_or(0.0, |i| critical_speeds[i].speed);
        let after = critical_speeds.get(i + 1).map_or(2.0 * speed, |next| next.speed);
        let apart = (speed - before).min(after - speed).min(1e-2 * speed) / 8.0;
        if apart < 1e-9 * speed {
            // Nearer to each other than the digits of doubles tell their sides apart.
            continue;
        }
        let [below, above] =
            [speed - apart, speed + apart].map(|speed| Side::new(coefficients, gravity, &modes, speed, eigenvalue));
        let mode = match kind {
            CriticalKind::Weave => Mode::Weave,
            CriticalKind::Capsize => Mode::Capsize,
            CriticalKind::DoubleRoot => {
                let pairs = [&below, &above].map(|side| (4 - side.signature.real) / 2);
                let expected = match change {
                    Change::Merges => pairs[0] + 1 == pairs[1],
                    Change::Splits => pairs[0] == pairs[1] + 1,
                    _ => pairs[0] == pairs[1],
                };
                prop_assert!(expected, "{critical:?}: {pairs:?}");
                continue;
            }
        };
        for side in [&below, &above] {
            prop_assert_eq!(side.mode, mode, "{:?}", critical);
            // Imaginary parts of exact real eigenvalues are no more than what is left of 96 digits.
            prop_assert_eq!(side.critical.im.abs() > 1e-30, kind == CriticalKind::Weave, "{:?}", critical);
        }
        let expected = match [below.critical.re > 0.0, above.critical.re > 0.0] {
            [true, false] => Change::Stabilizes,
            [false, true] => Change::Destabilizes,
            _ => Change::Touches,
        };
        prop_assert_eq!(change, expected, "{:?}", critical);
        let verdicts = [verdict(below.signature), verdict(above.signature)];
        prop_assert_eq!(stability.verdicts_around(&critical), verdicts, "{:?}", critical);
        for (name, counts) in [
            (Mode::Castering, 0..=1),
            (Mode::Capsize, 0..=1),
            (Mode::Weave, 0..=2),
            (Mode::Real, 0..=4),
            (Mode::Oscillatory, 0..=4),
        ] {
            let count = modes.at(speed).unwrap().iter().filter(|value| value.mode == name).count();
            prop_assert!(counts.contains(&count), "{count} of {name} at {critical:?}");
        }
    }
    Ok(critical_speeds.len())
}

/// The same bicycle run backwards, by a model of its own.
fn backwards(design: &Whipple) -> Coefficients<f64, 2> {
    let mut values = [0.0; 26];
    design.write_to(&mut values).expect("room for every parameter");
    RearSteered::from_slice(&values).expect("the same parameters").coefficients()
}

#[test]
fn kinds_modes_and_changes_of_the_bicycles_agree() {
    for (name, bicycle) in bicycles::all() {
        for coefficients in [bicycle.coefficients(), backwards(&bicycle)] {
            let count = check(&coefficients, bicycle.g).unwrap_or_else(|error| panic!("{name}: {error}"));
            assert!(count >= 2, "{name}");
        }
    }
}

proptest! {
    #![proptest_config(designs::config(8))]

    /// Eight near each of the bicycles, forward and backwards.
    #[test]
    fn kinds_modes_and_changes_near_every_bicycle_agree(
        designs in bicycles::all().iter().map(|(_, bicycle)| designs::near(bicycle)).collect::<Vec<_>>()
    ) {
        for design in designs {
            check(&design.coefficients(), design.g)?;
            check(&backwards(&design), design.g)?;
        }
    }
}

proptest! {
    #![proptest_config(designs::config(60))]

    #[test]
    fn kinds_modes_and_changes_of_random_designs_agree(design in designs::regular()) {
        check(&design.coefficients(), design.g)?;
        check(&backwards(&design), design.g)?;
    }
}

/// The bicycle run backwards has the negatives of the eigenvalues at each speed, and the same names for them.
#[test]
fn a_reversed_bicycle_has_the_modes_of_the_forward_one() {
    for (name, bicycle) in bicycles::all() {
        let forward = Modes::new(&bicycle.coefficients(), bicycle.g).unwrap();
        let reversed = Modes::new(&backwards(&bicycle), bicycle.g).unwrap();
        for step in 1..60 {
            let speed = 0.253 * f64::from(step);
            let values = reversed.at(speed).unwrap();
            for mode in forward.at(speed).unwrap() {
                let value = nearest(-mode.value, values.map(|mode| mode.value));
                assert!((value + mode.value).norm() <= 1e-7 * mode.value.norm(), "{name} at {speed}: {values:?}");
                let there = values.iter().any(|other| other.mode == mode.mode && other.value == value);
                assert!(there, "{name} at {speed}: {mode:?} in {values:?}");
            }
        }
    }
}
