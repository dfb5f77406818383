//! The bicycle on tyres of circular cross-section.

#![allow(non_snake_case)] // Names of the field.

use carvallo::{Coefficients, Model};
use carvallo_models::Whipple;
use carvallo_tests::textbook::{disc::Disc, tyres};
use carvallo_tests::{bicycles, designs, hand_written};
use nalgebra::Matrix2;
use proptest::prelude::*;

use super::{G, same};

proptest! {
    #![proptest_config(designs::config(100))]

    #[test]
    fn tyres_without_a_crown_are_edges(design in designs::any()) {
        let (edge, found) = (hand_written::matrices(&design), tyres::matrices(&design, 0.0, 0.0));
        prop_assert_eq!(found, Coefficients::from(edge));
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
    let values: Vec<f64> = Whipple::INFO
        .parameters
        .iter()
        .map(|parameter| if ["w", "rR", "rF"].contains(&parameter.name) { 1.0 } else { 0.0 })
        .collect();
    Whipple::from_slice(&values).unwrap()
}
