//! The towed wheel of Schwab & Meijaard (2003).

#![allow(non_snake_case)] // Names of the field.

use carvallo::{Complex, Model, States, Verdict};
use carvallo_models::TowedWheel;

use super::{assert_near, eigenvalues, stability};

/// With a squared radius of gyration of 0.21 l^2 it is stable for a centre of mass between 0.3 l and 0.7 l, at all speeds.
#[test]
fn a_towed_wheel_shimmies_beyond_the_limits_that_are_printed() {
    for (a, verdict) in
        [(0.29, Verdict::Unstable), (0.31, Verdict::Stable), (0.69, Verdict::Stable), (0.71, Verdict::Unstable)]
    {
        let stability = stability(&TowedWheel { a, ..TowedWheel::EXAMPLE }.coefficients());
        assert!(stability.critical_speeds.is_empty(), "{stability:?}");
        for speed in [0.1, 1.0, 30.0] {
            assert_eq!(stability.verdict(speed).unwrap(), verdict, "{a} at {speed} m/s");
        }
    }
}

/// Eigenvalues are the zeros of `(I + m a^2) s^3 + m a v s^2 + k l^2 s + k l v`: three, since the place is of first order.
#[test]
fn a_towed_wheel_has_the_characteristic_polynomial_that_is_printed() {
    let wheel = TowedWheel { l: 0.8, a: 0.37, ..TowedWheel::EXAMPLE };
    let TowedWheel { m, I, l, a, k } = wheel;
    assert_eq!(wheel.coefficients().states, [States::Both, States::Position]);
    for speed in [0.4, 1.0, 7.0] {
        let found = eigenvalues(&wheel.coefficients(), speed, 0.0);
        // By Vieta, so that each is there as often as it should.
        let [first, second, third] = found[..] else { panic!("{found:?}") };
        let leading = I + m * a * a;
        let vieta = [first + second + third, first * second + second * third + third * first, first * second * third];
        let expected = [-m * a * speed, k * l * l, -k * l * speed].map(|value| value / leading);
        for (found, expected) in vieta.into_iter().zip(expected) {
            assert!(
                (found - Complex::from(expected)).norm() <= 1e-12 * expected.abs(),
                "{found} instead of {expected}"
            );
        }
    }
}

/// At either limit there is a pair at which `(I + m a^2) s^2 + k l^2` and `m a v s^2 + k l v` are both zero.
#[test]
fn at_the_limits_it_swings_for_ever() {
    for a in [0.3, 0.7] {
        let wheel = TowedWheel { a, ..TowedWheel::EXAMPLE };
        let TowedWheel { m, I, l, k, .. } = wheel;
        let found = eigenvalues(&wheel.coefficients(), 1.0, 0.0);
        let pair = found.iter().max_by(|one, other| one.im.total_cmp(&other.im)).expect("three of them");
        assert!(pair.re.abs() < 1e-13, "{pair}");
        assert_near(pair.im, (k * l * l / (I + m * a * a)).sqrt(), 1e-13);
    }
}
