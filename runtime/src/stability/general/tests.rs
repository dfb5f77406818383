//! What is critical in more than one way, or in none.

use crate::stability::critical::{Change, CriticalKind};
use crate::stability::ranges::{MarginalRange, StableRange};
use crate::stability::verdict::Verdict;
use crate::stability::{CriticalSpeed, Stability};
use crate::system::{Coefficients, Matrix, States, SystemError};

fn diagonal<const N: usize>(entries: [f64; N]) -> Matrix<f64, N> {
    Matrix::from_diagonal(&entries.into())
}

/// With M = 1.
fn regular<const N: usize>() -> Coefficients<f64, N> {
    Coefficients { m: Matrix::identity(), ..Default::default() }
}

fn stability<const N: usize>(coefficients: &Coefficients<f64, N>) -> Stability {
    let stability = Stability::general(coefficients, 0.0).expect("stability of a regular system");
    assert!(stability.undecided.is_empty(), "{stability:?}");
    stability
}

fn assert_speeds(stability: &Stability, expected: &[(CriticalKind, f64, Change, f64)]) {
    let found = &stability.critical_speeds;
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, &(kind, speed, change, frequency)) in found.iter().zip(expected) {
        assert!(found.kind == kind && found.change == change, "{found:?}");
        assert!((found.speed - speed).abs() <= found.error.max(1e-14 * speed), "{found:?}");
        assert!((found.eigenvalue.im - frequency).abs() <= 1e-7 * frequency, "{found:?}");
    }
}

const WEAVE: CriticalKind = CriticalKind::Weave;
const CAPSIZE: CriticalKind = CriticalKind::Capsize;

/// s^2 + (v - 1) s + 4, s^2 + 3 s + 5 - v^2 and s^2 + s + 7, uncoupled.
#[test]
fn uncoupled_coordinates_are_critical_each_on_its_own() {
    let stability = stability(&Coefficients {
        c0: diagonal([-1.0, 3.0, 1.0]),
        c1: diagonal([1.0, 0.0, 0.0]),
        kc: diagonal([4.0, 5.0, 7.0]),
        k2: diagonal([0.0, -1.0, 0.0]),
        ..regular()
    });
    let root = 5f64.sqrt();
    assert_speeds(&stability, &[(WEAVE, 1.0, Change::Stabilizes, 2.0), (CAPSIZE, root, Change::Destabilizes, 0.0)]);
    assert_eq!(stability.stable_ranges, [StableRange { from: 1.0, to: Some(root) }]);
    assert_eq!([0.5, 1.0, 2.0, 3.0].map(|speed| stability.verdict(speed).unwrap()), {
        [Verdict::Unstable, Verdict::Marginal, Verdict::Stable, Verdict::Unstable]
    });
}

/// Damping (v - 1) of all three: the product of sums has a zero of the third order.
#[test]
fn pairs_that_cross_together_are_all_found() {
    let ones = diagonal([1.0; 3]);
    let stability = stability(&Coefficients { c0: -ones, c1: ones, kc: diagonal([1.0, 4.0, 9.0]), ..regular() });
    let mut frequencies: Vec<f64> = stability.critical_speeds.iter().map(|critical| critical.eigenvalue.im).collect();
    frequencies.sort_by(f64::total_cmp);
    assert_eq!(frequencies, [1.0, 2.0, 3.0]);
    let is_at_one = |critical: &CriticalSpeed| critical.speed == 1.0 && critical.change == Change::Stabilizes;
    assert!(stability.critical_speeds.iter().all(is_at_one), "{stability:?}");
    assert_eq!(stability.stable_ranges, [StableRange { from: 1.0, to: None }]);
}

/// s^2 + d s + 4 +- i (2 v - v^2), whose real part has its extremum at v = 1, where it is zero for d = 1/2.
fn turning(damping: f64) -> Stability {
    let skew = Matrix::<f64, 2>::new(0.0, 1.0, -1.0, 0.0);
    let ones = diagonal([1.0; 2]);
    let coefficients = Coefficients { c0: ones * damping, kc: ones * 4.0, k1: skew * 2.0, k2: -skew, ..regular() };
    Stability::general(&coefficients, 0.0).expect("an answer")
}

#[test]
fn a_pair_that_only_touches_the_axis_is_told_from_one_that_crosses_it_twice() {
    // Beyond v = 2 there is a crossing anyway, where v^2 - 2 v = 2 d.
    let last = |damping: f64| (WEAVE, 1.0 + (1.0 + 2.0 * damping).sqrt(), Change::Destabilizes, 2.0);
    assert_speeds(&turning(0.5), &[(WEAVE, 1.0, Change::Touches, 2.0), last(0.5)]);
    for damping in [0.49_f64, 0.5 * (1.0 - 1e-6), 0.5 * (1.0 - 1e-11)] {
        let distance = (1.0 - 2.0 * damping).sqrt();
        let [enters, leaves] = [1.0 - distance, 1.0 + distance];
        let expected = [(WEAVE, enters, Change::Destabilizes, 2.0), (WEAVE, leaves, Change::Stabilizes, 2.0)];
        assert_speeds(&turning(damping), &[expected[0], expected[1], last(damping)]);
    }
    for damping in [0.51_f64, 0.5 * (1.0 + 1e-6), 0.5 * (1.0 + 1e-11)] {
        assert_speeds(&turning(damping), &[last(damping)]);
    }
}

/// Without damping the eigenvalues are symmetric: s^4 + 5 s^2 + 4 + v^4, and s^2 + 9 beside. Two pairs meet at v^4 = 9/4.
#[test]
fn undamped_motion_is_marginal_up_to_flutter() {
    let k2 = Matrix::<f64, 3>::new(0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    let stability = stability(&Coefficients { kc: diagonal([1.0, 4.0, 9.0]), k2, ..regular() });
    let flutter = 2.25f64.sqrt().sqrt();
    assert_speeds(&stability, &[(CriticalKind::DoubleRoot, flutter, Change::Destabilizes, 2.5f64.sqrt())]);
    assert_eq!(stability.marginal_ranges().len(), 1);
    assert_eq!([0.0, 1.0, 2.0].map(|speed| stability.verdict(speed).unwrap()), {
        [Verdict::Marginal, Verdict::Marginal, Verdict::Unstable]
    });
}

/// Undamped, s^2 + 1 - v^2 and others that stay.
#[test]
fn undamped_motion_diverges_through_a_double_zero() {
    let stability =
        stability(&Coefficients { kc: diagonal([1.0, 4.0, 9.0]), k2: diagonal([-1.0, 0.0, 0.0]), ..regular() });
    assert_speeds(&stability, &[(CAPSIZE, 1.0, Change::Destabilizes, 0.0)]);
    assert_eq!([0.5, 1.5].map(|speed| stability.verdict(speed)), [Ok(Verdict::Marginal), Ok(Verdict::Unstable)]);
}

/// A coordinate that nothing holds has an eigenvalue that is zero at all speeds: marginal at best, unless it is declared to
/// matter by its rate.
#[test]
fn a_zero_eigenvalue_at_all_speeds_is_set_aside() {
    let free = Coefficients {
        c0: diagonal([1.0, -1.0, 1.0]),
        c1: diagonal([0.0, 1.0, 0.0]),
        kc: diagonal([0.0, 4.0, 1.0]),
        ..regular()
    };
    let found = [(WEAVE, 1.0, Change::Stabilizes, 2.0)];
    let marginal = stability(&free);
    assert_speeds(&marginal, &found);
    assert_eq!(marginal.marginal_ranges(), [MarginalRange { from: 1.0, to: None }]);
    let stable = stability(&Coefficients { states: [States::Rate, States::Both, States::Both], ..free });
    assert_speeds(&stable, &found);
    assert_eq!(stable.stable_ranges, [StableRange { from: 1.0, to: None }]);
}

#[test]
fn motion_that_does_not_depend_on_the_speed_has_no_critical_speed() {
    let ones = diagonal([1.0; 3]);
    let damped = stability(&Coefficients { c0: ones, kc: ones, ..regular() });
    assert!(damped.critical_speeds.is_empty());
    assert_eq!(damped.stable_ranges, [StableRange { from: 0.0, to: None }]);
    let free = stability(&regular::<3>());
    assert!(free.critical_speeds.is_empty() && free.stable_ranges.is_empty());
    assert_eq!(free.marginal_ranges(), [MarginalRange { from: 0.0, to: None }]);
}

/// Two of them: s + 2 - v and 2 s + 3.
#[test]
fn coordinates_of_first_order_have_one_eigenvalue_each() {
    let stability = stability(&Coefficients {
        m: Matrix::zeros(),
        c0: diagonal([1.0, 2.0]),
        kc: diagonal([2.0, 3.0]),
        k1: diagonal([-1.0, 0.0]),
        states: [States::Position; 2],
        ..Default::default()
    });
    assert_speeds(&stability, &[(CAPSIZE, 2.0, Change::Destabilizes, 0.0)]);
    assert_eq!(stability.stable_ranges, [StableRange { from: 0.0, to: Some(2.0) }]);
}

#[test]
fn at_rest_there_is_nothing_with_damping_over_the_speed() {
    let ones = diagonal([1.0; 3]);
    let stability = stability(&Coefficients { cm1: ones, kc: ones, ..regular() });
    assert_eq!(stability.verdict(0.0), Err(SystemError::AtRest));
    assert_eq!(stability.verdict(0.1), Ok(Verdict::Stable));
}

#[test]
fn errors_name_what_is_wrong() {
    let ones = diagonal([1.0; 3]);
    let of = |coefficients: &Coefficients<f64, 3>| Stability::new(coefficients, 0.0).expect_err("no answer");
    let singular = Matrix::<f64, 3>::new(1.0, 2.0, 0.0, 2.0, 4.0, 0.0, 0.0, 0.0, 1.0);
    assert_eq!(of(&Coefficients { m: singular, kc: ones, ..Default::default() }), SystemError::SingularMass);
    assert_eq!(of(&Coefficients { kc: ones, ..Default::default() }), SystemError::SingularMass);
    let error = SystemError::NotFinite { quantity: "K1", value: f64::INFINITY };
    assert_eq!(of(&Coefficients { k1: ones * f64::INFINITY, ..regular() }), error);
}

/// Masses in a row that nothing holds: they drift, whatever the speed, and the damping (v - 1) between them crosses zero.
#[test]
fn what_drifts_at_all_speeds_leaves_the_rest_to_be_found() {
    let chain = Matrix::<f64, 3>::new(1.0, -1.0, 0.0, -1.0, 2.0, -1.0, 0.0, -1.0, 1.0);
    let stability = stability(&Coefficients { c0: -chain, c1: chain, kc: chain, ..regular() });
    assert_speeds(&stability, &[(WEAVE, 1.0, Change::Stabilizes, 1.0), (WEAVE, 1.0, Change::Stabilizes, 3f64.sqrt())]);
    assert_eq!(stability.verdict(0.5), Ok(Verdict::Unstable));
    assert_eq!(stability.verdict(2.0), Ok(Verdict::Marginal));
}

/// A car by its place and its heading: y' = v psi makes no force, so that the stiffness is singular at all speeds with a
/// vector that depends on the speed. Another eigenvalue is zero at `L^2 Cf Cr / (m (a Cf - b Cr))`, the square of the speed.
#[test]
fn what_diverges_beside_a_zero_at_all_speeds_is_found() {
    let (m, i, a, b, cf, cr) = (1400.0, 2420.0, 1.14, 1.33, 25000.0, 21000.0);
    let moment = a * cf - b * cr;
    let stability = stability(&Coefficients {
        m: diagonal([m, i]),
        cm1: Matrix::<f64, 2>::new(cf + cr, moment, moment, a * a * cf + b * b * cr),
        kc: Matrix::<f64, 2>::new(0.0, -cf - cr, 0.0, -moment),
        states: [States::Rate, States::Both],
        ..Default::default()
    });
    let critical = (a + b) * f64::sqrt(cf * cr / (m * moment));
    assert_speeds(&stability, &[(CAPSIZE, critical, Change::Destabilizes, 0.0)]);
    let verdicts = [0.9, 1.1].map(|factor| stability.verdict(factor * critical));
    assert_eq!(verdicts, [Ok(Verdict::Marginal), Ok(Verdict::Unstable)]);
}

/// `s^2 + (v - 1) 1e-3 s + 1` beside `s^2 + (1 + v) 1e5 s + 1e5` and `s^2 + 3e4 s + 7e4`: all sums of two eigenvalues that could
/// be zero are small beside the largest eigenvalue at all speeds.
#[test]
fn what_is_slow_beside_the_others_is_not_taken_for_undamped() {
    let stability = stability(&Coefficients {
        c0: diagonal([-1e-3, 1e5, 3e4]),
        c1: diagonal([1e-3, 1e5, 0.0]),
        kc: diagonal([1.0, 1e5, 7e4]),
        ..regular()
    });
    assert_speeds(&stability, &[(WEAVE, 1.0, Change::Stabilizes, 1.0)]);
    assert_eq!([0.5, 2.0].map(|speed| stability.verdict(speed)), [Ok(Verdict::Unstable), Ok(Verdict::Stable)]);
}

/// Entries of any size at random places: what is not decided within the bound is said, and does not take minutes.
#[test]
fn entries_of_any_size_end_the_search() {
    let mut state = 12_u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut entries = |share: f64| {
        Matrix::<f64, 5>::from_fn(|_, _| {
            let (is_there, sign, order) = (random() < share, random() - 0.5, 18.0 * random() - 9.0);
            if is_there { sign.signum() * 10f64.powf(order) } else { 0.0 }
        })
    };
    for _ in 0..2 {
        let coefficients = Coefficients {
            m: entries(1.0),
            cm1: entries(0.3),
            c0: entries(0.5),
            c1: entries(0.5),
            kc: entries(0.7),
            k1: entries(0.3),
            k2: entries(0.5),
            ..Default::default()
        };
        let stability = Stability::general(&coefficients, 0.0).expect("an answer");
        assert!(stability.critical_speeds.iter().all(|critical| critical.speed.is_finite() && critical.speed > 0.0));
    }
}
