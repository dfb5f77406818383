//! Generated matrices, and matrices from print and from textbooks, against differences of nonlinear multibody dynamics.

use carvallo::{Coefficients, Matrix, Model, System};
use carvallo_models::Whipple;
use carvallo_tests::multibody::bicycle::{Bicycle, Extras, Rider};
use carvallo_tests::multibody::dynamics::Drive;
use carvallo_tests::multibody::{Body, Joint, Mechanism, Root, Wheel};
use carvallo_tests::published::{BENCHMARK_2005, BENCHMARK_2007};
use carvallo_tests::{bicycles, designs};
use nalgebra::{Matrix3, Vector3};
use proptest::prelude::*;

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

/// In lean and steer.
fn linearized(design: &Whipple, extras: &Extras) -> Coefficients<f64, 2> {
    let bicycle = Bicycle::new(design, extras);
    bicycle.mechanism.linearized([bicycle.root.lean, bicycle.steer], Some(bicycle.root.x))
}

#[test]
fn the_mechanism_has_the_published_matrices() {
    for benchmark in [BENCHMARK_2007, BENCHMARK_2005] {
        let found = linearized(&bicycles::named(benchmark.bicycle), &Extras::default());
        let found = [found.m, found.c1, found.k0 * benchmark.gravity, found.k2];
        for (printed, found) in benchmark.matrices.iter().zip(found) {
            let printed = Matrix::from_fn(|row, column| printed[row][column].parse().unwrap());
            check(benchmark.bicycle, &found, &printed);
        }
    }
}

#[test]
fn generated_matrices_are_those_of_the_mechanism() {
    for (name, design) in bicycles::all() {
        check_all(name, &design.coefficients(), &linearized(&design, &Extras::default()));
    }
}

proptest! {
    #![proptest_config(designs::config(30))]

    #[test]
    fn generated_matrices_are_those_of_the_mechanism_for_any_design(design in designs::any()) {
        check_all("a design", &design.coefficients(), &linearized(&design, &Extras::default()));
    }
}

/// Speed enters by the first and second power, gravity by the first, and backwards is a negative speed.
#[test]
fn the_form_of_the_equations_is_that_of_the_mechanism() {
    let extras = Extras { rear_tyre: 0.02, front_tyre: 0.05, steer_stiffness: 3.0, steer_damping: 2.0, rider: None };
    let bicycle = Bicycle::new(&bicycles::named("silver"), &extras);
    let (independent, forward) = ([bicycle.root.lean, bicycle.steer], Some(bicycle.root.x));
    let coefficients = bicycle.mechanism.linearized(independent, forward);
    for (speed, gravity) in [(-1.7, 9.81), (4.2, 1.62)] {
        let drive = Drive { independent, forward, speed, gravity };
        let System { m, c, k } = coefficients.at(speed, gravity).unwrap();
        let found = bicycle.mechanism.linearized_at(&drive);
        check("M", &found.m, &m);
        check("C", &found.c, &c);
        check("K", &found.k, &k);
    }
}

/// What forces do is what the energy gains, far from upright and with everything that a bicycle can have.
#[test]
fn energy_is_kept() {
    let rider = Rider {
        mass: 40.0,
        centre: [0.2, -1.2],
        inertia: [2.0, 1.8, 0.9, 0.3],
        joint: [0.1, -0.9],
        stiffness: 90.0,
        damping: 0.0,
    };
    let (rear_tyre, front_tyre) = (0.03, 0.06);
    let extras = Extras { rear_tyre, front_tyre, steer_stiffness: 5.0, rider: Some(rider), ..Extras::default() };
    let bicycle = Bicycle::new(&bicycles::named("benchmark"), &extras);
    let independent = [bicycle.root.lean, bicycle.steer, bicycle.rider.unwrap(), bicycle.rear_wheel];
    let drive = Drive { independent, forward: None, speed: 0.0, gravity: 9.81 };
    let [q, qd, qdd] = [[0.4, -0.3, 0.2, 0.0], [0.7, 1.1, -0.8, -9.0], [-2.0, 5.0, 3.0, 4.0]];

    let step = 1e-4;
    let after = |time: f64| {
        let position = std::array::from_fn(|i| q[i] + time * qd[i] + time * time / 2.0 * qdd[i]);
        let rate = std::array::from_fn(|i| qd[i] + time * qdd[i]);
        bicycle.mechanism.energy(&drive, [position, rate, qdd])
    };
    let gain = (after(step) - after(-step)) / (2.0 * step);
    let forces = bicycle.mechanism.forces(&drive, [q, qd, qdd]);
    let power: f64 = forces.iter().zip(qd).map(|(force, rate)| force * rate).sum();
    assert!((power - gain).abs() <= 1e-6 * gain.abs(), "{power} W, and a gain of {gain} W");
}

/// A rider whose joint does not move is part of the rear frame; the rider's own equation is that of a pendulum with its
/// pivot on a frame that leans, and that yaws by (v delta + c delta') cos(lam) / w while it steers.
#[test]
fn a_rider_is_a_pendulum_on_the_frame() {
    let rider = Rider {
        mass: 40.0,
        centre: [0.2, -1.2],
        inertia: [2.0, 1.8, 0.9, 0.3],
        joint: [0.1, -0.9],
        stiffness: 90.0,
        damping: 7.0,
    };
    let Rider { mass: m, centre: [x, z], inertia: [xx, _, zz, xz], joint: [_, pivot], .. } = rider;
    let design = bicycles::named("benchmark");
    let bicycle = Bicycle::new(&design, &Extras { rider: Some(rider), ..Extras::default() });
    let independent = [bicycle.root.lean, bicycle.steer, bicycle.rider.unwrap()];
    let found = bicycle.mechanism.linearized(independent, Some(bicycle.root.x));

    let whole = design.mB + m;
    let (xw, zw) = ((design.xB * design.mB + x * m) / whole, (design.zB * design.mB + z * m) / whole);
    let ridden = Whipple {
        mB: whole,
        xB: xw,
        zB: zw,
        IBxx: design.IBxx + design.mB * (design.zB - zw).powi(2) + xx + m * (z - zw).powi(2),
        IBzz: design.IBzz + design.mB * (design.xB - xw).powi(2) + zz + m * (x - xw).powi(2),
        IBxz: design.IBxz - design.mB * (design.xB - xw) * (design.zB - zw) + xz - m * (x - xw) * (z - zw),
        ..design
    };
    let ridden = ridden.coefficients();
    let arm = z - pivot;
    let turn = design.lam.cos() / design.w;
    let by_steer = design.c * turn * (xz - m * x * arm);
    let expected = Coefficients {
        m: bordered(&ridden.m, [xx + m * z * arm, by_steer], [xx + m * z * arm, by_steer, xx + m * arm * arm]),
        c0: bordered(&ridden.c0, [0.0, 0.0], [0.0, 0.0, 7.0]),
        c1: bordered(&ridden.c1, [0.0, 0.0], [0.0, turn * (xz - m * (x + design.c) * arm), 0.0]),
        kc: bordered(&ridden.kc, [0.0, 0.0], [0.0, 0.0, 90.0]),
        k0: bordered(&ridden.k0, [m * arm, 0.0], [m * arm, 0.0, m * arm]),
        k2: bordered(&ridden.k2, [0.0, 0.0], [0.0, -m * arm * turn, 0.0]),
    };
    check_all("with a rider", &found, &expected);
}

/// A matrix with one more column, and one more row that ends in the corner.
fn bordered(inner: &Matrix<f64, 2>, [a, b]: [f64; 2], [c, d, corner]: [f64; 3]) -> Matrix<f64, 3> {
    Matrix::from_row_slice(&[inner[(0, 0)], inner[(0, 1)], a, inner[(1, 0)], inner[(1, 1)], b, c, d, corner])
}

/// Leaning on a round tyre lifts the axle above it by (1 - cos(phi)) of its radius, against the load that it carries.
#[test]
fn round_tyres_raise_the_bicycle() {
    let design = bicycles::named("benchmark");
    let sharp = design.coefficients();
    let (rear_tyre, front_tyre) = (0.03, 0.05);
    let round = linearized(&design, &Extras { rear_tyre, front_tyre, ..Extras::default() });
    let mass = design.mR + design.mB + design.mH + design.mF;
    let front = (design.xB * design.mB + design.xH * design.mH + design.w * design.mF) / design.w;
    let raised = (mass - front) * rear_tyre + front * front_tyre;
    assert!((round.k0[(0, 0)] - sharp.k0[(0, 0)] - raised).abs() <= OFF * sharp.k0.amax(), "{}", round.k0);
    check("K0", &round.k0, &round.k0.transpose());
    check("M", &round.m, &sharp.m);
}

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
        check_all("disc", &found, &Coefficients::from_rows([m, zeros, c1, zeros, k0, zeros]));

        let gravity = 9.81;
        let least = gravity * (radius - tyre) * transverse * mass * radius * radius / (axial * (axial + about_rim));
        for (speed, stable) in [(0.99 * least.sqrt(), false), (1.01 * least.sqrt(), true)] {
            // Yaw is in the equations by its rate alone, which follows the lean: what is left is one oscillator.
            let System { m, c, k } =
                disc.linearized_at(&Drive { independent: [lean, yaw], forward: Some(x), speed, gravity });
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
        [[0.3, 0.0], [0.0, 0.2]],
        zeros,
        [[4.0, 0.0], [0.0, 5.0]],
        [[(m[0] + m[1]) * l[0] + m[1] * l[1], m[1] * l[1]], [m[1] * l[1], m[1] * l[1]]],
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
        [[2.0, 0.0], [0.0, 0.0]],
        zeros,
        [[60.0, 0.0], [0.0, 0.0]],
        [[0.0, 0.0], [0.0, 1.5 * 0.6]],
        zeros,
    ]);
    check_all("cart", &cart.linearized([slide, hinge], None), &expected);
}

/// A body whose moments of inertia are all the same.
fn body(joint: usize, mass: f64, centre: Vector3<f64>, inertia: f64) -> Body {
    Body { joint, mass, centre, inertia: Matrix3::from_diagonal_element(inertia) }
}
