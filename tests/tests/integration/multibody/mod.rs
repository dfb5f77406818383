//! Generated matrices, and matrices from print and from textbooks, against differences of nonlinear multibody dynamics.

mod bicycle;
mod energy;
mod textbook;

use carvallo::{Coefficients, Matrix};
use carvallo_tests::multibody::bicycle::Rider;

/// How far an entry may be off, relative to the largest of its matrix, or absolutely if all of it is zero.
const OFF: f64 = 1e-12;

fn check<const N: usize>(what: &str, found: &Matrix<f64, N>, expected: &Matrix<f64, N>) {
    let off = (found - expected).amax();
    let largest = if expected.amax() > 0.0 { expected.amax() } else { 1.0 };
    assert!(off <= OFF * largest, "{what} is {found}off {expected}by {off:e}");
}

fn check_all<const N: usize>(what: &str, found: &Coefficients<f64, N>, expected: &Coefficients<f64, N>) {
    check(&format!("{what}: M"), &found.m, &expected.m);
    check(&format!("{what}: C0"), &found.c0, &expected.c0);
    check(&format!("{what}: C1"), &found.c1, &expected.c1);
    check(&format!("{what}: Kc"), &found.kc, &expected.kc);
    check(&format!("{what}: K0"), &found.k0, &expected.k0);
    check(&format!("{what}: K2"), &found.k2, &expected.k2);
}

/// A rider of usual proportions.
const RIDER: Rider = Rider {
    mass: 40.0,
    centre: [0.2, -1.2],
    inertia: [2.0, 1.8, 0.9, 0.3],
    joint: [0.1, -0.9],
    stiffness: 90.0,
    damping: 7.0,
};
