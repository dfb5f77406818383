//! Systems in `f32`, which are computed in it throughout, against the same numbers in `f64`.

use carvallo::{Coefficients, Matrix, Model, Scalar, StateSpace, System, SystemError};
use carvallo_models::WhippleLeaning;
use carvallo_tests::bicycles;

/// Half the distance from 1 to the next number: the largest relative error of one rounding.
const ROUNDING: f64 = f32::EPSILON as f64 / 2.0;

const SPEEDS: [f32; 5] = [0.0, 0.3, 4.7, 13.0, -6.1];
const GRAVITY: f32 = 9.81;

fn wide<const N: usize>(matrix: &Matrix<f32, N>) -> Matrix<f64, N> {
    matrix.map(f64::from)
}

/// Whether numbers differ by no more than a few roundings of what they are made from.
fn check<const N: usize>(what: &str, found: &Matrix<f32, N>, exact: &Matrix<f64, N>, error: Matrix<f64, N>) {
    for ((found, exact), error) in wide(found).iter().zip(exact).zip(&error) {
        assert!((found - exact).abs() <= *error, "{what}: {found} for {exact}, but {error} is allowed");
    }
}

/// No term of C and K passes through more than four roundings: two products and two sums, or a product and three sums.
fn check_system<const N: usize>(coefficients: &Coefficients<f32, N>, speed: f32) -> System<N, f32> {
    let system = coefficients.at(speed, GRAVITY).unwrap();
    let (v, g) = (f64::from(speed), f64::from(GRAVITY));
    let exact = Coefficients::<f64, N>::from(*coefficients).at(v, g).unwrap();
    assert_eq!(wide(&system.m), exact.m);
    let four = 4.0 * ROUNDING / (1.0 - 4.0 * ROUNDING);
    let Coefficients { cm1, c0, c1, kc, k0, k1, k2, .. } = Coefficients::<f64, N>::from(*coefficients);
    let divided = if v == 0.0 { cm1 } else { cm1 / v };
    check("C", &system.c, &exact.c, (divided.abs() + c0.abs() + c1.abs() * v.abs()) * four);
    let terms = kc.abs() + k0.abs() * g + k1.abs() * v.abs() + k2.abs() * v * v;
    check("K", &system.k, &exact.k, terms * four);
    system
}

/// The error of elimination is bounded by |M^-1| (|M| |X|) times a few roundings for each of its steps.
fn check_state_space<const N: usize>(system: &System<N, f32>) {
    let found = system.state_space().unwrap();
    let exact: StateSpace<N> = System::from(*system).state_space().unwrap();
    let spread = exact.input.abs() * wide(&system.m).abs();
    let bound = 8.0 * N as f64 * ROUNDING;
    check("stiffness", &found.stiffness, &exact.stiffness, spread * exact.stiffness.abs() * bound);
    check("damping", &found.damping, &exact.damping, spread * exact.damping.abs() * bound);
    check("input", &found.input, &exact.input, spread * exact.input.abs() * bound);
}

#[test]
fn systems_differ_from_those_in_f64_by_their_rounding() {
    for (_, bicycle) in bicycles::all() {
        for speed in SPEEDS {
            check_state_space(&check_system(&bicycle.cast().coefficients(), speed));
        }
    }
    for speed in SPEEDS {
        check_state_space(&check_system(&WhippleLeaning::EXAMPLE.cast().coefficients(), speed));
    }
}

#[test]
fn systems_of_every_power_of_the_speed_differ_by_their_rounding_too() {
    let entry = |matrix: usize, row: usize, column: usize| ((3 * matrix + 2 * row + column) as f32 + 1.3).sin() / 3.0;
    let rows = core::array::from_fn(|matrix| [0, 1].map(|row| [0, 1].map(|column| entry(matrix, row, column))));
    for speed in SPEEDS.into_iter().filter(|&speed| speed != 0.0) {
        check_state_space(&check_system(&Coefficients::from_rows(rows), speed));
    }
}

#[test]
fn eigenvalues_are_those_of_the_same_numbers_in_f64() {
    let bicycle = bicycles::named("benchmark").cast::<f32>();
    let system = bicycle.coefficients().at(4.6, bicycle.g).unwrap();
    assert_eq!(system.quartic_eigenvalues(), System::<2>::from(system).quartic_eigenvalues());
    let system = WhippleLeaning::EXAMPLE.cast::<f32>().coefficients().at(4.6, GRAVITY).unwrap();
    assert_eq!(system.eigenvalues(), System::<3>::from(system).eigenvalues());
}

#[test]
fn blocks_have_their_places_in_f32_too() {
    let system = bicycles::named("benchmark").cast::<f32>().coefficients().at(4.6, GRAVITY).unwrap();
    let space = system.state_space().unwrap();
    assert_eq!(space.a().map(f64::from), StateSpace::<2>::from(space).a());
    assert_eq!(space.b().map(f64::from), StateSpace::<2>::from(space).b());
    assert_eq!(space.a().row(2).columns(2, 2), space.damping.row(0));
}

/// Coefficients of one coordinate with these entries, M and K2.
fn heavy<T: Scalar>(m: T, k2: T) -> Coefficients<T, 1> {
    Coefficients { m: Matrix::<T, 1>::new(m), k2: Matrix::<T, 1>::new(k2), ..Default::default() }
}

#[test]
fn what_leaves_the_range_of_f32_is_an_error_there_alone() {
    let out_of_range = |quantity| SystemError::OutOfRange { quantity };
    let (one, large) = (heavy(1.0_f32, 1e20), 1e12);
    assert_eq!(one.at(large, 0.0), Err(out_of_range("Kc + g K0 + v K1 + v^2 K2")));
    assert!(Coefficients::<f64, 1>::from(one).at(large.into(), 0.0).is_ok());

    let light = heavy(1e-30_f32, 1e10).at(1.0, 0.0).unwrap();
    assert_eq!(light.state_space(), Err(out_of_range("M^-1 K")));
    assert!(System::<1>::from(light).state_space().is_ok());
}

#[test]
fn numbers_that_are_none_are_told_of_as_in_f64() {
    let infinite = SystemError::NotFinite { quantity: "speed", value: f64::INFINITY };
    assert_eq!(heavy(1.0_f32, 1.0).at(f32::INFINITY, 0.0), Err(infinite));
    assert_eq!(heavy(1.0_f64, 1.0).at(f64::INFINITY, 0.0), Err(infinite));
    let infinite = SystemError::NotFinite { quantity: "K2", value: f64::NEG_INFINITY };
    assert_eq!(heavy(1.0, f32::NEG_INFINITY).at(1.0, 0.0), Err(infinite));
}

#[test]
fn a_mass_matrix_is_singular_as_far_as_f32_can_tell() {
    let nearly = 1.0 + f32::EPSILON;
    let m = Matrix::<f32, 2>::new(1.0, 1.0, 1.0, nearly);
    let system = System::new(m, Matrix::<f32, 2>::zeros(), Matrix::<f32, 2>::zeros());
    assert_eq!(system.state_space(), Err(SystemError::SingularMass));
    assert!(System::<2>::from(system).state_space().is_ok());
}
