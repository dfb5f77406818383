//! The bicycle with a motor that steers into the fall.

use carvallo::{Model, Stability};
use carvallo_models::{BalanceAssist, Whipple};
use nalgebra::Matrix2;

use super::{assert_eigenvalues, assert_same, eigenvalues};

/// At one speed the motor is an entry of the damping matrix, and at the speed `vo` nothing at all.
#[test]
fn the_motor_is_a_torque_by_the_lean_rate() {
    for (kappa, vo) in [(10.0, 4.7), (0.0, 3.0), (3.5, 6.0)] {
        let assisted = BalanceAssist { kappa, vo, ..BalanceAssist::BENCHMARK };
        for speed in [0.0, 1.5, vo, 8.0] {
            let found = assisted.coefficients().at(speed, assisted.g).expect("a mass");
            let mut expected = Whipple::BENCHMARK.coefficients().at(speed, assisted.g).expect("a mass");
            // A torque stands on the other side of the equation.
            expected.c -= Matrix2::new(0.0, 0.0, kappa * (vo - speed), 0.0);
            assert_same(found.m, expected.m);
            assert_same(found.c, expected.c);
            assert_same(found.k, expected.k);
            let expected = expected.eigenvalues().expect("they converge");
            assert_eigenvalues(eigenvalues(&assisted.coefficients(), speed, assisted.g), &expected, 1e-11);
        }
    }
}

/// The bicycle balances itself from a lower speed on; no torque of the lean rate reaches its capsize speed, which is a matter
/// of K alone.
#[test]
fn the_motor_lowers_the_weave_speed_and_leaves_the_capsize_speed() {
    let assisted = BalanceAssist::BALANCEASSISTV1;
    let alone = BalanceAssist { kappa: 0.0, ..assisted };
    let ranges = [alone, assisted].map(|bicycle| {
        let stability = Stability::new(&bicycle.coefficients(), bicycle.g).expect("an answer");
        let [range] = &stability.stable_ranges[..] else { panic!("one range of {stability:?}") };
        [range.from, range.to.expect("an end")]
    });
    let [[weave, capsize], [assisted_weave, assisted_capsize]] = ranges;
    assert!(assisted_weave < weave / 4.0, "{assisted_weave} and {weave}");
    assert!((assisted_capsize - capsize).abs() < 1e-13 * capsize, "{assisted_capsize} and {capsize}");
}
