//! The bicycle: print, generated code and the mechanism agree, and what goes beyond them has the effect that it must.

use carvallo::{Coefficients, Matrix, Model, System};
use carvallo_models::Whipple;
use carvallo_tests::multibody::bicycle::{Bicycle, Extras, Rider};
use carvallo_tests::multibody::dynamics::Drive;
use carvallo_tests::published::{BENCHMARK_2005, BENCHMARK_2007};
use carvallo_tests::{bicycles, designs};
use nalgebra::Vector3;
use proptest::prelude::*;

use super::{OFF, RIDER, check, check_all};

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
        let drive = Drive { speed, gravity, ..Drive::new(independent, forward) };
        let System { m, c, k, .. } = coefficients.at(speed, gravity).unwrap();
        let found = bicycle.mechanism.linearized_at(&drive);
        check("M", &found.m, &m);
        check("C", &found.c, &c);
        check("K", &found.k, &k);
    }
}

/// A rider whose joint does not move is part of the rear frame; the rider's own equation is that of a pendulum with its
/// pivot on a frame that leans, and that yaws by (v delta + c delta') cos(lam) / w while it steers.
#[test]
fn a_rider_is_a_pendulum_on_the_frame() {
    let Rider { mass: m, centre: [x, z], inertia: [xx, _, zz, xz], joint: [_, pivot], .. } = RIDER;
    let design = bicycles::named("benchmark");
    let extras = Extras { steer_stiffness: 3.0, steer_damping: 2.0, rider: Some(RIDER), ..Extras::default() };
    let bicycle = Bicycle::new(&design, &extras);
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
        c0: Matrix::from_diagonal(&Vector3::new(0.0, 2.0, 7.0)),
        c1: bordered(&ridden.c1, [0.0, 0.0], [0.0, turn * (xz - m * (x + design.c) * arm), 0.0]),
        kc: Matrix::from_diagonal(&Vector3::new(0.0, 3.0, 90.0)),
        k0: bordered(&ridden.k0, [m * arm, 0.0], [m * arm, 0.0, m * arm]),
        k2: bordered(&ridden.k2, [0.0, 0.0], [0.0, -m * arm * turn, 0.0]),
        ..Default::default()
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
