//! Bicycles from their bodies: against Appendix A, published models of more than it holds, and nonlinear dynamics.

#![allow(non_snake_case)] // The names are the models'.

use carvallo::{Coefficients, Model, Stability};
use carvallo_models::{RearSteered, Whipple, WhippleLeaning, WhippleMechanism, WhippleSprung, WhippleTyres};
use carvallo_tests::multibody::bicycle::{Bicycle, Extras, Rider};
use carvallo_tests::textbook::{rider, tyres};
use carvallo_tests::{bicycles, designs, published};
use nalgebra::{Matrix2, Matrix3};

use super::assert_close;

/// A part of the largest entry that rounding may take.
const ROUNDING: f64 = 1e-11;
/// What the differences of the nonlinear dynamics may be off.
const DIFFERENCES: f64 = 1e-6;

/// The matrices by hand, after Appendix A.
pub fn by_hand(design: &Whipple) -> Coefficients<f64, 2> {
    carvallo_tests::hand_written::matrices(design).into()
}

fn mechanism(design: &Whipple) -> WhippleMechanism {
    WhippleMechanism::from_array(design.to_array())
}

/// A model whose parameters begin with those of the bicycle.
fn extended<const N: usize, M: Model<N, Scalar = f64>>(design: &Whipple, more: &[f64]) -> M {
    M::from_slice(&[&design.to_array()[..], more].concat()).expect("as many parameters")
}

#[test]
fn both_benchmarks_have_their_published_digits() {
    for (benchmark, published) in
        [(Whipple::BENCHMARK, published::BENCHMARK_2007), (Whipple::BENCHMARK_2005, published::BENCHMARK_2005)]
    {
        let Coefficients { m, c1, k0, k2, .. } = mechanism(&benchmark).coefficients();
        for (matrix, printed) in [m, c1, k0 * published.gravity, k2].iter().zip(published.matrices) {
            for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let (found, text) = (matrix[(row, column)], printed[row][column]);
                let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
                let printed: f64 = text.parse().expect("a number");
                let allowed = published.units * 10f64.powi(-(decimals as i32)) + 4.0 * f64::EPSILON * printed.abs();
                assert!((found - printed).abs() <= allowed, "{found} {text}");
            }
        }
    }
}

#[test]
fn every_bicycle_and_random_designs_are_those_of_appendix_a_and_of_nonlinear_dynamics() {
    let all = bicycles::all();
    assert!(all.len() >= 10);
    for (name, design) in all {
        let found = mechanism(&design).coefficients();
        assert_close(&found, &by_hand(&design), ROUNDING, name);
        let bicycle = Bicycle::new(&design, &Extras::default());
        let coordinates = [bicycle.root.lean, bicycle.steer];
        assert_close(&found, &bicycle.mechanism.linearized(coordinates, Some(bicycle.root.x)), DIFFERENCES, name);
    }
    for number in 0..1_000 {
        let design = designs::numbered(number);
        assert_close(&mechanism(&design).coefficients(), &by_hand(&design), ROUNDING, &format!("design {number}"));
    }
}

#[test]
fn a_front_assembly_without_mass_is_no_mistake_any_more() {
    let design = Whipple { mH: 0.0, mF: 0.0, ..Whipple::BENCHMARK };
    assert!(design.validate().is_err(), "Appendix A divides by its mass");
    let found = mechanism(&design);
    assert_eq!(found.validate(), Ok(()));
    let bicycle = Bicycle::new(&design, &Extras::default());
    let expected = bicycle.mechanism.linearized([bicycle.root.lean, bicycle.steer], Some(bicycle.root.x));
    assert_close(&found.coefficients(), &expected, DIFFERENCES, "massless");
}

#[test]
fn a_steering_spring_and_damper_add_one_term_each() {
    for (name, design) in bicycles::all() {
        let (k, d) = (3.5, 0.75);
        let mut expected = by_hand(&design);
        expected.kc = Matrix2::new(0.0, 0.0, 0.0, k);
        expected.c0 = Matrix2::new(0.0, 0.0, 0.0, d);
        let found: WhippleSprung = extended(&design, &[k, d]);
        assert_close(&found.coefficients(), &expected, ROUNDING, name);
        let extras = Extras { steer_stiffness: k, steer_damping: d, ..Extras::default() };
        let bicycle = Bicycle::new(&design, &extras);
        let numeric = bicycle.mechanism.linearized([bicycle.root.lean, bicycle.steer], Some(bicycle.root.x));
        assert_close(&found.coefficients(), &numeric, DIFFERENCES, name);
    }
}

#[test]
fn tyres_are_those_of_the_extended_model_and_knife_edges_without_a_radius() {
    for (name, design) in bicycles::all() {
        let knife: WhippleTyres = extended(&design, &[0.0, 0.0]);
        assert_close(&knife.coefficients(), &by_hand(&design), ROUNDING, name);
        let (rear, front) = (0.03, 0.05);
        let found: WhippleTyres = extended(&design, &[rear, front]);
        let found = found.coefficients();
        assert_close(&found, &tyres::matrices(&design, rear, front), ROUNDING, name);
        let extras = Extras { rear_tyre: rear, front_tyre: front, ..Extras::default() };
        let bicycle = Bicycle::new(&design, &extras);
        let numeric = bicycle.mechanism.linearized([bicycle.root.lean, bicycle.steer], Some(bicycle.root.x));
        assert_close(&found, &numeric, DIFFERENCES, name);
    }
}

/// The upper body of the example, as the rider of the textbook and of the nonlinear model, and as parameters.
struct Upper {
    textbook: rider::UpperBody,
    numeric: Rider,
    /// Mass, centre of mass and moments of inertia.
    body: [f64; 7],
    parameters: [f64; 10],
}

fn upper(stiffness: f64, damping: f64) -> Upper {
    let [zP, m, x, z, xx, yy, zz, xz] = [-0.85, 40.0, 0.35, -1.125, 1.6, 1.7, 0.6, 0.1];
    let textbook = rider::UpperBody { h: -zP, m, x, z, Ixx: xx, Izz: zz, Ixz: xz, stiffness, damping };
    let inertia = [xx, yy, zz, xz];
    let numeric = Rider { mass: m, centre: [x, z], inertia, joint: [0.0, zP], stiffness, damping };
    let body = [m, x, z, xx, yy, zz, xz];
    Upper { textbook, numeric, body, parameters: [zP, m, x, z, xx, yy, zz, xz, stiffness, damping] }
}

#[test]
fn a_leaning_rider_is_that_of_moore_and_of_nonlinear_dynamics() {
    for (name, design) in bicycles::all() {
        let upper = upper(128.0, 50.0);
        let found: WhippleLeaning = extended(&design, &upper.parameters);
        let found = found.coefficients();
        assert_close(&found, &rider::matrices(&design, &upper.textbook), ROUNDING, name);
        let bicycle = Bicycle::new(&design, &Extras { rider: Some(upper.numeric), ..Extras::default() });
        let lean = bicycle.rider.expect("a rider");
        let coordinates = [bicycle.root.lean, bicycle.steer, lean];
        assert_close(&found, &bicycle.mechanism.linearized(coordinates, Some(bicycle.root.x)), DIFFERENCES, name);
    }
}

/// The rear frame and the upper body as one.
pub fn rigid(design: &Whipple, [m, x, z, xx, _, zz, xz]: [f64; 7]) -> Whipple {
    let mass = design.mB + m;
    let centre = |frame: f64, upper: f64| (design.mB * frame + m * upper) / mass;
    let (xB, zB) = (centre(design.xB, x), centre(design.zB, z));
    let moment = |frame: f64, upper: f64, one: [f64; 2], other: [f64; 2]| {
        frame + upper + design.mB * one[0] * one[1] + m * other[0] * other[1]
    };
    let (frame, upper) = ([design.xB - xB, design.zB - zB], [x - xB, z - zB]);
    Whipple {
        mB: mass,
        xB,
        zB,
        IBxx: moment(design.IBxx, xx, [frame[1]; 2], [upper[1]; 2]),
        IBzz: moment(design.IBzz, zz, [frame[0]; 2], [upper[0]; 2]),
        IBxz: moment(design.IBxz, xz, [-frame[0], frame[1]], [-upper[0], upper[1]]),
        ..*design
    }
}

#[test]
fn a_rider_who_does_not_lean_is_part_of_the_frame() {
    for (name, design) in bicycles::all() {
        let upper = upper(0.0, 0.0);
        let found: WhippleLeaning = extended(&design, &upper.parameters);
        let locked = found.coefficients();
        let block = |matrix: Matrix3<f64>| matrix.fixed_view::<2, 2>(0, 0).into_owned();
        let locked = Coefficients {
            m: block(locked.m),
            c0: block(locked.c0),
            c1: block(locked.c1),
            kc: block(locked.kc),
            k0: block(locked.k0),
            k2: block(locked.k2),
            ..Default::default()
        };
        assert_close(&locked, &by_hand(&rigid(&design, upper.body)), ROUNDING, name);
    }
}

#[test]
fn without_damper_and_speed_a_leaning_rider_conserves_energy() {
    for (name, design) in bicycles::all() {
        let found: WhippleLeaning = extended(&design, &upper(300.0, 0.0).parameters);
        let Coefficients { m, c0, kc, k0, .. } = found.coefficients();
        // Then the energy (q' M q' + q (Kc + g K0) q)/2 has the rate -q' C0 q' = 0.
        assert_eq!(c0, Matrix3::zeros(), "{name}");
        for matrix in [m, kc, k0] {
            assert_eq!(matrix, matrix.transpose(), "{name}");
        }
        assert!(m.cholesky().is_some(), "{name}: every motion has a kinetic energy");
    }
}

#[test]
fn the_two_mass_skate_is_stable_above_its_published_speed() {
    // Kooijman, Meijaard, Papadopoulos, Ruina & Schwab (2011), Science 332, 339-342: no gyroscopic effect, no trail, and
    // stable above 2.8 m/s.
    let skate = WhippleMechanism::TWO_MASS_SKATE;
    assert_eq!(skate.validate(), Ok(()));
    let stability = Stability::new(&skate.coefficients(), skate.g).expect("it moves");
    let [range] = &stability.stable_ranges[..] else { panic!("{:?}", stability.stable_ranges) };
    assert_eq!((format!("{:.1}", range.from), range.to), ("2.8".into(), None));
}

#[test]
fn rear_steering_is_a_bicycle_run_backwards() {
    for (name, design) in bicycles::all() {
        let found = RearSteered::from_array(design.to_array()).coefficients();
        // Seen from the other end, to the right is to the left: the lean changes its sign, the steer does not. Backwards
        // v is negative.
        let turned = Matrix2::new(-1.0, 0.0, 0.0, 1.0);
        let Coefficients { m, c0, c1, kc, k0, k2, .. } = by_hand(&design);
        let [m, c0, c1, kc, k0, k2] = [m, c0, -c1, kc, k0, k2].map(|matrix| turned * matrix * turned);
        assert_close(&found, &Coefficients { m, c0, c1, kc, k0, k2, ..Default::default() }, ROUNDING, name);
    }
}
