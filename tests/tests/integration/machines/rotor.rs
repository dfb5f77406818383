//! The Jeffcott rotor with damping that turns with the shaft.

#![allow(non_snake_case)] // Names of the field.

use carvallo::{Change, Complex, CriticalKind, Model};
use carvallo_models::JeffcottRotor;

use super::{assert_eigenvalues, assert_near, eigenvalues, stability};

/// It whirls above the spin rate `sqrt(k/m) (1 + ce/ci)`, with the frequency at which the shaft vibrates.
#[test]
fn a_rotor_whirls_above_the_threshold_of_the_textbooks() {
    let light = JeffcottRotor { m: 0.37, k: 2500.0, ce: 0.7, ci: 1.9, R: 0.063 };
    for (rotor, threshold) in [(JeffcottRotor::EXAMPLE, 250.0), (light, (2500.0_f64 / 0.37).sqrt() * (1.0 + 0.7 / 1.9))]
    {
        let stability = stability(&rotor.coefficients());
        let [whirl] = stability.critical_speeds[..] else { panic!("{stability:?}") };
        assert_eq!((whirl.kind, whirl.change), (CriticalKind::Weave, Change::Destabilizes));
        assert_near(whirl.speed / rotor.R, threshold, 1e-13);
        assert_near(whirl.eigenvalue.im.abs(), (rotor.k / rotor.m).sqrt(), 1e-13);
        assert_eq!(stability.stable_ranges.len(), 1);
    }
}

/// In the complex displacement y + i z the two equations are one, `m s^2 + (ce + ci) s + k - i ci W = 0` with the spin rate W:
/// with its two roots and, for the other way round, their conjugates.
#[test]
fn a_rotor_has_the_eigenvalues_of_one_complex_equation() {
    let rotor = JeffcottRotor::EXAMPLE;
    let JeffcottRotor { m, k, ce, ci, R } = rotor;
    for spin in [0.0, 130.0, 400.0] {
        let half = (ce + ci) / (2.0 * m);
        let root = (Complex::new(half * half - k / m, ci * spin / m)).sqrt();
        let expected: Vec<_> = [root - half, -root - half].into_iter().flat_map(|root| [root, root.conj()]).collect();
        assert_eigenvalues(eigenvalues(&rotor.coefficients(), spin * R, 0.0), &expected, 1e-12);
    }
}
