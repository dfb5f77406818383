//! The mechanisms of books and papers, held against what else is known of them.

#![allow(non_snake_case)] // Names of the field.

use carvallo::{Coefficients, Matrix, Model};
use carvallo_models::Whipple;
use carvallo_tests::textbook::disc::Disc;
use carvallo_tests::textbook::pendulum::{Link, standing, standing_at_hinges};
use carvallo_tests::textbook::skateboard::{Body, Skateboard};
use carvallo_tests::textbook::tyres;
use carvallo_tests::{bicycles, designs, hand_written};
use nalgebra::{Matrix1, Matrix2};
use proptest::prelude::*;

const G: f64 = 9.81;

/// Fails if an entry is off by more than 4 epsilons of the largest entry.
fn same<const N: usize>(found: Matrix<f64, N>, expected: Matrix<f64, N>, what: &str) {
    let off = (found - expected).amax();
    assert!(off <= 4.0 * f64::EPSILON * expected.amax(), "{what} is {found} instead of {expected}");
}

fn largest_real_part<const N: usize>(coefficients: &Coefficients<f64, N>, speed: f64) -> f64 {
    let eigenvalues = coefficients.at(speed, G).unwrap().eigenvalues().unwrap();
    eigenvalues.iter().map(|value| value.re).fold(f64::NEG_INFINITY, f64::max)
}

proptest! {
    #![proptest_config(designs::config(100))]

    #[test]
    fn tyres_without_a_crown_are_edges(design in designs::any()) {
        let (edge, found) = (hand_written::matrices(&design), tyres::matrices(&design, 0.0, 0.0));
        let zero = [[0.0; 2]; 2];
        prop_assert_eq!(found, Coefficients::from_rows([edge.m, zero, edge.c1, zero, edge.k0, edge.k2]));
    }

    /// On balls it leans about their centres: all heights count from there, whatever the load on each.
    #[test]
    fn on_balls_of_one_size_a_bicycle_leans_about_their_centres(design in designs::any(), r in 0.05..0.5) {
        let design = Whipple { rR: r, rF: r, ..design };
        let heights = [(design.mB, -design.zB), (design.mH, -design.zH)].map(|(mass, height)| mass * (height - r));
        let found = tyres::matrices(&design, r, r).k0[(0, 0)];
        let size = heights[0].abs() + heights[1].abs() + (design.mR + design.mF) * r;
        prop_assert!((found + heights[0] + heights[1]).abs() <= 1e-13 * size, "{found} against {heights:?}");
    }
}

/// The benchmark bicycle on crowns of 3 and 5 cm, at 5 m/s and g = 9.81: the nonlinear equations of its four bodies on
/// tori, from SymPy and with multipliers for the constraints, linearized at 50 digits by central differences.
#[test]
fn a_bicycle_on_tyres_has_the_linearization_of_its_nonlinear_equations() {
    let found = tyres::matrices(&bicycles::named("benchmark"), 0.03, 0.05).at(5.0, G).unwrap();
    let m = Matrix2::new(80.81722, 2.319413322087091, 2.319413322087091, 0.2978418819968555);
    let c = Matrix2::new(0.0, 169.3320695746247, -4.251782072848922, 8.427019869877984);
    let k = Matrix2::new(-760.2692294117647, 1894.2113894207125, -20.722257972593074, 59.954351073298);
    same(found.m, m, "M");
    same(found.c, c, "C");
    same(found.k, k, "K");
}

/// With a vertical steer axis through the front contact, and nothing but two equal wheels, each goes its own way: the
/// lean of both is that of two discs, and steering is the yaw of one.
#[test]
fn a_bicycle_of_two_wheels_alone_is_two_discs() {
    let disc = Disc { m: 3.0, r: 0.35, rho: 0.06, Ia: 0.28, It: 0.15 };
    let Disc { m, r, rho, Ia, It } = disc;
    let wheels = Whipple { w: 1.1, rR: r, mR: m, IRxx: It, IRyy: Ia, rF: r, mF: m, IFxx: It, IFyy: Ia, ..massless() };
    let bicycle = tyres::matrices(&wheels, rho, rho);
    let one = disc.matrices();
    for (bicycle, one) in [(bicycle.m, one.m), (bicycle.k0, one.k0)] {
        assert!((bicycle[(0, 0)] - 2.0 * one[(0, 0)]).abs() < 1e-15);
        assert!((bicycle[(1, 1)] - one[(1, 1)]).abs() < 1e-15);
    }
    assert!((bicycle.c1[(1, 0)] - one.c1[(1, 0)]).abs() < 1e-15);
}

/// A bicycle of nothing: a wheel base and radii of 1 m.
fn massless() -> Whipple {
    let values: Vec<f64> = Whipple::<f64>::INFO
        .parameters
        .iter()
        .map(|parameter| if ["w", "rR", "rF"].contains(&parameter.name) { 1.0 } else { 0.0 })
        .collect();
    Whipple::from_slice(&values).unwrap()
}

/// SymPy's test `test_linearize_rolling_disc_kane`: m = g = r = 1, and v = -q3'.
#[test]
fn the_uniform_disc_accelerates_as_in_sympy() {
    let disc = Disc { m: 1.0, r: 1.0, rho: 0.0, Ia: 0.5, It: 0.25 }.matrices().at(1.0, 1.0).unwrap();
    let inverse = disc.m.try_inverse().unwrap();
    same(-inverse * disc.k, Matrix2::new(4.0 / 5.0, 0.0, 0.0, 0.0), "what lean and yaw do");
    same(-inverse * disc.c, Matrix2::new(0.0, -6.0 / 5.0, 2.0, 0.0), "what their rates do");
}

#[test]
fn discs_stay_upright_above_their_published_critical_speeds() {
    let [m, r] = [2.5, 0.4];
    let uniform = Disc { m, r, rho: 0.0, Ia: m * r * r / 2.0, It: m * r * r / 4.0 };
    let hoop = Disc { Ia: m * r * r, It: m * r * r / 2.0, ..uniform };
    // A solid torus, by the textbook moments of inertia: 0.3 m to the middle of its tube, and half of it around that.
    let (major, minor) = (0.3, 0.1_f64);
    let torus = Disc {
        m,
        r,
        rho: minor,
        Ia: m * (major * major + 0.75 * minor * minor),
        It: m * (0.5 * major * major + 0.625 * minor * minor),
    };
    for (disc, square) in [(uniform, G * r / 3.0), (hoop, G * r / 4.0), (torus, torus_square(major, minor))] {
        let critical = square.sqrt();
        assert!((disc.critical_speed(G) - critical).abs() <= 4.0 * f64::EPSILON * critical);
        assert!(largest_real_part(&disc.matrices(), 0.99 * critical) > 0.1);
        assert!(largest_real_part(&disc.matrices(), 1.01 * critical) < 1e-5);
    }
}

/// The square of the speed at which the lean of Peterson's Rolling-Torus, linearized, has no stiffness.
///
/// There (3/2 R^2 + 2 R r + 13/8 r^2) phi'' = g R phi + (2 R^2 + 2 R r + 7/4 r^2) u6 u7 with the spin u6 and the yaw rate
/// u7, and (R^2 / 2 + 5/8 r^2) u7' = -(R^2 + 3/4 r^2) u6 phi'.
fn torus_square(major: f64, minor: f64) -> f64 {
    let [major2, minor2] = [major * major, minor * minor];
    let roll = 2.0 * major2 + 2.0 * major * minor + 1.75 * minor2;
    let yaw = (major2 + 0.75 * minor2) / (0.5 * major2 + 0.625 * minor2);
    let spin2 = G * major / (roll * yaw);
    spin2 * (major + minor) * (major + minor)
}

/// A board, and on it a rider ahead of the middle.
const RIDDEN: [Body; 2] =
    [Body { m: 3.0, x: 0.4, h: 0.05, Ixx: 0.02, Ixz: 0.0 }, Body { m: 72.0, x: 0.45, h: 0.95, Ixx: 9.0, Ixz: -0.3 }];

/// One body of 75 kg; the nonlinear equations of the mechanism with its king pins, from SymPy and with multipliers for the
/// constraints, linearized at 50 digits by central differences.
#[test]
fn a_skateboard_has_the_linearization_of_its_nonlinear_equations() {
    let bodies = [Body { m: 75.0, x: 0.45, h: 0.9, Ixx: 9.0, Ixz: -0.3 }];
    let board = Skateboard { L: 0.8, lamF: 0.9, lamR: 0.6, k: 120.0, bodies: &bodies };
    let found = board.matrices();
    for (speed, c, k) in [(1.0, 26.914106566564325, -378.12510719035987), (5.0, 134.57053283282164, 3559.0723202410036)]
    {
        let found = found.at(speed, G).unwrap();
        same(found.m, Matrix1::new(69.75), "M");
        same(found.c, Matrix1::new(c), "C");
        same(found.k, Matrix1::new(k), "K");
    }
    assert!((board.critical_speed(G) - 1.8179493058109366).abs() < 1e-14);
}

/// A rigid body is the sum of its parts.
#[test]
fn a_rider_and_a_board_are_as_one_body() {
    let mass: f64 = RIDDEN.iter().map(|body| body.m).sum();
    let mean = |of: fn(&Body) -> f64| RIDDEN.iter().map(|body| body.m * of(body)).sum::<f64>() / mass;
    let (x, h) = (mean(|body| body.x), mean(|body| body.h));
    // About the common centre; z = -h.
    let Ixx = RIDDEN.iter().map(|body| body.Ixx + body.m * (body.h - h).powi(2)).sum();
    let Ixz = RIDDEN.iter().map(|body| body.Ixz + body.m * (body.x - x) * (body.h - h)).sum();
    let one = [Body { m: mass, x, h, Ixx, Ixz }];
    let board = Skateboard { L: 0.8, lamF: 0.8, lamR: 0.7, k: 150.0, bodies: &RIDDEN };
    let [two, one] = [board, Skateboard { bodies: &one, ..board }].map(|board| board.matrices().at(3.0, G).unwrap());
    for (two, one) in [(two.m, one.m), (two.c, one.c), (two.k, one.k)] {
        assert!((two - one).amax() <= 1e-13 * one.amax(), "{two} and {one}");
    }
}

/// Hubbard (1979): a speed above which inertia stabilizes. Varszegi et al. (2016): better ahead of the middle.
#[test]
fn a_skateboard_is_stable_above_its_critical_speed_with_the_rider_ahead_of_the_middle() {
    let board = Skateboard { L: 0.8, lamF: 0.8, lamR: 0.8, k: 150.0, bodies: &RIDDEN };
    let critical = board.critical_speed(G);
    assert!(largest_real_part(&board.matrices(), 0.99 * critical) > 0.0);
    assert!(largest_real_part(&board.matrices(), 1.01 * critical) < 0.0);

    let behind = RIDDEN.map(|body| Body { x: 0.8 - body.x, Ixz: -body.Ixz, ..body });
    let behind = Skateboard { bodies: &behind, ..board };
    assert!(largest_real_part(&behind.matrices(), 1.01 * critical) > 0.0);
    // Backwards, the rear is the front.
    assert!(largest_real_part(&behind.matrices(), -1.01 * critical) < 0.0);
}

/// Kibble & Berkshire, eq. 11.21, with the mass M on L above and m on l below.
#[test]
fn a_double_pendulum_has_the_published_frequencies() {
    let [upper, lower] = [(1.3, 0.7), (0.4, 1.9)].map(|(m, l)| Link { l, a: l, m, i: 0.0 });
    let found = squared_frequencies(&standing([upper, lower]));
    let ratio = (upper.m + lower.m) / upper.m;
    let sum = ratio * (G / upper.l + G / lower.l);
    let product = ratio * G * G / (upper.l * lower.l);
    assert!((found[0] + found[1] - sum).abs() < 1e-13 * sum);
    assert!((found[0] * found[1] - product).abs() < 1e-13 * product);
}

/// Riley, Hobson & Bence, problem 9.7: T = M l^2 (8/3 q1'^2 + 2 q1' q2' + 2/3 q2'^2), V = M g l (3/2 q1^2 + 1/2 q2^2) for
/// two rods of the mass M and the length 2 l each, hanging.
#[test]
fn two_equal_rods_have_the_published_energies() {
    let [mass, l] = [2.0, 0.3];
    let rod = Link { l: 2.0 * l, a: l, m: mass, i: mass * (2.0 * l).powi(2) / 12.0 };
    let found = standing([rod, rod]);
    same(found.m, Matrix2::new(16.0 / 3.0, 2.0, 2.0, 4.0 / 3.0) * (mass * l * l), "M");
    same(found.k0, Matrix2::new(-3.0, 0.0, 0.0, -1.0) * (mass * l), "K0");
}

/// Abramowitz & Stegun, table 25.9: the zeros of Laguerre's polynomials of degrees 1 to 5.
#[test]
fn equal_weights_on_equal_strings_swing_at_the_zeros_of_the_polynomials_of_laguerre() {
    let weight = Link { l: 0.5, a: 0.5, m: 0.7, i: 0.0 };
    check([weight], &[1.0]);
    check([weight; 2], &[0.585786437627, 3.414213562373]);
    check([weight; 3], &[0.415774556783, 2.294280360279, 6.289945082937]);
    check([weight; 4], &[0.322547689619, 1.745761101158, 4.536620296921, 9.395070912301]);
    check([weight; 5], &[0.263560319718, 1.413403059107, 3.596425771041, 7.085810005859, 12.640800844276]);

    fn check<const N: usize>(links: [Link; N], zeros: &[f64]) {
        for coefficients in [standing(links), standing_at_hinges(links)] {
            for (found, zero) in squared_frequencies(&coefficients).into_iter().zip(zeros) {
                assert!((found * links[0].l / G - zero).abs() <= 1e-12 * zeros[N - 1], "{found} instead of {zero} g/l");
            }
        }
    }
}

/// The angles at the hinges of a chain of different links: what one hinge's torque does is what the parts above do.
#[test]
fn at_the_hinges_the_uppermost_feels_its_own_link_and_the_lowest_all_as_one_body() {
    let links = [(0.9, 0.4, 3.0, 0.2), (0.7, 0.3, 2.0, 0.1), (0.5, 0.2, 1.0, 0.05)];
    let links = links.map(|(l, a, m, i)| Link { l, a, m, i });
    let found = standing_at_hinges(links);
    // By the parallel axis theorem, the heights of the centres above the lowest hinge.
    let heights = [0.4, 0.9 + 0.3, 0.9 + 0.7 + 0.2];
    let parts = links.into_iter().zip(heights);
    let whole: f64 = parts.clone().map(|(link, height)| link.i + link.m * height * height).sum();
    let moment: f64 = parts.map(|(link, height)| link.m * height).sum();
    assert!((found.m[(0, 0)] - whole).abs() < 1e-14 * whole);
    assert!((found.k0[(0, 0)] + moment).abs() < 1e-14 * moment);
    assert!((found.m[(2, 2)] - (0.05 + 1.0 * 0.2 * 0.2)).abs() < 1e-15);
    assert!((found.k0[(2, 2)] + 1.0 * 0.2).abs() < 1e-15);
}

/// The squared frequencies of the chain when it hangs, in increasing order.
fn squared_frequencies<const N: usize>(standing: &Coefficients<f64, N>) -> Vec<f64> {
    let eigenvalues = standing.at(0.0, -G).unwrap().eigenvalues().unwrap();
    let mut squares: Vec<f64> =
        eigenvalues.iter().filter(|value| value.im > 0.0).map(|value| value.im * value.im).collect();
    squares.sort_by(f64::total_cmp);
    assert_eq!(squares.len(), N, "{eigenvalues:?}");
    squares
}
