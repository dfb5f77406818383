//! Mechanisms that are no bicycles: disc, skateboard, pendulum.

#![allow(non_snake_case)] // The names are the models'.

use carvallo::{Coefficients, CriticalKind, Model, Stability, Verdict};
use carvallo_models::{DoublePendulum, RollingDisc, Skateboard};
use carvallo_tests::textbook::{disc, pendulum, skateboard};

use super::assert_close;

const ROUNDING: f64 = 1e-14;

#[test]
fn the_disc_is_that_of_the_textbooks() {
    for (r, m, Ia, It) in [(0.3, 1.0, 0.045, 0.0225), (0.3, 1.0, 0.09, 0.045), (0.7, 3.2, 0.9, 0.31)] {
        let found = RollingDisc { r, m, Ia, It, g: 9.81 }.coefficients();
        assert_close(&found, &disc::Disc { m, r, rho: 0.0, Ia, It }.matrices(), ROUNDING, "disc");
    }
}

#[test]
fn a_disc_stays_up_above_the_speed_of_the_textbooks() {
    let hoop = (RollingDisc::HOOP, 4.0);
    for (disc, part) in [(RollingDisc::UNIFORM, 3.0), hoop] {
        let RollingDisc { r, m, Ia, It, g } = disc;
        let expected = g * r * It * m * r * r / (Ia * (Ia + m * r * r));
        assert!((expected - g * r / part).abs() < 1e-12, "the known special case");
        let stability = Stability::new(&disc.coefficients(), g).expect("the disc moves");
        let critical = stability.critical_speeds.iter().find(|critical| critical.kind == CriticalKind::Capsize);
        let critical = critical.expect("there it stops falling");
        assert!((critical.speed - expected.sqrt()).abs() < 1e-12, "{} {}", critical.speed, expected.sqrt());
        // It never comes to rest, but from there on it does not fall either.
        assert_eq!(stability.verdict(critical.speed * 0.99), Ok(Verdict::Unstable));
        assert_eq!(stability.verdict(critical.speed * 1.01), Ok(Verdict::Marginal));
    }
}

#[test]
fn the_skateboard_is_hubbards() {
    let boards = [
        Skateboard::EXAMPLE,
        Skateboard { lamF: 0.9, lamR: 0.6, kF: 20.0, kR: 35.0, Ixz: -0.3, b: 0.13, ..Skateboard::EXAMPLE },
    ];
    for board in boards {
        let Skateboard { L, lamF, lamR, kF, kR, m, x, h, Ixx, Ixz, .. } = board;
        let bodies = [skateboard::Body { m, x, h, Ixx, Ixz }];
        // A truck turns about its king pin by more than the board tilts.
        let k = kF / lamF.cos().powi(2) + kR / lamR.cos().powi(2);
        let expected = skateboard::Skateboard { L, lamF, lamR, k, bodies: &bodies };
        assert_close(&board.coefficients(), &expected.matrices(), ROUNDING, "skateboard");
    }
}

#[test]
fn the_double_pendulum_is_that_of_the_textbooks() {
    let DoublePendulum { l1, a1, m1, I1, a2, m2, I2, .. } = DoublePendulum::RODS;
    let link = |l, a, m, i| pendulum::Link { l, a, m, i };
    let expected = pendulum::standing_at_hinges([link(l1, a1, m1, I1), link(1.0, a2, m2, I2)]);
    assert_close(&DoublePendulum::RODS.coefficients(), &expected, ROUNDING, "double pendulum");
}

#[test]
fn what_does_not_roll_does_not_depend_on_the_speed() {
    let Coefficients { c0, c1, kc, k2, .. } = DoublePendulum::RODS.coefficients();
    assert!([c0, c1, kc, k2].iter().all(|matrix| matrix.iter().all(|entry| *entry == 0.0)));
}
