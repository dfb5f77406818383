//! The railway wheelset with linear creep.

#![allow(non_snake_case)] // Names of the field.

use carvallo::{Change, CriticalKind, Model, SystemError};
use carvallo_models::Wheelset;

use super::{assert_near, eigenvalues, stability};

/// The speed above which it hunts, by the last but one determinant of Hurwitz, which is linear in the square of the speed.
#[test]
fn a_wheelset_hunts_above_its_critical_speed() {
    let stiff = Wheelset { ky: 5e6, kpsi: 3e6, lam: 0.05, f11: 8e6, ..Wheelset::EXAMPLE };
    for wheelset in [Wheelset::EXAMPLE, stiff] {
        let Wheelset { m, I, f11, f22, b, lam, r, ky, kpsi } = wheelset;
        let (d1, d2) = (2.0 * f22, 2.0 * f11 * b * b);
        let (a1, a3) = (d1 * kpsi + d2 * ky, m * d2 + I * d1);
        let a0 = ky * kpsi + 4.0 * f11 * f22 * b * lam / r;
        let square = a1 * a3 * d1 * d2 / (a3 * a3 * a0 + m * I * a1 * a1 - a1 * a3 * (m * kpsi + I * ky));
        let stability = stability(&wheelset.coefficients());
        let [hunting] = stability.critical_speeds[..] else { panic!("{stability:?}") };
        assert_eq!((hunting.kind, hunting.change), (CriticalKind::Weave, Change::Destabilizes));
        assert_near(hunting.speed, square.sqrt(), 1e-13);
        assert_near(hunting.eigenvalue.im.abs(), (a1 / a3).sqrt(), 1e-13);
    }
    // The same in numbers, computed elsewhere.
    assert_near(stability(&Wheelset::EXAMPLE.coefficients()).critical_speeds[0].speed, 21.836153123112624, 1e-13);
}

/// Klingel (1883): a wheelset that nothing holds runs along a wave of the length `2 pi sqrt(b r/lam)`. Its mass makes it grow.
#[test]
fn a_free_wheelset_runs_along_the_wave_of_klingel() {
    let free = Wheelset { ky: 0.0, kpsi: 0.0, ..Wheelset::EXAMPLE };
    for speed in [0.1, 1.0] {
        let found = eigenvalues(&free.coefficients(), speed, 0.0);
        let hunting = found.iter().filter(|value| value.im > 0.0).min_by(|a, b| a.norm().total_cmp(&b.norm()));
        let hunting = hunting.expect("a wave");
        // What inertia does to the frequency is of the second order in (inertia)/(creep), the growth of the first.
        assert_near(hunting.im, speed * (free.lam / (free.b * free.r)).sqrt(), 1e-4 * speed * speed);
        assert!(hunting.re > 0.0, "{hunting}");
    }
}

#[test]
fn at_rest_there_is_no_creep_to_speak_of() {
    let error: SystemError = Wheelset::EXAMPLE.coefficients().at(0.0, 0.0).unwrap_err();
    assert!(error.to_string().contains("speed"), "{error}");
}
