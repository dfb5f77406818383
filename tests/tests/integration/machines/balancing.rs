//! The pendulum on two wheels.

#![allow(non_snake_case)] // Names of the field.

use carvallo::Model;
use carvallo_models::WheeledPendulum;

use super::{assert_near, eigenvalues};

/// About the axle, with its displacement X, `(m + 2 mW + 2 Ia/r^2) X'' - m l theta'' = 0` and `(I + m l^2) theta'' - m l X'' =
/// m g l theta`: it falls over with the one root that is positive, at any speed. Nothing holds it in its place.
#[test]
fn a_pendulum_on_wheels_falls_as_its_closed_form_says() {
    for pendulum in [WheeledPendulum::ROBOT, WheeledPendulum::TRANSPORTER] {
        let WheeledPendulum { m, l, Iyy, mW, Ia, r, g, .. } = pendulum;
        let moved = m + 2.0 * mW + 2.0 * Ia / (r * r);
        let falls = (m * g * l * moved / (moved * (Iyy + m * l * l) - (m * l).powi(2))).sqrt();
        for speed in [0.0, 1.5] {
            let found = eigenvalues(&pendulum.coefficients(), speed, g);
            assert_near(found[0].re, -falls, 1e-12);
            assert_near(found[found.len() - 1].re, falls, 1e-12);
            assert!(found[1..found.len() - 1].iter().all(|value| value.norm() < 1e-6 * falls), "{found:?}");
        }
    }
}

/// Wheels resist a yaw rate by their masses and by their spin: `Izz + 2 (Ir + mW b^2 + Ia b^2/r^2)`.
#[test]
fn wheels_resist_yaw() {
    let pendulum = WheeledPendulum::ROBOT;
    let WheeledPendulum { Izz, mW, Ia, Ir, r, b, .. } = pendulum;
    let matrices = pendulum.coefficients();
    assert_near(matrices.m[(2, 2)], Izz + 2.0 * (Ir + mW * b * b + Ia * b * b / (r * r)), 1e-14);
    assert_eq!([matrices.m[(0, 2)], matrices.m[(1, 2)]], [0.0; 2]);
}

/// Both motors drive the wheels against the body, a difference of them turns the machine with the arm b/r.
#[test]
fn motors_act_on_what_they_join() {
    let pendulum = WheeledPendulum::ROBOT;
    let WheeledPendulum { r, b, .. } = pendulum;
    let forces = pendulum.kinematics().forces;
    // The point on the ground moves by X + r theta, so of the work -T (X'/r + theta') on both wheels -T x'/r is left.
    for ([left, right], expected) in [([1.0, 1.0], [-2.0 / r, 0.0, 0.0]), ([1.0, -1.0], [0.0, 0.0, -2.0 * b / r])] {
        for ([of_left, of_right], expected) in forces.into_iter().zip(expected) {
            let found = of_left * left + of_right * right;
            assert!((found - expected).abs() <= 1e-14 * expected.abs().max(1.0), "{found} instead of {expected}");
        }
    }
}
