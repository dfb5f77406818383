//! Mechanisms whose equations are in textbooks.

use carvallo::{Coefficients, System};
use carvallo_tests::multibody::dynamics::Drive;
use carvallo_tests::multibody::{Body, Joint, Mechanism, Root, Wheel};
use nalgebra::{Matrix3, Vector3};

use super::check_all;

/// Lean and yaw of a disc that rolls on its rim (Routh 1884; Neimark & Fufaev 1972): it stays upright above a speed.
///
/// Of a round tyre, only the height of the centre over the tube's is different.
#[test]
fn a_disc_rolls_upright_when_it_is_fast() {
    let (mass, radius, axial, transverse) = (3.0, 0.35, 0.28, 0.1405);
    let about_rim = mass * radius * radius;
    for tyre in [0.0, 0.04] {
        let mut disc = Mechanism::default();
        let Root { x, yaw, lean, .. } = disc.free_root();
        disc.joints.pop(); // Its pitch is the angle of the wheel.
        disc.wheel(Wheel { carrier: lean, x: 0.0, y: 0.0, radius, tyre, mass, axial, transverse });
        let found = disc.linearized([lean, yaw], Some(x));

        let zeros = [[0.0; 2]; 2];
        let m = [[transverse + about_rim, 0.0], [0.0, transverse]];
        let c1 = [[0.0, (axial + about_rim) / radius], [-axial / radius, 0.0]];
        let k0 = [[-mass * (radius - tyre), 0.0], [0.0, 0.0]];
        check_all("disc", &found, &Coefficients::from_rows([m, zeros, zeros, c1, zeros, k0, zeros, zeros]));

        let gravity = 9.81;
        let least = gravity * (radius - tyre) * transverse * mass * radius * radius / (axial * (axial + about_rim));
        for (speed, stable) in [(0.99 * least.sqrt(), false), (1.01 * least.sqrt(), true)] {
            // Yaw is in the equations by its rate alone, which follows the lean: what is left is one oscillator.
            let System { m, c, k, .. } =
                disc.linearized_at(&Drive { speed, gravity, ..Drive::new([lean, yaw], Some(x)) });
            let stiffness = k[(0, 0)] - c[(0, 1)] * c[(1, 0)] / m[(1, 1)];
            assert_eq!(stiffness > 0.0, stable, "a disc at {speed} m/s");
        }
    }
}

#[test]
fn a_double_pendulum_swings_as_in_the_textbook() {
    let (l, m, inertia) = ([0.5, 0.3], [2.0, 1.5], [0.02, 0.01]);
    let mut pendulum = Mechanism::default();
    let upper = pendulum.joint(Joint::revolute(None, Vector3::zeros(), Vector3::x()).sprung(4.0, 0.3));
    let elbow = Vector3::new(0.0, 0.0, l[0]);
    let lower = pendulum.joint(Joint::revolute(Some(upper), elbow, Vector3::x()).sprung(5.0, 0.2));
    pendulum.body(body(upper, m[0], elbow, inertia[0]));
    pendulum.body(body(lower, m[1], Vector3::new(0.0, 0.0, l[0] + l[1]), inertia[1]));

    // The second angle is that of the elbow.
    let both = m[1] * l[0] * l[1];
    let outer = m[1] * l[1] * l[1] + inertia[1];
    let m11 = (m[0] + m[1]) * l[0] * l[0] + inertia[0] + outer + 2.0 * both;
    let zeros = [[0.0; 2]; 2];
    let expected = Coefficients::from_rows([
        [[m11, outer + both], [outer + both, outer]],
        zeros,
        [[0.3, 0.0], [0.0, 0.2]],
        zeros,
        [[4.0, 0.0], [0.0, 5.0]],
        [[(m[0] + m[1]) * l[0] + m[1] * l[1], m[1] * l[1]], [m[1] * l[1], m[1] * l[1]]],
        zeros,
        zeros,
    ]);
    check_all("double pendulum", &pendulum.linearized([upper, lower], None), &expected);
}

#[test]
fn a_pendulum_hangs_from_a_cart() {
    let mut cart = Mechanism::default();
    let slide = cart.joint(Joint::prismatic(None, Vector3::y()).sprung(60.0, 2.0));
    cart.body(body(slide, 5.0, Vector3::new(0.1, 0.0, -0.3), 0.4));
    let hinge = cart.joint(Joint::revolute(Some(slide), Vector3::new(0.0, 0.0, -0.2), Vector3::x()));
    cart.body(body(hinge, 1.5, Vector3::new(0.0, 0.0, 0.4), 0.03));

    // Turning about x moves what hangs to the left.
    let zeros = [[0.0; 2]; 2];
    let expected = Coefficients::from_rows([
        [[6.5, -1.5 * 0.6], [-1.5 * 0.6, 1.5 * 0.36 + 0.03]],
        zeros,
        [[2.0, 0.0], [0.0, 0.0]],
        zeros,
        [[60.0, 0.0], [0.0, 0.0]],
        [[0.0, 0.0], [0.0, 1.5 * 0.6]],
        zeros,
        zeros,
    ]);
    check_all("cart", &cart.linearized([slide, hinge], None), &expected);
}

/// A body whose moments of inertia are all the same.
fn body(joint: usize, mass: f64, centre: Vector3<f64>, inertia: f64) -> Body {
    Body { joint, mass, centre, inertia: Matrix3::from_diagonal_element(inertia) }
}
