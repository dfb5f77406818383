//! Eigenvalues of one to eight coordinates, by their backward errors at 320 bits.

use carvallo::{Complex, Matrix, Model, System};
use carvallo_models::{ThreePipes, WhippleLeaning};
use carvallo_tests::backward::StateMatrix;
use carvallo_tests::designs;
use carvallo_tests::textbook::pendulum::{Link, standing_at_hinges};
use nalgebra::{DMatrix, SMatrix};
use proptest::prelude::*;

/// In units of the precision, relative to the norm of the state matrix: some units for each of up to 16 rows.
const BOUND: f64 = 40.0;

/// Whether the eigenvalues are in order, real or in exact pairs, each with a small backward error, and none is missing.
fn check<const N: usize>(system: &System<N>) -> Result<(), TestCaseError> {
    check_as(system, &system.eigenvalues().map_err(|error| TestCaseError::fail(error.to_string()))?)
}

fn check_as<const N: usize>(system: &System<N>, eigenvalues: &[Complex<f64>]) -> Result<(), TestCaseError> {
    let count = |wanted: Complex<f64>| eigenvalues.iter().filter(|value| **value == wanted).count();
    prop_assert!(eigenvalues.iter().all(|value| count(*value) == count(value.conj())), "{eigenvalues:?}");
    prop_assert!(eigenvalues.is_sorted_by(|a, b| (a.re, a.im) <= (b.re, b.im)), "{eigenvalues:?}");
    let state = StateMatrix::new(system);
    // A mass matrix that is off by the precision moves the state matrix by so much more.
    let masses = DMatrix::from_iterator(N, N, system.m.iter().copied()).singular_values();
    let bound = BOUND.max(masses.max() / masses.min());
    // That of its conjugate is the same.
    for &value in eigenvalues.iter().filter(|value| value.im >= 0.0) {
        let error = state.error_of(value);
        prop_assert!(error <= bound, "{error} at {value} of {eigenvalues:?} of {system:?}");
    }
    let error = state.joint_error(eigenvalues);
    prop_assert!(error <= bound, "{error} of all of {eigenvalues:?} of {system:?}");
    Ok(())
}

/// Numbers that are the same on every run.
struct Numbers(u64);

impl Numbers {
    /// Between -1 and 1.
    fn next(&mut self) -> f64 {
        // The generator of Knuth's MMIX.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn matrix<const N: usize>(&mut self) -> Matrix<f64, N> {
        Matrix::from_fn(|_, _| self.next())
    }

    /// Symmetric and positive definite.
    fn positive<const N: usize>(&mut self) -> Matrix<f64, N> {
        let l = self.matrix::<N>();
        l * l.transpose() + Matrix::<f64, N>::identity() * 0.5
    }
}

fn random_systems<const N: usize>(seed: u64) -> Result<(), TestCaseError> {
    let mut numbers = Numbers(seed);
    let m = numbers.positive::<N>();
    check(&System::new(m, numbers.matrix(), numbers.matrix::<N>() * 10.0))?;
    check(&System::new(m, numbers.positive(), numbers.positive::<N>() * 10.0))?;
    // Without damping there is another way.
    check(&System::new(m, Matrix::<f64, N>::zeros(), numbers.matrix()))?;
    check(&System::new(m, Matrix::<f64, N>::zeros(), numbers.positive()))
}

/// Coordinates and time in other units: the backward error is that of the system in usual ones.
fn units<const N: usize>(seed: u64) -> Result<(), TestCaseError> {
    let mut numbers = Numbers(seed);
    let mut power = |range: f64| 2f64.powi((numbers.next() * range) as i32);
    let (time, rows, columns) =
        (power(60.0), SMatrix::from_fn(|_, _| power(60.0)), SMatrix::from_fn(|_, _| power(60.0)));
    let system = System::new(numbers.positive::<N>(), numbers.matrix(), numbers.matrix::<N>() * 10.0);
    let scale = |matrix: Matrix<f64, N>, factor: f64| {
        let (rows, columns): (SMatrix<f64, N, 1>, SMatrix<f64, N, 1>) = (rows, columns);
        Matrix::<f64, N>::from_fn(|i, j| rows[i] * matrix[(i, j)] * columns[j] * factor)
    };
    let scaled = System::new(scale(system.m, 1.0), scale(system.c, time), scale(system.k, time * time));
    let found = scaled.eigenvalues().map_err(|error| TestCaseError::fail(error.to_string()))?;
    let found: Vec<_> = found.into_iter().map(|value| value / time).collect();
    check_as(&system, &found)
}

/// Small integers, among them rotations of coordinates into each other and nilpotent matrices, on which the QR iteration
/// goes around in a circle unless it is helped out.
fn integers<const N: usize>(seed: u64) -> Result<(), TestCaseError> {
    let mut numbers = Numbers(seed);
    let mut matrix = |share: f64| {
        Matrix::<f64, N>::from_fn(|_, _| if numbers.next().abs() < share { numbers.next().signum() } else { 0.0 })
    };
    check(&System::new(Matrix::<f64, N>::identity(), matrix(0.2), matrix(0.3)))?;
    check(&System::new(Matrix::<f64, N>::identity(), Matrix::<f64, N>::zeros(), matrix(0.3)))
}

/// What QR iterations are known to struggle with, and multiple eigenvalues that have too few vectors.
fn degenerate<const N: usize>() -> Result<(), TestCaseError> {
    let m = Matrix::<f64, N>::identity();
    let cycle = Matrix::<f64, N>::from_fn(|i, j| if (i + 1) % N == j { 1.0 } else { 0.0 });
    let chain = Matrix::<f64, N>::from_fn(|i, j| if i + 1 == j { 1.0 } else { 0.0 });
    let tiny = m * 1e-300;
    for k in [cycle, -cycle, chain, m * 0.0, m] {
        for c in [m * 0.0, tiny, m * 2.0 + chain, cycle] {
            check(&System::new(m, c, k))?;
        }
    }
    Ok(())
}

/// Links that stand or hang, with and without damping.
fn chains<const N: usize>() -> Result<(), TestCaseError> {
    let links = std::array::from_fn(|link| Link { l: 0.5, a: 0.2 + 0.02 * link as f64, m: 1.0, i: 0.01 });
    for gravity in [-9.81, 9.81] {
        for damping in [0.0, 0.3] {
            let mut system = standing_at_hinges::<N>(links).at(0.0, gravity).expect("a chain");
            system.c.fill_diagonal(damping);
            check(&system)?;
        }
    }
    Ok(())
}

macro_rules! for_sizes {
    ($function:ident $arguments:tt: $($n:literal)*) => {
        Ok::<(), TestCaseError>(())$(.and_then(|()| $function::<$n> $arguments))*
    };
}

// Arithmetic with 320 bits takes its time: few cases, and large systems only where size matters.
proptest! {
    #![proptest_config(designs::config(1))]

    #[test]
    fn random_systems_are_backward_stable(seed: u64) {
        for_sizes!(random_systems(seed): 1 2 3 4 5 6 7 8)?;
    }

    #[test]
    fn units_of_coordinates_and_time_do_not_matter(seed: u64) {
        for_sizes!(units(seed): 1 2 3 4 5 8)?;
    }
}

proptest! {
    #![proptest_config(designs::config(6))]

    #[test]
    fn small_integers_are_backward_stable(seed: u64) {
        for_sizes!(integers(seed): 3 4)?;
    }
}

#[test]
fn degenerate_systems_are_backward_stable() {
    for_sizes!(degenerate(): 1 2 3 4).unwrap();
}

#[test]
fn chains_are_backward_stable() {
    for_sizes!(chains(): 1 2 3 4 5 6 8).unwrap();
}

#[test]
fn models_are_backward_stable() {
    for speed in [0.0, 0.5, 6.0] {
        let leaning = WhippleLeaning::EXAMPLE;
        check(&leaning.coefficients().at(speed, leaning.g).unwrap()).unwrap();
        check(&ThreePipes::HOSE.coefficients().at(speed, 9.81).unwrap()).unwrap();
    }
}

/// Without damping and with a stiffness that is symmetric, nothing grows or decays: not even by rounding.
#[test]
fn undamped_oscillations_are_exactly_imaginary() {
    let links = [Link { l: 0.5, a: 0.2, m: 1.0, i: 0.01 }; 5];
    let hanging = standing_at_hinges::<5>(links).at(0.0, -9.81).unwrap();
    let eigenvalues = hanging.eigenvalues().unwrap();
    assert!(eigenvalues.iter().all(|value| value.re == 0.0 && value.im != 0.0), "{eigenvalues:?}");
}
