//! The fast way to critical speeds against the careful one: where it gives an answer, it is the same.
//!
//! The careful one loses double-root speeds where the terms of the discriminant cancel to less than double-double can
//! tell. Where their numbers differ, signs of exact eigenvalues decide.

use carvallo::{Coefficients, Model, Stability};
use carvallo_compare::Real;
use carvallo_tests::quartic::characteristic_at;
use carvallo_tests::roots::Signature;
use carvallo_tests::{bicycles, designs};
use proptest::prelude::*;

type Rows = [[f64; 2]; 2];
const ZERO: Rows = [[0.0; 2]; 2];

/// A relative error of a critical speed that is none of an ill-determined one.
const SHARP: f64 = 1e-6;

/// Whether the fast way has an answer. Fails if it is not the right one.
fn check(coefficients: &Coefficients<f64, 2>, gravity: f64) -> Result<bool, TestCaseError> {
    let Some(fast) = Stability::fast(coefficients, gravity) else { return Ok(false) };
    let careful = Stability::careful(coefficients, gravity);
    prop_assert!(careful.is_ok(), "{:?} instead of {:#?}", careful, fast);
    let careful = careful.unwrap();
    if fast.critical_speeds.len() > careful.critical_speeds.len() {
        against_exact_signs(&fast, coefficients, gravity)?;
    } else {
        against(&fast, &careful).map_err(|error| TestCaseError::fail(format!("{error} of {coefficients:?}")))?;
    }
    Ok(true)
}

fn against(fast: &Stability, careful: &Stability) -> Result<(), TestCaseError> {
    let both = || format!("{fast:#?} instead of {careful:#?}");
    prop_assert_eq!(fast.critical_speeds.len(), careful.critical_speeds.len(), "{}", both());
    let mut below = 0.0;
    for (found, expected) in fast.critical_speeds.iter().zip(&careful.critical_speeds) {
        prop_assert_eq!((found.kind, found.change), (expected.kind, expected.change), "{}", both());
        // Both are rounded once.
        prop_assert!((found.speed - expected.speed).abs() <= f64::EPSILON * expected.speed, "{}", both());
        if expected.error <= SHARP * expected.speed {
            let off = (found.eigenvalue - expected.eigenvalue).norm();
            prop_assert!(off <= 8.0 * f64::EPSILON * expected.eigenvalue.norm(), "{}", both());
            // Estimates: the careful way doubles a distance until the polynomial differs from zero there.
            prop_assert!((0.25..4.0).contains(&(found.error / expected.error)), "{}", both());
        }
        let between = 0.5 * (below + expected.speed);
        prop_assert_eq!(fast.verdict(between), careful.verdict(between), "{}", both());
        prop_assert_eq!(fast.verdict(found.speed), careful.verdict(expected.speed), "{}", both());
        below = expected.speed;
    }
    for speed in [0.0, 2.0 * below + 1.0] {
        prop_assert_eq!(fast.verdict(speed), careful.verdict(speed), "{}", both());
    }
    prop_assert_eq!(fast.stable_ranges.len(), careful.stable_ranges.len(), "{}", both());
    for (found, expected) in fast.stable_ranges.iter().zip(&careful.stable_ranges) {
        prop_assert!((found.from - expected.from).abs() <= f64::EPSILON * expected.from, "{}", both());
        prop_assert_eq!(found.to.is_some(), expected.to.is_some(), "{}", both());
        let (found, expected) = (found.to.unwrap_or(0.0), expected.to.unwrap_or(0.0));
        prop_assert!((found - expected).abs() <= f64::EPSILON * expected, "{}", both());
    }
    Ok(())
}

/// Fails unless the kinds of eigenvalues change within the error of each critical speed, and nowhere between them.
fn against_exact_signs(
    fast: &Stability,
    coefficients: &Coefficients<f64, 2>,
    gravity: f64,
) -> Result<(), TestCaseError> {
    let signature = |speed: Real| Signature::of(characteristic_at(coefficients, gravity, speed));
    let (mut low, mut high) = (Real::from(0.0), Real::from(1.0));
    for critical in &fast.critical_speeds {
        let (speed, error) = (Real::from(critical.speed), Real::from(critical.error));
        let (below, above) = (speed - error, speed + error);
        let fraction = |fraction: f64| low + (below - low) * Real::from(fraction);
        let signatures = [0.013, 0.451, 1.0].map(|x| signature(fraction(x)));
        prop_assert_eq!(signatures, [signatures[0]; 3], "below {:?} of {:?}", critical, coefficients);
        prop_assert!(signature(below) != signature(above), "at {:?} of {:?}", critical, coefficients);
        (low, high) = (above, speed + speed);
    }
    prop_assert_eq!(signature(low), signature(high), "{:?} of {:?}", fast, coefficients);
    Ok(())
}

#[test]
fn every_bicycle_is_answered_fast() {
    for (name, bicycle) in bicycles::all() {
        let answered = check(&bicycle.coefficients(), bicycle.g).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(answered, "{name}");
    }
}

#[test]
fn so_are_random_designs_but_for_one_in_a_hundred() {
    const DESIGNS: u64 = 2000;
    let answered = |&number: &u64| {
        let design = designs::numbered(number);
        check(&design.coefficients(), design.g).unwrap_or_else(|error| panic!("{number}: {error}"))
    };
    let count = (0..DESIGNS).filter(answered).count();
    assert!(count >= 1980, "{count} of {DESIGNS}");
}

/// A number of either sign over some decades, or zero once in ten times.
fn number(decades: f64) -> impl Strategy<Value = f64> {
    let regular = (any::<bool>(), 1.0..10.0f64, -decades..decades)
        .prop_map(|(negative, mantissa, exponent)| 10f64.powf(exponent) * if negative { -mantissa } else { mantissa });
    prop_oneof![9 => regular, 1 => Just(0.0)]
}

fn rows(decades: f64) -> impl Strategy<Value = Rows> {
    prop::array::uniform2(prop::array::uniform2(number(decades)))
}

/// How far two numbers that should coincide are apart, relative to them.
fn distance() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), (-17..0, -1.0..1.0f64).prop_map(|(exponent, fraction)| fraction * 10f64.powi(exponent))]
}

/// `T^T X T` with the rows (1, a) and (b, 1 + a b) of T, for all matrices.
fn coupled(matrices: [Rows; 8], [a, b]: [i8; 2]) -> [Rows; 8] {
    let [a, b] = [a, b].map(f64::from);
    let t = [[1.0, a], [b, 1.0 + a * b]];
    let product = |x: Rows, y: Rows| {
        let entry = |i: usize, j: usize| x[i][0] * y[0][j] + x[i][1] * y[1][j];
        [[entry(0, 0), entry(0, 1)], [entry(1, 0), entry(1, 1)]]
    };
    matrices.map(|x| product([[t[0][0], t[1][0]], [t[0][1], t[1][1]]], product(x, t)))
}

fn diagonal(x: f64, y: f64) -> Rows {
    [[x, 0.0], [0.0, y]]
}

proptest! {
    #![proptest_config(designs::config(1000))]

    #[test]
    fn on_designs_at_the_edge(design in designs::any()) {
        check(&design.coefficients(), design.g)?;
    }

    #[test]
    fn on_any_matrices(
        (m, c0, c1) in (rows(1.0), rows(1.0), rows(1.0)),
        (kc, k0, k2) in (rows(1.0), rows(1.0), rows(1.0)),
        damped in any::<bool>(),
        gravity in number(1.0),
    ) {
        check(&Coefficients::from_rows([m, ZERO, if damped { c0 } else { ZERO }, c1, kc, k0, ZERO, k2]), gravity)?;
    }

    #[test]
    fn on_matrices_of_very_different_entries(
        (m, c0, c1) in (rows(6.0), rows(6.0), rows(6.0)),
        (kc, k0, k2) in (rows(6.0), rows(6.0), rows(6.0)),
        damped in any::<bool>(),
        gravity in number(4.0),
    ) {
        check(&Coefficients::from_rows([m, ZERO, if damped { c0 } else { ZERO }, c1, kc, k0, ZERO, k2]), gravity)?;
    }

    /// Two coordinates with capsize or double-root speeds, or both, that nearly coincide, in coupled coordinates.
    #[test]
    fn on_speeds_that_nearly_coincide(
        (damping, stiffness, square) in (number(1.0), number(1.0), number(1.0)),
        other in number(1.0),
        near in prop::array::uniform3(distance()),
        coupling in any::<[i8; 2]>(),
        same_damping in any::<bool>(),
    ) {
        let factor = if same_damping { 1.0 } else { other };
        let c1 = diagonal(damping, damping * factor * (1.0 + near[0]));
        let kc = diagonal(stiffness, stiffness * factor * factor * (1.0 + near[1]));
        let k2 = diagonal(square, square * factor * factor * (1.0 + near[2]));
        let coupling = coupling.map(|x| x % 8);
        check(&Coefficients::from_rows(coupled([diagonal(1.0, 1.0), ZERO, ZERO, c1, kc, ZERO, ZERO, k2], coupling)), 0.0)?;
    }

    /// Some of them beyond what the fast way deals with.
    #[test]
    fn in_any_units(design in designs::regular(), (mass, length, time) in (-8..8, -8..8, -8..8)) {
        let [mass, length, time] = [mass, length, time].map(|exponent| 16f64.powi(exponent));
        let Coefficients { m, c0, c1, kc, k0, k2, .. } = design.coefficients();
        let inertia = mass * length * length;
        let scaled = Coefficients {
            m: m * inertia,
            c0: c0 * (inertia / time),
            c1: c1 * (mass * length),
            kc: kc * (inertia / time / time),
            k0: k0 * (mass * length),
            k2: k2 * mass,
            ..Default::default()
        };
        check(&scaled, design.g * length / time / time)?;
    }
}

#[test]
fn on_motion_that_is_always_stable() {
    let (m, c1) = (diagonal(1.0, 1.0), [[0.2, 0.5], [-0.5, 0.1]]);
    let coefficients =
        Coefficients::from_rows([m, ZERO, ZERO, c1, diagonal(4.0, 9.0), ZERO, ZERO, diagonal(0.5, 0.25)]);
    let answered = check(&coefficients, 0.0).unwrap_or_else(|error| panic!("{error}"));
    assert!(answered);
}

/// With coefficients of the discriminant that are less than the noise of their terms, and yet not zero.
#[test]
fn on_terms_that_cancel_to_less_than_their_noise() {
    let undamped = [
        [[-4.631782732528299e-6, -23294.953947309623], [0.0, 2.7810520211882848e-5]],
        ZERO,
        [[1.0, 1.0], [0.001541116330231213, 1.0]],
        [[1.0, 0.0], [1.0, 1.0]],
        [[-9.40203684990654, 0.0], [-301254.2299823092, 0.005453363440902662]],
        [[1.0, 6.689678129675988e-6], [-1.0, 1.0]],
    ];
    let damped = [
        [[1.0, 0.0011888950088722527], [0.0004488393884959774, 2.6266370095602897e-6]],
        [[1.0, 1.0], [1.0, 1.0]],
        [[1.0, 717863.6495880147], [5981127.226151192, 1.0]],
        [[1.0, 1.0], [1.0, 1.0]],
        [[-10636.133138722435, 1.0], [1.0, 1.0]],
        [[-1.0, 3.063056952604649e-6], [-0.0005237983404409374, 0.0015071825497475315]],
    ];
    for ([m, c0, c1, kc, k0, k2], gravity) in [(undamped, 902.9096789262502), (damped, -6.054979675979903)] {
        check(&Coefficients::from_rows([m, ZERO, c0, c1, kc, k0, ZERO, k2]), gravity)
            .unwrap_or_else(|error| panic!("{error}"));
    }
}
