//! Derivatives against those of solutions in closed form, and what has none.

use nalgebra::Complex;

use super::{CriticalDerivative, EigenvalueDerivative, NotDifferentiable, Sensitivity, SensitivityError};
use crate::characteristic::determinant::Rows;
use crate::stability::{CriticalKind, Stability};
use crate::system::{Coefficients, Matrix, SystemError};

const ZERO: Rows = [[0.0; 2]; 2];
const ONE: Rows = diagonal(1.0, 1.0);
/// The entries of a diagonal.
const FIRST: Rows = diagonal(1.0, 0.0);
const SECOND: Rows = diagonal(0.0, 1.0);

const fn diagonal(x: f64, y: f64) -> Rows {
    [[x, 0.0], [0.0, y]]
}

fn coefficients(m: Rows, c0: Rows, c1: Rows, kc: Rows, k2: Rows) -> Coefficients<f64, 2> {
    Coefficients::from_rows([m, ZERO, c0, c1, kc, ZERO, ZERO, k2])
}

/// The derivatives with respect to entries of C0, and of Kc.
fn damping(rows: Rows) -> Coefficients<f64, 2> {
    coefficients(ZERO, rows, ZERO, ZERO, ZERO)
}

fn stiffness(rows: Rows) -> Coefficients<f64, 2> {
    coefficients(ZERO, ZERO, ZERO, rows, ZERO)
}

#[track_caller]
fn assert_near(found: impl Into<Complex<f64>>, expected: impl Into<Complex<f64>>) {
    let (found, expected) = (found.into(), expected.into());
    assert!((found - expected).norm() <= 4e-15 * expected.norm().max(1.0), "{found} is not {expected}");
}

/// The answer for the only critical speed of a kind, or the first.
#[track_caller]
fn critical(
    coefficients: &Coefficients<f64, 2>,
    derivatives: &[Coefficients<f64, 2>],
    kind: CriticalKind,
) -> CriticalDerivative {
    let stability = Stability::new(coefficients, 0.0).unwrap();
    let critical = stability.critical_speeds.iter().find(|critical| critical.kind == kind);
    let sensitivity = Sensitivity::new(coefficients, derivatives, 0.0, None).unwrap();
    sensitivity.critical_speed(critical.expect("a critical speed of the kind")).unwrap()
}

#[track_caller]
fn smooth(derivative: CriticalDerivative) -> (Vec<f64>, Vec<Complex<f64>>) {
    match derivative {
        CriticalDerivative::Smooth { speed, eigenvalue, condition } if condition < 1e3 => (speed, eigenvalue),
        other => panic!("{other:?}"),
    }
}

/// q'' + c q' + k q = 0 with s = -c/2 +- sqrt(c^2/4 - k).
fn one_coordinate(c: f64, k: f64) -> Vec<super::EigenvalueSensitivity> {
    let rows = |m: f64, c0: f64, kc: f64| {
        Coefficients::<f64, 1>::from_rows([m, 0.0, c0, 0.0, kc, 0.0, 0.0, 0.0].map(|x| [[x]]))
    };
    let derivatives = [rows(0.0, 1.0, 0.0), rows(0.0, 0.0, 1.0), rows(1.0, 0.0, 0.0)];
    Sensitivity::new(&rows(1.0, c, k), &derivatives, 0.0, None).unwrap().eigenvalues(1.0).unwrap()
}

#[test]
fn one_coordinate_has_the_derivatives_of_its_formula() {
    for (c, k) in [(1.0, 10.0), (3.0, 1.0), (0.0, 4.0), (0.5, -2.0), (2.0, 0.0)] {
        for found in one_coordinate(c, k) {
            let (s, EigenvalueDerivative::Simple { gradient, condition }) = (found.value, found.derivative) else {
                panic!("simple")
            };
            let slope = s * 2.0 + c;
            assert!(condition < 20.0);
            assert_near(gradient.speed, 0.0);
            for (found, expected) in gradient.parameters.into_iter().zip([-s, Complex::from(-1.0), -s * s]) {
                assert_near(found, expected / slope);
            }
        }
    }
}

/// At critical damping the mean is -c/2 and the square c^2/4 - k.
#[test]
fn critical_damping_is_a_double_root() {
    for found in one_coordinate(2.0, 1.0) {
        let EigenvalueDerivative::Double { mean, square } = found.derivative else { panic!("double") };
        for (found, expected) in mean.parameters.into_iter().zip([-0.5, 0.0, 1.0]) {
            assert_near(found, expected);
        }
        // c^2/4m^2 - k/m
        for (found, expected) in square.parameters.into_iter().zip([1.0, -1.0, -1.0]) {
            assert_near(found, expected);
        }
    }
}

/// Two equal oscillators: their eigenvalues coincide, but each keeps its own derivative, and they part at first order.
#[test]
fn uncoupled_coordinates_do_not_part_like_a_root() {
    let equal = coefficients(ONE, ZERO, ZERO, diagonal(4.0, 4.0), ZERO);
    let sensitivity = Sensitivity::new(&equal, &[stiffness(FIRST)], 0.0, None).unwrap();
    for found in sensitivity.eigenvalues(0.0).unwrap() {
        let EigenvalueDerivative::Double { mean, square } = found.derivative else { panic!("double") };
        assert_near(mean.parameters[0], Complex::new(0.0, found.value.im.signum() / 8.0));
        assert_near(square.parameters[0], 0.0);
    }
}

#[test]
fn four_equal_eigenvalues_have_no_derivative() {
    let equal = coefficients(ONE, diagonal(2.0, 2.0), ZERO, ONE, ZERO);
    let sensitivity = Sensitivity::new(&equal, &[stiffness(FIRST)], 0.0, None).unwrap();
    for found in sensitivity.eigenvalues(0.0).unwrap() {
        assert_eq!(found.derivative, EigenvalueDerivative::Multiple);
    }
}

/// Three coordinates mixed by a congruence, with units that differ by powers of two: of the first, critically damped, and
/// the second and third, each on its own, the derivatives stay what they were.
#[test]
fn mixing_and_units_of_coordinates_do_not_matter() {
    for exponent in [0, 10] {
        let unit = 2f64.powi(exponent);
        let units = Matrix::<f64, 3>::from_diagonal(&nalgebra::SVector::<f64, 3>::new(1.0, unit, 1.0 / unit));
        let mix = Matrix::<f64, 3>::new(1.0, 0.5, -0.25, 0.0, 1.0, 0.5, 0.25, 0.0, 1.0) * units;
        let mixed = |x: f64, y: f64, z: f64| {
            let matrix = Matrix::<f64, 3>::from_diagonal(&nalgebra::SVector::<f64, 3>::new(x, y, z));
            let matrix = mix.transpose() * matrix * mix;
            core::array::from_fn(|i| core::array::from_fn(|j| matrix[(i, j)]))
        };
        let zero = [[0.0; 3]; 3];
        let system = [mixed(1.0, 1.0, 1.0), zero, mixed(2.0, 1.0, 0.0), zero, mixed(1.0, 9.0, 4.0), zero, zero, zero];
        let stiffer = [zero, zero, zero, zero, mixed(1.0, 10.0, 100.0), zero, zero, zero];
        let [system, stiffer] = [system, stiffer].map(Coefficients::<f64, 3>::from_rows);
        let found = Sensitivity::new(&system, &[stiffer], 0.0, None).unwrap().eigenvalues(0.0).unwrap();
        assert_eq!(found.len(), 6);
        let near = |found: Complex<f64>, expected: Complex<f64>| {
            assert!((found - expected).norm() < 1e-12 * expected.norm().max(1.0), "{found} is not {expected}");
        };
        for found in found {
            match found.derivative {
                EigenvalueDerivative::Double { mean, square } => {
                    near(mean.parameters[0], 0.0.into());
                    near(square.parameters[0], (-1.0).into());
                }
                EigenvalueDerivative::Simple { gradient, .. } => {
                    let by_k = if found.value.re < -0.25 { (10.0, 1.0) } else { (100.0, 0.0) };
                    near(gradient.parameters[0], -by_k.0 / (found.value * 2.0 + by_k.1));
                }
                EigenvalueDerivative::Multiple => panic!("{found:?}"),
            }
        }
    }
}

/// s^2 + (v - 1) s + 4 and s^2 + 3 s + 5 - v^2, uncoupled: weave at 1, capsize at sqrt(5), a double root where
/// 9/4 - 5 + v^2 = 0.
#[test]
fn critical_speeds_have_the_derivatives_of_their_formulas() {
    let system = coefficients(ONE, diagonal(-1.0, 3.0), diagonal(1.0, 0.0), diagonal(4.0, 5.0), diagonal(0.0, -1.0));
    let derivatives = [damping(FIRST), stiffness(FIRST), damping(SECOND), stiffness(SECOND)];
    let of = |kind| smooth(critical(&system, &derivatives, kind));
    let assert =
        |(speeds, eigenvalues): (Vec<f64>, Vec<Complex<f64>>), expected: [f64; 4], eigenvalue: [Complex<f64>; 4]| {
            for (found, expected) in speeds.into_iter().zip(expected) {
                assert_near(found, expected);
            }
            for (found, expected) in eigenvalues.into_iter().zip(eigenvalue) {
                assert_near(found, expected);
            }
        };
    let [zero, i] = [Complex::from(0.0), Complex::new(0.0, 1.0)];
    assert(of(CriticalKind::Weave), [-1.0, 0.0, 0.0, 0.0], [zero, i * 0.25, zero, zero]);
    assert(of(CriticalKind::Capsize), [0.0, 0.0, 0.0, 0.5 / 5f64.sqrt()], [zero; 4]);
    let v = 11f64.sqrt() / 2.0;
    let double = of(CriticalKind::DoubleRoot);
    assert(double, [0.0, 0.0, -0.75 / v, 0.5 / v], [zero, zero, Complex::from(-0.5), zero]);
}

/// The same at scales whose products leave the range of `f64`.
#[test]
fn scales_do_not_matter() {
    let (mass, time, length) = (2f64.powi(500), 2f64.powi(-200), 2f64.powi(300));
    let scaled = |[m, c0, c1, kc, k2]: [Rows; 5]| {
        let of = |rows: Rows, unit: f64| rows.map(|row| row.map(|entry| entry * unit));
        let speed = length / time;
        coefficients(
            of(m, mass),
            of(c0, mass / time),
            of(c1, mass / time / speed),
            of(kc, mass / time / time),
            of(k2, mass / time / time / speed / speed),
        )
    };
    let coupled = [[4.0, 0.5], [-0.5, 5.0]];
    let rows = [ONE, diagonal(-1.0, 3.0), diagonal(1.0, 0.0), coupled, diagonal(0.0, -1.0)];
    let direction = [ZERO, [[0.5, 0.0], [1.0, 0.0]], ZERO, ONE, ZERO];
    let unscaled = |[m, c0, c1, kc, k2]: [Rows; 5]| coefficients(m, c0, c1, kc, k2);
    for kind in [CriticalKind::Weave, CriticalKind::Capsize] {
        let (expected, eigenvalue) = smooth(critical(&unscaled(rows), &[unscaled(direction)], kind));
        let (speed, scaled_eigenvalue) = smooth(critical(&scaled(rows), &[scaled(direction)], kind));
        assert_eq!(speed[0], expected[0] * (length / time));
        assert_eq!(scaled_eigenvalue[0], eigenvalue[0] / time);
    }
}

/// Stiffness 1 - v^2 twice: two capsize speeds are one.
#[test]
fn critical_speeds_that_meet_have_no_derivative() {
    let twice = coefficients(ONE, diagonal(2.0, 3.0), ZERO, ONE, diagonal(-1.0, -1.0));
    let found = critical(&twice, &[stiffness(FIRST)], CriticalKind::Capsize);
    assert_eq!(found, CriticalDerivative::None(NotDifferentiable::Meeting));
}

/// s^4 + (k1 + k2) s^2 + k1 k2 + v^4: two imaginary pairs meet at v^2 = (k2 - k1) / 2. Stiffness moves that speed, but
/// damping leaves no speed at which they meet.
#[test]
fn flutter_without_damping_needs_its_coincidence() {
    let system = coefficients(ONE, ZERO, ZERO, diagonal(1.0, 4.0), [[0.0, 1.0], [-1.0, 0.0]]);
    let stiffer = [stiffness(FIRST), stiffness(SECOND)];
    let (speed, eigenvalue) = smooth(critical(&system, &stiffer, CriticalKind::DoubleRoot));
    let v = 1.5f64.sqrt();
    assert_near(speed[0], -0.25 / v);
    assert_near(speed[1], 0.25 / v);
    // s^2 = -(k1 + k2) / 2
    let s = Complex::new(0.0, 2.5f64.sqrt());
    assert_near(eigenvalue[0], -0.25 / s);
    let found = critical(&system, &[stiffness(FIRST), damping(FIRST)], CriticalKind::DoubleRoot);
    assert_eq!(found, CriticalDerivative::None(NotDifferentiable::Coincidence));
}

/// A free coordinate has an eigenvalue of zero at all speeds, beside which another one capsizes.
#[test]
fn capsize_beside_a_zero_eigenvalue_has_a_derivative() {
    let system = coefficients(ONE, ONE, ZERO, diagonal(0.0, 9.0), diagonal(0.0, -1.0));
    let (speed, _) = smooth(critical(&system, &[stiffness(SECOND), damping(SECOND)], CriticalKind::Capsize));
    assert_near(speed[0], 1.0 / 6.0);
    assert_near(speed[1], 0.0);
    // Its own stiffness takes the zero away.
    let found = critical(&system, &[stiffness(FIRST)], CriticalKind::Capsize);
    assert_eq!(found, CriticalDerivative::None(NotDifferentiable::Coincidence));
}

/// Without damping an imaginary pair passes through zero and becomes a real one, as that of a rolling disc does.
#[test]
fn a_double_zero_has_derivatives() {
    let system = coefficients(ONE, ZERO, ZERO, diagonal(0.0, 9.0), diagonal(0.0, -1.0));
    for kind in [CriticalKind::Capsize, CriticalKind::DoubleRoot] {
        let (speed, eigenvalue) = smooth(critical(&system, &[stiffness(SECOND)], kind));
        assert_near(speed[0], 1.0 / 6.0);
        assert_near(eigenvalue[0], 0.0);
    }
}

/// q'' + q' + (g k - v^2) q: capsize at v = sqrt(g k), where g counts by its factor k.
#[test]
fn gravity_is_a_parameter_like_any_other() {
    let rows = |k0: f64, k2: f64| [ONE, ZERO, ONE, ZERO, SECOND, diagonal(k0, 0.0), ZERO, diagonal(k2, 0.0)];
    let coefficients = Coefficients::<f64, 2>::from_rows(rows(2.0, -1.0));
    let by_k = Coefficients::from_rows([ZERO, ZERO, ZERO, ZERO, ZERO, FIRST, ZERO, ZERO]);
    let by_g = Coefficients::from_rows([ZERO; 8]);
    let sensitivity = Sensitivity::new(&coefficients, &[by_k, by_g], 8.0, Some(1)).unwrap();
    let stability = Stability::new(&coefficients, 8.0).unwrap();
    let capsize = stability.critical_speeds.iter().find(|critical| critical.kind == CriticalKind::Capsize);
    let (speed, _) = smooth(sensitivity.critical_speed(capsize.unwrap()).unwrap());
    assert_near(speed[0], 1.0);
    assert_near(speed[1], 0.25);
    for found in sensitivity.eigenvalues(0.0).unwrap() {
        let EigenvalueDerivative::Simple { gradient, .. } = found.derivative else { panic!("simple") };
        if (found.value.im.abs() - 15.75f64.sqrt()).abs() < 1e-12 {
            assert_near(gradient.parameters[0], -8.0 / (found.value * 2.0 + 1.0));
            assert_near(gradient.parameters[1], -2.0 / (found.value * 2.0 + 1.0));
        }
    }
}

#[test]
fn errors_name_what_is_wrong() {
    let system = coefficients(ONE, ONE, ZERO, ONE, ZERO);
    let gravity = Sensitivity::new(&system, &[damping(ONE)], 9.81, Some(1));
    assert_eq!(gravity, Err(SensitivityError::TooFew { quantity: "derivatives", expected: 2, found: 1 }));
    let infinite = Sensitivity::new(&system, &[stiffness(diagonal(f64::INFINITY, 0.0))], 9.81, None);
    assert_eq!(infinite, Err(SystemError::OutOfRange { quantity: "a derivative of a matrix" }.into()));
    let singular = coefficients(FIRST, ONE, ZERO, ONE, ZERO);
    let sensitivity = Sensitivity::new(&singular, &[], 0.0, None).unwrap();
    assert_eq!(sensitivity.eigenvalues(1.0), Err(SystemError::SingularMass));
}
