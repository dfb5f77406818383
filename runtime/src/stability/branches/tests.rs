//! Branches of uncoupled coordinates, whose eigenvalues are known, and of those that exchange what they are.

use nalgebra::Complex;

use super::{Branches, Meeting};
use crate::characteristic::determinant::Rows;
use crate::stability::{Mode, Stability};
use crate::system::{Coefficients, States};

const ZERO: Rows = [[0.0; 2]; 2];

const fn diagonal(x: f64, y: f64) -> Rows {
    [[x, 0.0], [0.0, y]]
}

fn coefficients(c0: Rows, c1: Rows, kc: Rows, k2: Rows) -> Coefficients<f64, 2> {
    Coefficients::from_rows([diagonal(1.0, 1.0), ZERO, c0, c1, kc, ZERO, ZERO, k2])
}

fn branches<const N: usize>(coefficients: &Coefficients<f64, N>, range: [f64; 2], is_bicycle: bool) -> Branches {
    let critical_speeds = Stability::general(coefficients, 0.0).unwrap().critical_speeds;
    Branches::new(coefficients, 0.0, &critical_speeds, range, is_bicycle).unwrap()
}

/// The roots of s^2 + c s + k.
fn roots(c: f64, k: f64) -> [Complex<f64>; 2] {
    let root = Complex::new(c * c / 4.0 - k, 0.0).sqrt();
    [-root - c / 2.0, root - c / 2.0]
}

/// s^2 + s/5 + 1 + v^2 and s^2 + s/4 + 4: the one passes the other at nearly the same place, at v = sqrt 3.
#[test]
fn pairs_that_pass_each_other_keep_apart() {
    let coefficients = coefficients(diagonal(0.2, 0.25), ZERO, diagonal(1.0, 4.0), diagonal(1.0, 0.0));
    let branches = branches(&coefficients, [0.0, 4.0], false);
    assert_eq!(branches.meetings(), []);
    for speed in [0.0, 1.0, 1.7, 1.73, 1.8, 3.0, 4.0] {
        let values = branches.at(speed).unwrap();
        let expected = [roots(0.2, 1.0 + speed * speed), roots(0.25, 4.0)].concat();
        for value in &values {
            assert_eq!(value.mode, Mode::Oscillatory);
        }
        for (value, expected) in values.iter().zip(expected) {
            let halves = [expected, expected.conj()];
            assert!(halves.iter().any(|half| (value.value - half).norm() < 1e-12), "{speed}: {values:?}");
        }
    }
}

/// With the same damping they coincide there, and both go straight on.
#[test]
fn pairs_that_coincide_go_straight_on() {
    let coefficients = coefficients(diagonal(0.2, 0.2), ZERO, diagonal(1.0, 4.0), diagonal(1.0, 0.0));
    let branches = branches(&coefficients, [0.0, 4.0], false);
    let [Meeting { speed, branches: met }] = branches.meetings() else { panic!("{branches:?}") };
    assert!((speed - 3f64.sqrt()).abs() < 1e-4 && met.len() == 4, "{branches:?}");
    let values = branches.at(3.0).unwrap();
    assert!((values[0].value.im.abs() - (10f64 - 0.01).sqrt()).abs() < 1e-12, "{values:?}");
    assert!((values[2].value.im.abs() - (4f64 - 0.01).sqrt()).abs() < 1e-12, "{values:?}");
}

/// s^2 + (v - 1) s + 4 flutters below v = 1, and is real from v = 5 on; s^2 + 3 s + 5 - v^2 is real from v = sqrt(11)/2 on,
/// and diverges above v = sqrt 5.
#[test]
fn names_hold_between_meetings_and_go_on_where_there_is_no_other() {
    let coefficients = coefficients(diagonal(-1.0, 3.0), diagonal(1.0, 0.0), diagonal(4.0, 5.0), diagonal(0.0, -1.0));
    let branches = branches(&coefficients, [0.0, 6.0], false);
    let meetings: Vec<f64> = branches.meetings().iter().map(|meeting| meeting.speed).collect();
    for (found, expected) in meetings.iter().zip([11f64.sqrt() / 2.0, 5.0]) {
        assert!((found - expected).abs() < 1e-5, "{branches:?}");
    }
    let names = |speed: f64| branches.at(speed).unwrap().iter().map(|value| value.mode).collect::<Vec<_>>();
    for speed in [0.5, 3.0, 5.5] {
        let of = |mode: Mode| names(speed).iter().filter(|&&name| name == mode).count();
        assert_eq!((of(Mode::Divergence), of(Mode::Flutter), of(Mode::Real) + of(Mode::Oscillatory)), (1, 2, 1));
    }
    // The branch that is zero is that which has the name, at every speed.
    let divergence = branches.at(3.0).unwrap().into_iter().find(|value| value.mode == Mode::Divergence).unwrap();
    assert!((divergence.value - roots(3.0, -4.0)[1]).norm() < 1e-12, "{divergence:?}");
}

/// s^2 + (v - 1) s + 1600 oscillates with 40 rad/s, faster than any weave; s^2 + (v - 2) s + 9 with 3 rad/s.
#[test]
fn wobble_is_told_from_weave_by_its_frequency() {
    let coefficients = coefficients(diagonal(-1.0, -2.0), diagonal(1.0, 1.0), diagonal(1600.0, 9.0), ZERO);
    let values = branches(&coefficients, [0.0, 3.0], true).at(0.0).unwrap();
    let modes: Vec<(Mode, i64)> = values.iter().map(|value| (value.mode, value.value.im.round() as i64)).collect();
    assert_eq!(modes, [(Mode::Weave, -3), (Mode::Weave, 3), (Mode::Wobble, -40), (Mode::Wobble, 40)]);
}

/// s + 1 + v, of a coordinate of first order, and s - 1 + v, of one by its rate.
#[test]
fn coordinates_of_one_state_have_one_branch() {
    let mut coefficients = Coefficients::<f64, 2> {
        states: [States::Position, States::Rate],
        ..coefficients(diagonal(1.0, -1.0), diagonal(0.0, 1.0), diagonal(1.0, 0.0), ZERO)
    };
    coefficients.m[(0, 0)] = 0.0;
    coefficients.k1[(0, 0)] = 1.0;
    let branches = branches(&coefficients, [0.0, 3.0], false);
    let values = branches.at(2.0).unwrap();
    let found: Vec<_> = values.iter().map(|value| (value.mode, value.value.re)).collect();
    assert_eq!(found, [(Mode::Divergence, -1.0), (Mode::Real, -3.0)]);
}

/// Beyond what was followed the order is the same.
#[test]
fn they_are_followed_beyond_the_range_from_its_end() {
    let coefficients = coefficients(diagonal(0.2, 0.25), ZERO, diagonal(1.0, 4.0), diagonal(1.0, 0.0));
    let [short, long] = [1.0, 9.0].map(|to| branches(&coefficients, [0.0, to], false).at(8.0).unwrap());
    assert_eq!(short, long);
}

/// Undamped, s^4 + 5 s^2 + 4 + v^4: two pairs meet on the axis at v^4 = 9/4 and one of them grows from there on.
#[test]
fn pairs_that_meet_on_the_axis_flutter() {
    let coefficients = Coefficients::<f64, 2>::from_rows([
        diagonal(1.0, 1.0),
        ZERO,
        ZERO,
        ZERO,
        diagonal(1.0, 4.0),
        ZERO,
        ZERO,
        [[0.0, 1.0], [-1.0, 0.0]],
    ]);
    let values = branches(&coefficients, [0.0, 2.0], false).at(0.5).unwrap();
    assert!(values.iter().all(|value| value.mode == Mode::Flutter), "{values:?}");
}
