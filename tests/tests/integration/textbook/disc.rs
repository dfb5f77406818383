//! A wheel on its own.

#![allow(non_snake_case)] // Names of the field.

use carvallo_tests::textbook::disc::Disc;
use nalgebra::Matrix2;

use super::{G, largest_real_part, same};

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
/// There (3/2 R^2 + 2 R r + 13/8 r^2) phi'' = g R phi + (2 R^2 + 2 R r + 7/4 r^2) u6 u7 with the spin u6 and the yaw
/// rate u7, and (R^2 / 2 + 5/8 r^2) u7' = -(R^2 + 3/4 r^2) u6 phi'.
fn torus_square(major: f64, minor: f64) -> f64 {
    let [major2, minor2] = [major * major, minor * minor];
    let roll = 2.0 * major2 + 2.0 * major * minor + 1.75 * minor2;
    let yaw = (major2 + 0.75 * minor2) / (0.5 * major2 + 0.625 * minor2);
    let spin2 = G * major / (roll * yaw);
    spin2 * (major + minor) * (major + minor)
}
