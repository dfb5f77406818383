//! The typical section with steady lift.

#![allow(non_snake_case)] // Names of the field.

use carvallo::{CriticalKind, Model, Verdict};
use carvallo_models::TypicalSection;

use super::{assert_near, stability};

/// With a centre of mass at -1/10, an elastic axis at -1/5, a mass ratio of 20, a squared radius of gyration of 6/25 and a
/// ratio of frequencies of 2/5 it flutters at 1.842516872382498 and diverges at sqrt(8), in semichords by the time of the
/// pitch: at the first speed the discriminant of the characteristic polynomial in s^2 is zero, recomputed to 30 digits.
#[test]
fn a_section_flutters_before_it_diverges() {
    let section = TypicalSection::DIMENSIONLESS;
    let stability = stability(&section.coefficients());
    let flutter = &stability.critical_speeds[0];
    assert_near(flutter.speed, 1.842516872382498, 1e-13);
    // Where two squares of frequencies meet each is half of their sum.
    let TypicalSection { m, I, b, s, a, e, kh, ktheta, rho } = section;
    let x = m * b * (e - a);
    let lift = 2.0 * std::f64::consts::PI * rho * b * s * flutter.speed.powi(2);
    let sum = (m * (ktheta - lift * b * (0.5 + a)) + I * kh - x * lift) / (m * I - x * x);
    assert_near(flutter.eigenvalue.im.abs(), (sum / 2.0).sqrt(), 1e-7);
    assert_eq!(stability.verdicts_around(flutter), [Verdict::Marginal, Verdict::Unstable]);
    // What flutters becomes two motions that grow without swinging at the other zero of the discriminant.
    assert_near(stability.critical_speeds[1].speed, 2.7865985672474998, 1e-13);
    let divergence = stability.critical_speeds.iter().find(|critical| critical.kind == CriticalKind::Capsize);
    assert_near(divergence.expect("a divergence").speed, 8.0_f64.sqrt(), 1e-13);
}

/// On an axis before the centre of lift, the quarter chord, nothing diverges; with the centre of mass there nothing flutters.
#[test]
fn what_is_balanced_ahead_of_the_quarter_chord_does_nothing() {
    let section = TypicalSection { a: -0.6, e: -0.6, ..TypicalSection::DIMENSIONLESS };
    let stability = stability(&section.coefficients());
    assert!(stability.critical_speeds.iter().all(|critical| critical.eigenvalue.im != 0.0), "{stability:?}");
    for speed in [0.5, 3.0, 20.0] {
        assert_eq!(stability.verdict(speed).unwrap(), Verdict::Marginal);
    }
}
