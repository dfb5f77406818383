//! Eigenvalues of systems of two coordinates, and of others.
//!
//! At a double root an eigenvalue is only determined to the square root of the precision of the matrices, whatever the
//! method. So what is bounded is the backward error: computed eigenvalues must be the exact ones of a characteristic
//! polynomial near the given one. How near is counted against what rounding does to its coefficients: each is a sum of
//! products of entries, and uncertain by some epsilons of the size of its terms; and roots that are off by some
//! epsilons of the largest move the coefficient of s^(4-k) by that many of the largest's k-th power.

use std::f64::consts::SQRT_2;

use carvallo::{Model, System, SystemError};
use carvallo_compare::Real;
use carvallo_tests::exact::Size;
use carvallo_tests::quartic::{characteristic, monic};
use carvallo_tests::{bicycles, designs, facts};
use nalgebra::{Complex, Matrix1, Matrix2, Matrix3};
use proptest::prelude::*;

const BOUND: f64 = 8.0;

/// The largest backward error of the coefficients, in what rounding makes of them.
fn backward_error(system: &System<2>, eigenvalues: &[Complex<f64>; 4]) -> f64 {
    let exact: [Real; 5] = characteristic(system);
    let sizes: [Size; 5] = characteristic(system);
    let leading = exact[0].abs().to_f64();
    let largest = eigenvalues.iter().map(|value| value.norm()).fold(0.0, f64::max);
    let computed = monic(eigenvalues);
    let errors = (1..5).map(|k| {
        let wanted = exact[k] / exact[0];
        let error = (computed[k - 1] - wanted).abs().to_f64();
        let of_coefficients = (sizes[k].0 + wanted.abs().to_f64() * sizes[0].0) / leading;
        let of_roots = largest.powi(k as i32);
        error / (f64::EPSILON * (of_coefficients + of_roots))
    });
    errors.fold(0.0, f64::max)
}

fn four(system: &System<2>) -> [Complex<f64>; 4] {
    system.quartic_eigenvalues().unwrap()
}

/// Whether those that are not real, with an imaginary part of exactly zero, come with their exact conjugates.
fn are_real_or_conjugate(eigenvalues: &[Complex<f64>]) -> bool {
    let count = |wanted: Complex<f64>| eigenvalues.iter().filter(|value| **value == wanted).count();
    eigenvalues.iter().all(|value| count(*value) == count(value.conj()))
}

proptest! {
    #![proptest_config(designs::config(300))]

    #[test]
    fn eigenvalues_are_backward_stable_on_random_designs(design in designs::any(), speed in 0.0..30.0) {
        let system = design.coefficients().at(speed, design.g).unwrap();
        let eigenvalues = four(&system);
        let error = backward_error(&system, &eigenvalues);
        prop_assert!(error <= BOUND, "{error} at {eigenvalues:?}");
    }

    #[test]
    fn pairs_are_exact_conjugates_and_all_are_in_order(design in designs::any(), speed in 0.0..30.0) {
        let eigenvalues = four(&design.coefficients().at(speed, design.g).unwrap());
        prop_assert!(are_real_or_conjugate(&eigenvalues), "{eigenvalues:?}");
        prop_assert!(eigenvalues.is_sorted_by(|a, b| (a.re, a.im) <= (b.re, b.im)), "{eigenvalues:?}");
    }

    #[test]
    fn units_of_mass_and_time_do_not_matter(
        design in designs::regular(), speed in 0.0..30.0, mass in -300..300, time in -60..60,
    ) {
        let System { m, c, k, .. } = design.coefficients().at(speed, design.g).unwrap();
        let (mass, rate) = (2f64.powi(mass), 2f64.powi(time));
        let scaled = System::new(m * mass, c * mass * rate, k * mass * rate * rate);
        let eigenvalues = four(&scaled);
        prop_assert!(are_real_or_conjugate(&eigenvalues), "{eigenvalues:?}");
        let unscaled = eigenvalues.map(|value| value / rate);
        let error = backward_error(&System::new(m, c, k), &unscaled);
        prop_assert!(error <= BOUND, "{error} at {unscaled:?}");
    }
}

/// A number of any sign and size, or zero.
fn any_size() -> impl Strategy<Value = f64> {
    prop_oneof![
        1 => Just(0.0),
        5 => (-300..300, 1.0..10.0f64, any::<bool>()).prop_map(|(exponent, digits, negative)| {
            let size: f64 = digits * 10f64.powi(exponent);
            if negative { -size } else { size }
        }),
    ]
}

proptest! {
    #![proptest_config(designs::config(2000))]

    #[test]
    fn results_are_finite_or_an_error(entries in prop::array::uniform12(any_size())) {
        let matrix = |from: usize| Matrix2::from_column_slice(&entries[from..from + 4]);
        let system = System::new(matrix(0), matrix(4), matrix(8));
        let both = [system.eigenvalues(), system.quartic_eigenvalues().map(|four| four.to_vec())];
        for eigenvalues in both.iter().flatten() {
            prop_assert!(eigenvalues.iter().all(|value| value.re.is_finite() && value.im.is_finite()), "{eigenvalues:?}");
            prop_assert!(are_real_or_conjugate(eigenvalues), "{eigenvalues:?}");
        }
    }
}

#[test]
fn double_roots_are_backward_stable() {
    for critical in facts::critical_speeds().iter().filter(|critical| critical.kind == "double_root") {
        let bicycle = bicycles::named(critical.bicycle);
        for steps in -3..=3 {
            let speed = critical.speed * (1.0 + f64::from(steps) * f64::EPSILON);
            let system = bicycle.coefficients().at(speed, bicycle.g).unwrap();
            let eigenvalues = four(&system);
            let error = backward_error(&system, &eigenvalues);
            assert!(error <= BOUND, "{} at {speed}: {error} at {eigenvalues:?}", critical.bicycle);
            assert!(are_real_or_conjugate(&eigenvalues), "{eigenvalues:?}");
        }
    }
}

#[test]
fn multiple_roots_are_found_to_the_root_of_the_precision() {
    // (s + 1)^4, of two equal oscillators with critical damping.
    let one = Matrix2::identity();
    let system = System::new(one, one * 2.0, one);
    for value in four(&system) {
        assert!((value + 1.0).norm() <= 1e-3, "{value}");
    }
    assert!(backward_error(&system, &four(&system)) <= BOUND);
}

#[test]
fn free_motion_has_four_eigenvalues_at_zero() {
    let system = System::new(Matrix2::identity(), Matrix2::zeros(), Matrix2::zeros());
    assert_eq!(four(&system), [Complex::new(0.0, 0.0); 4]);
}

#[test]
fn eigenvalues_of_very_different_size_are_all_found() {
    // Overdamped oscillators with rates 1e12 and 1e-12 in one, 2 and 3 in the other.
    let system =
        System::new(Matrix2::identity(), Matrix2::new(1e12 + 1e-12, 0.0, 0.0, 5.0), Matrix2::new(1.0, 0.0, 0.0, 6.0));
    let expected = [-1e12, -3.0, -2.0, -1e-12];
    for (value, expected) in four(&system).into_iter().zip(expected) {
        assert!((value - expected).norm() <= 1e-13 * expected.abs(), "{value} instead of {expected}");
    }
}

#[test]
fn one_coordinate_is_a_quadratic() {
    let oscillator = |c, k| System::new(Matrix1::new(2.0), Matrix1::new(c), Matrix1::new(k));
    // 2 (s + 1) (s + 3), and 2 ((s + 1)^2 + 4).
    assert_near(&oscillator(8.0, 6.0).eigenvalues().unwrap(), &[(-3.0, 0.0), (-1.0, 0.0)]);
    assert_near(&oscillator(4.0, 10.0).eigenvalues().unwrap(), &[(-1.0, -2.0), (-1.0, 2.0)]);
}

#[test]
fn three_coordinates_are_those_of_their_parts() {
    // Three uncoupled oscillators seen in other coordinates, q = T p: the eigenvalues are those of the oscillators.
    let t = Matrix3::new(1.0, 2.0, 0.5, 0.0, 1.0, -1.0, 1.0, 0.0, 3.0);
    let seen = |diagonal: [f64; 3]| t.transpose() * Matrix3::from_diagonal(&diagonal.into()) * t;
    let system = System::new(seen([1.0, 2.0, 1.0]), seen([3.0, 4.0, 0.0]), seen([2.0, 10.0, 9.0]));
    let expected = [(-2.0, 0.0), (-1.0, -2.0), (-1.0, 0.0), (-1.0, 2.0), (0.0, -3.0), (0.0, 3.0)];
    assert_near(&system.eigenvalues().unwrap(), &expected);
}

/// Fails unless every expected value is matched by one of its own, in whatever order.
fn assert_near(eigenvalues: &[Complex<f64>], expected: &[(f64, f64)]) {
    let mut left = eigenvalues.to_vec();
    for (re, im) in expected {
        let matched = left.iter().position(|value| (value - Complex::new(*re, *im)).norm() <= 1e-12);
        left.swap_remove(matched.unwrap_or_else(|| panic!("{re} + {im}i is not in {eigenvalues:?}")));
    }
    assert!(left.is_empty(), "{left:?} is too much");
}

#[test]
fn a_singular_mass_matrix_is_an_error() {
    let system = System::new(Matrix2::new(1.0, 2.0, 2.0, 4.0), Matrix2::identity(), Matrix2::identity());
    assert!(matches!(system.eigenvalues(), Err(SystemError::SingularMass)));
    assert!(matches!(system.state_space(), Err(SystemError::SingularMass)));
}

#[test]
fn what_is_not_finite_is_an_error() {
    let coefficients = bicycles::named("benchmark").coefficients();
    for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(coefficients.at(value, 9.81).is_err());
        assert!(coefficients.at(5.0, value).is_err());
        let mut broken = coefficients;
        broken.c1[(1, 0)] = value;
        assert!(broken.at(5.0, 9.81).is_err());
    }
}

/// A slow motion coupled to one that is faster by 2^133, about 1e40: by mpmath's `polyroots` with 400 digits.
#[test]
fn eigenvalues_of_very_different_size_are_all_right() {
    let fast = 2f64.powi(133);
    let c = Matrix2::new(0.125, 0.25, -0.5, fast);
    let k = Matrix2::new(1.0, 0.5, 0.25, fast * fast);
    let expected = [
        (-5.444517870735016e39, -9.430181574829767e39),
        (-5.444517870735016e39, 9.430181574829767e39),
        (-0.0625, -0.998044963916957),
        (-0.0625, 0.998044963916957),
    ];
    for (found, (re, im)) in four(&System::new(Matrix2::identity(), c, k)).into_iter().zip(expected) {
        let distance = (found - Complex::new(re, im)).norm();
        assert!(distance <= 4.0 * f64::EPSILON * re.hypot(im), "{found} is not {re} + {im}i");
    }
}

/// The same of three coordinates, with and without damping: the slow ones are hidden in the rounding of the fast ones.
#[test]
fn eigenvalues_hidden_by_far_larger_ones_are_all_right() {
    let fast = 2f64.powi(133);
    let m = Matrix3::new(2.0, 1.0, 0.0, 1.0, 3.0, 0.5, 0.0, 0.5, 1.0);
    let c = Matrix3::new(0.25, 0.5, 0.0, -0.5, 0.125, 0.25, 0.0, 0.25, fast);
    let k = Matrix3::new(3.0, 1.0, 0.5, 1.0, 5.0, 0.25, 0.5, 0.25, fast * fast);
    let damped = [
        (-6.049464300816684e39, -9.754468086462955e39),
        (-6.049464300816684e39, 9.754468086462955e39),
        (-0.061928983225892624, -1.4601559839234939),
        (-0.061928983225892624, 1.4601559839234939),
        (-0.038071016774107375, -1.1443247370803538),
        (-0.038071016774107375, 1.1443247370803538),
    ];
    let undamped = [
        (0.0, -1.1478051488675235e40),
        (0.0, -SQRT_2),
        (0.0, -1.1832159566199232),
        (0.0, 1.1832159566199232),
        (0.0, SQRT_2),
        (0.0, 1.1478051488675235e40),
    ];
    for (c, expected) in [(c, damped), (Matrix3::zeros(), undamped)] {
        let found = System::new(m, c, k).eigenvalues().expect("eigenvalues");
        for (found, (re, im)) in found.into_iter().zip(expected) {
            let distance = (found - Complex::new(re, im)).norm();
            assert!(distance <= 32.0 * f64::EPSILON * f64::hypot(re, im), "{found} is not {re} + {im}i");
        }
    }
}

/// Of three sizes that are 1e20 apart the one in the middle is hidden both ways.
#[test]
fn eigenvalues_hidden_both_ways_are_refused() {
    let size = 2f64.powi(66);
    let m = Matrix3::new(2.0, 1.0, 0.0, 1.0, 3.0, 0.5, 0.0, 0.5, 1.0);
    let k = Matrix3::from_diagonal(&nalgebra::Vector3::new(1.0, size * size, size.powi(4)));
    let found = System::new(m, Matrix3::zeros(), k + Matrix3::repeat(0.25)).eigenvalues();
    assert_eq!(found, Err(SystemError::OutOfRange { quantity: "an eigenvalue beside far larger ones" }));
}
