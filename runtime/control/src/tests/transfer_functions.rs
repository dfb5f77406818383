//! Zeros, poles and gains, against those that `transfer_functions.py` finds with 60 digits from exact determinants.

use carvallo::Complex;

use super::{benchmark, design, state_space};
use crate::{StateSpace, TransferFunction};

/// The most by which roots may differ, relative to the largest of them: doubles, and the condition of what is asked.
const BOUND: f64 = 1e-12;

pub fn roots(text: &str) -> Vec<Complex<f64>> {
    let number = |text: &str| text.parse::<f64>().expect("a number");
    let root = |(re, im): (&str, &str)| Complex::new(number(re), number(im));
    text.split_whitespace().map(|pair| root(pair.split_once(',').expect("two parts"))).collect()
}

#[track_caller]
fn assert_roots(what: &str, found: &[Complex<f64>], expected: &[Complex<f64>]) {
    assert_roots_among(what, found, expected, expected);
}

/// Each has its own counterpart, to what the largest of some numbers has of rounding; those at zero exactly.
#[track_caller]
pub fn assert_roots_among(what: &str, found: &[Complex<f64>], expected: &[Complex<f64>], all: &[Complex<f64>]) {
    assert_eq!(found.len(), expected.len(), "{what}: {found:?} are not {expected:?}");
    let at_rest = |roots: &[Complex<f64>]| roots.iter().filter(|root| root.norm() == 0.0).count();
    assert_eq!(at_rest(found), at_rest(expected), "{what}: {found:?} are not {expected:?}");
    let largest = all.iter().map(|root| root.norm()).fold(0.0, f64::max);
    let mut left = found.to_vec();
    for root in expected {
        let distance = |place: &usize| (left[*place] - root).norm();
        let nearest = (0..left.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).expect("a root");
        assert!(distance(&nearest) <= BOUND * largest, "{what}: {} is not {root}", left[nearest]);
        left.remove(nearest);
    }
}

#[test]
fn zeros_poles_and_gains_are_those_of_exact_determinants() {
    let lines = include_str!("transfer_functions.tsv").lines().filter(|line| !line.starts_with('#'));
    assert_eq!(lines.clone().count(), 32);
    for line in lines {
        let [model, set, speed, input, output, gain, zeros, poles] = line.split('\t').collect::<Vec<_>>()[..] else {
            panic!("eight columns: {line}");
        };
        let what = format!("{model} {set} at {speed} from {input} to {output}");
        let space = state_space(&design(model, set), speed.parse().expect("a speed"), &[input], &[output]);
        // Without what cancels at zero, as integrals of what the output does not depend on.
        let found = TransferFunction::new(&space, 0, 0).expect("a transfer function").minimal();
        let gain: f64 = gain.parse().expect("a gain");
        assert!((found.gain - gain).abs() <= 1e-12 * gain.abs(), "{what}: {} is not {gain}", found.gain);
        assert_roots(&format!("{what}: zeros"), &found.zeros, &roots(zeros));
        assert_roots(&format!("{what}: poles"), &found.poles, &roots(poles));
    }
}

/// What steers the bicycle has its zeros where a bicycle that cannot steer has its poles: sqrt(-g K0 / M) of the lean, at every
/// speed.
#[test]
fn steer_has_zeros_where_lean_alone_has_poles() {
    let falling = (9.81_f64 * 80.95 / 80.81722).sqrt();
    for speed in [0.0, 0.1, 4.0, 12.0] {
        let space = state_space(&benchmark(), speed, &["Tdelta"], &["delta"]);
        let zeros = TransferFunction::new(&space, 0, 0).expect("a transfer function").zeros;
        assert_eq!(zeros.len(), 2);
        assert!((zeros[0].re + falling).abs() < 1e-13 && (zeros[1].re - falling).abs() < 1e-13, "{zeros:?}");
    }
}

/// The yaw and the place follow from lean and steer, so that their transfer functions have poles at zero; a zero of the right half
/// plane is what makes a rider steer left to go right.
#[test]
fn integrals_have_poles_that_are_exactly_zero() {
    let space = state_space(&benchmark(), 6.0, &["Tdelta"], &["y", "psi_rate"]);
    let place = TransferFunction::new(&space, 0, 0).expect("a transfer function");
    assert_eq!(place.poles.iter().filter(|pole| **pole == Complex::new(0.0, 0.0)).count(), 2);
    assert!(place.zeros.iter().any(|zero| zero.re > 0.0) && place.static_gain().is_none());
    let yaw_rate = TransferFunction::new(&space, 0, 1).expect("a transfer function");
    // Both integrals are states of the whole, of which this output needs none.
    assert_eq!((space.a.nrows(), yaw_rate.poles.len()), (6, 4));
}

/// A mode of decoupled oscillators that the input does not reach is a pole that a zero cancels.
#[test]
fn hidden_modes_are_cancelled() {
    let mut space = state_space(&design("Pendulum", "seconds"), 0.0, &["Ttheta"], &["theta"]);
    let rows = [0.0, 1.0, 0.0, 0.0, -4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -9.0, -1.0];
    space.a = nalgebra::DMatrix::from_row_slice(4, 4, &rows);
    space.b = nalgebra::DMatrix::from_row_slice(4, 1, &[0.0, 0.0, 0.0, 2.0]);
    space.c = nalgebra::DMatrix::from_row_slice(1, 4, &[1.0, 0.0, 1.0, 0.0]);
    let found = TransferFunction::new(&space, 0, 0).expect("a transfer function");
    let cancelled = found.cancelled();
    assert!(cancelled.len() == 2 && cancelled.iter().all(|pole| (pole.im.abs() - 2.0).abs() < 1e-14), "{cancelled:?}");
    let minimal = found.minimal();
    assert!((found.gain - 2.0).abs() < 1e-14 && minimal.zeros.is_empty() && minimal.poles.len() == 2, "{minimal:?}");
    assert!((found.static_gain().expect("a gain") - 2.0 / 9.0).abs() < 1e-15);
}

/// y'' + 3 y' + 2 y = u' + 4 u, at the output y + 0.5 u: (0.5 s² + 2.5 s + 5) over (s + 1)(s + 2).
#[test]
fn what_passes_at_once_counts() {
    let matrix = nalgebra::DMatrix::from_row_slice;
    let signal = |name: &str| crate::Signal { name: name.to_owned(), label: String::new(), unit: "1".to_owned() };
    let space = StateSpace {
        a: matrix(2, 2, &[0.0, 1.0, -2.0, -3.0]),
        b: matrix(2, 1, &[0.0, 1.0]),
        c: matrix(1, 2, &[4.0, 1.0]),
        d: matrix(1, 1, &[0.5]),
        states: vec![signal("x"), signal("x_rate")],
        inputs: vec![signal("u")],
        outputs: vec![signal("y")],
        speed: None,
        speed_unit: carvallo_design::DisplayUnit::declared("m/s"),
    };
    let found = TransferFunction::new(&space, 0, 0).expect("a transfer function");
    for (found, expected) in [(found.numerator(), [0.5, 2.5, 5.0]), (found.denominator(), [1.0, 3.0, 2.0])] {
        assert!(found.len() == 3 && found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}");
    }
    assert!((found.static_gain().expect("a gain") - 2.5).abs() < 1e-14);
    let at = found.at(Complex::new(0.0, 2.0));
    assert!((at - Complex::new(3.0, 5.0) / Complex::new(-2.0, 6.0)).norm() < 1e-14, "{at}");
}

/// A torque on the body of a pendulum on wheels moves these forward by (30.04 θ + 72.91 T), and the body turns by (297.8 θ + 722.8 T), in
/// the same ratio: `72.91 s^2 / (s (s^2 - 297.8))`, of which one zero is left. As roots of the square both would be ±2e-7.
#[test]
fn double_zeros_at_rest_are_exact_and_cancel() {
    let space = state_space(&design("WheeledPendulum", "robot"), 0.0, &["Ttheta"], &["x_rate"]);
    let found = TransferFunction::new(&space, 0, 0).expect("a transfer function");
    let rest = Complex::new(0.0, 0.0);
    assert_eq!((&found.zeros, found.cancelled(), found.static_gain()), (&vec![rest; 2], vec![rest], Some(0.0)));
    assert_eq!(found.numerator()[1..], [0.0; 2]);
}

/// A spring that is 1e-20 of others is no rounding of them: the poles of `(s^2 + 4)(s^2 + 1e-20)` stay beside zero.
#[test]
fn small_poles_are_no_rounding() {
    let mut space = state_space(&design("Pendulum", "seconds"), 0.0, &["Ttheta"], &["theta"]);
    let rows = [0.0, 1.0, 0.0, 0.0, -4.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 4.0, 0.0, -1e-20, 0.0];
    space.a = nalgebra::DMatrix::from_row_slice(4, 4, &rows);
    let poles = space.poles().expect("poles");
    assert_eq!(poles.iter().filter(|pole| (pole.im.abs() - 1e-10).abs() < 1e-22).count(), 2, "{poles:?}");
}

/// A pendulum does not turn what it does not hang on.
#[test]
fn an_output_that_depends_on_nothing_has_no_gain() {
    let mut space = state_space(&design("Pendulum", "seconds"), 0.0, &["Ttheta"], &["theta"]);
    space.b.fill(0.0);
    let found = TransferFunction::new(&space, 0, 0).expect("a transfer function");
    assert_eq!((found.gain, found.zeros.len()), (0.0, 0));
}
