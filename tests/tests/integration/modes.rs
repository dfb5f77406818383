//! Modes followed along speed.

use carvallo::{CriticalKind, Mode, ModeValue, Model, Modes, Stability};
use carvallo_models::Whipple;
use carvallo_tests::published::EIGENVALUES_2007;
use carvallo_tests::{bicycles, designs};
use nalgebra::Complex;
use proptest::prelude::*;

const STEP: f64 = 0.001;
const STEPS: i32 = 12_000;

fn modes(name: &str) -> Modes {
    let bicycle = bicycles::named(name);
    Modes::new(&bicycle.coefficients(), bicycle.g).unwrap()
}

/// Fails unless the values of the modes are the eigenvalues.
fn check_values(design: &Whipple, modes: &Modes, speed: f64) -> Result<(), TestCaseError> {
    let eigenvalues = design.coefficients().at(speed, design.g).unwrap().eigenvalues().unwrap();
    let mut values: Vec<Complex<f64>> = modes.at(speed).unwrap().iter().map(|mode| mode.value).collect();
    values.sort_by(|a, b| (a.re, a.im).partial_cmp(&(b.re, b.im)).unwrap());
    prop_assert_eq!(values, eigenvalues, "at {}", speed);
    Ok(())
}

#[test]
fn every_value_is_an_eigenvalue_and_every_eigenvalue_has_a_mode() {
    for (name, bicycle) in bicycles::all() {
        let modes = modes(name);
        for step in 0..=240 {
            check_values(&bicycle, &modes, f64::from(step) * 0.05).unwrap_or_else(|error| panic!("{name}: {error}"));
        }
    }
}

proptest! {
    #![proptest_config(designs::config(60))]

    #[test]
    fn every_design_has_modes(design in designs::any(), speeds in prop::array::uniform8(0.0..30.0)) {
        let modes = Modes::new(&design.coefficients(), design.g).unwrap();
        for speed in speeds {
            check_values(&design, &modes, speed)?;
        }
    }
}

#[test]
fn there_is_one_castering_one_capsize_and_two_of_weave() {
    for (name, _) in bicycles::all() {
        for speed in [0.0, 0.3, 1.0, 5.0, 20.0] {
            let modes = modes(name).at(speed).unwrap().map(|mode| mode.mode);
            assert_eq!(modes, [Mode::Castering, Mode::Capsize, Mode::Weave, Mode::Weave], "{name} at {speed}");
        }
    }
}

#[test]
fn the_benchmark_has_the_published_modes() {
    let modes = modes("benchmark");
    // At rest there is no weave yet; from 1 m/s on the paper names each column.
    for (speed, [re, im, capsize, castering]) in &EIGENVALUES_2007[1..] {
        let expected = [(*castering, 0.0), (*capsize, 0.0), (*re, -im), (*re, *im)];
        let mut found = modes.at(*speed).unwrap().map(|mode| mode.value);
        found[2..].sort_by(|a, b| a.im.total_cmp(&b.im));
        for (found, (re, im)) in found.into_iter().zip(expected) {
            assert!((found - Complex::new(re, im)).norm() <= 1e-12, "at {speed}: {found} instead of {re} + {im}i");
        }
    }
}

/// Fails if over a step two values are nearer to each other's places than to their own.
///
/// Where two values meet and part again as another pair, an exchange means nothing; there a step moves them by its
/// square root, and what is that near is let pass.
fn check_step(before: &[ModeValue; 4], now: &[ModeValue; 4], near: f64) -> Result<(), TestCaseError> {
    let moved = |from: usize, to: usize| distance(&before[from], &now[to]);
    for mode in 0..4 {
        for other in 0..mode {
            let kept = moved(mode, mode) + moved(other, other);
            let exchanged = moved(mode, other) + moved(other, mode);
            let meeting = distance(&now[mode], &now[other]) <= near;
            prop_assert!(kept <= exchanged || meeting, "{:?} to {:?}", before, now);
        }
    }
    Ok(())
}

fn distance(one: &ModeValue, other: &ModeValue) -> f64 {
    (one.value - other.value).norm()
}

#[test]
fn values_move_continuously_and_never_change_places() {
    let near = 10.0 * STEP.sqrt();
    for (name, _) in bicycles::all() {
        let modes = modes(name);
        let mut before = modes.at(0.0).unwrap();
        for step in 1..=STEPS {
            let speed = f64::from(step) * STEP;
            let now = modes.at(speed).unwrap();
            check_step(&before, &now, near).unwrap_or_else(|error| panic!("{name} at {speed}: {error}"));
            let farthest = before.iter().zip(&now).map(|(before, now)| distance(before, now)).fold(0.0, f64::max);
            assert!(farthest <= near, "{name} at {speed}: {before:?} to {now:?}");
            before = now;
        }
    }
}

proptest! {
    #![proptest_config(designs::config(60))]

    #[test]
    fn no_design_exchanges_its_modes(design in designs::regular()) {
        let modes = Modes::new(&design.coefficients(), design.g).unwrap();
        let critical_speeds = Stability::new(&design.coefficients(), design.g).unwrap().critical_speeds;
        let mut before = modes.at(0.0).unwrap();
        let near = 10.0 * STEP.sqrt() * before.iter().map(|mode| mode.value.norm()).fold(1.0, f64::max);
        for step in 1..=STEPS / 4 {
            let speed = f64::from(step) * STEP;
            let mut now = modes.at(speed).unwrap();
            // The two of weave are one mode, whichever comes first.
            if distance(&before[2], &now[3]) + distance(&before[3], &now[2])
                < distance(&before[2], &now[2]) + distance(&before[3], &now[3])
            {
                now.swap(2, 3);
            }
            if before.map(|value| value.mode) == now.map(|value| value.mode) {
                check_step(&before, &now, near)?;
            } else {
                // Names end at double-root speeds only.
                let meets = critical_speeds.iter().filter(|critical| critical.kind == CriticalKind::DoubleRoot);
                let is_between = |at: f64| at > speed - STEP && at <= speed;
                prop_assert!(meets.clone().any(|critical| is_between(critical.speed)), "{:?} to {:?}", before, now);
            }
            before = now;
        }
    }
}
