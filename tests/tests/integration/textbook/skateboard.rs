//! The skateboard with a rider who stands still.

#![allow(non_snake_case)] // Names of the field.

use carvallo_tests::textbook::skateboard::{Body, Skateboard};
use nalgebra::Matrix1;

use super::{G, largest_real_part, same};

/// A board, and on it a rider ahead of the middle.
const RIDDEN: [Body; 2] =
    [Body { m: 3.0, x: 0.4, h: 0.05, Ixx: 0.02, Ixz: 0.0 }, Body { m: 72.0, x: 0.45, h: 0.95, Ixx: 9.0, Ixz: -0.3 }];

/// One body of 75 kg; the nonlinear equations of the mechanism with its king pins, from SymPy and with multipliers for
/// the constraints, linearized at 50 digits by central differences.
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
