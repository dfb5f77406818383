//! The cantilevered pipe that carries a fluid, with four modes and with others.

#![allow(non_snake_case)] // Names of the field.

use std::f64::consts::PI;

use carvallo::{Coefficients, Matrix, Model};
use carvallo_models::CantileveredPipe;

use super::{assert_near, stability};

/// A pipe with a part of the fluid in its mass, whose speed is the dimensionless one.
fn pipe(beta: f64) -> CantileveredPipe<f64> {
    CantileveredPipe { l: 1.0, EI: 1.0, m: 1.0 / beta - 1.0, f: 1.0 }
}

/// The speeds at which stability is lost or won.
fn ends_of_stability<const N: usize>(coefficients: &Coefficients<f64, N>) -> Vec<f64> {
    let ranges = stability(coefficients).stable_ranges;
    let ends = ranges.iter().flat_map(|range| [Some(range.from).filter(|&from| from > 0.0), range.to]);
    ends.flatten().collect()
}

/// Speeds at which stability is lost or won, found by a search along the speed with the eigenvalues of NumPy; for beta = 0.7
/// there are three of them with four modes, the jump that Gregory & Paidoussis (1966) show at about 0.69.
#[test]
fn a_pipe_flutters_at_the_speeds_that_a_search_finds() {
    let found: [(f64, &[f64]); 5] = [
        (0.1, &[4.751460907230235]),
        (0.2, &[5.601242272279362]),
        (0.5, &[9.456195095659986]),
        (0.69, &[11.037778742097233]),
        (0.7, &[11.168655744616325, 12.941988279599054, 13.363160607273462]),
    ];
    for (beta, expected) in found {
        let ends = ends_of_stability(&pipe(beta).coefficients());
        assert_eq!(ends.len(), expected.len(), "{beta}: {ends:?}");
        ends.into_iter().zip(expected).for_each(|(found, &expected)| assert_near(found, expected, 1e-11));
    }
    assert_eq!(CantileveredPipe::BETA_02, pipe(0.2));
    assert_eq!(CantileveredPipe::BETA_05, pipe(0.5));
}

/// Dimensions: at other lengths, stiffnesses and masses the critical speed is that of u = v l sqrt(f/EI).
#[test]
fn a_pipe_of_any_size_flutters_at_its_dimensionless_speed() {
    let hose = CantileveredPipe { l: 0.45, EI: 0.0073, m: 0.19, f: 0.19 };
    let flutter = stability(&hose.coefficients()).critical_speeds[0].speed;
    assert_near(flutter * hose.l * (hose.f / hose.EI).sqrt(), 9.456195095659986, 1e-11);
}

/// The modes of the clamped beam and their derivatives, at a place between 0 and 1.
fn mode(of: usize, x: f64) -> [f64; 3] {
    let lambda: f64 = [1.8751040687119611, 4.694091132974174, 7.854757438237613, 10.995_540_734_875_467][of];
    let sigma = (lambda.sinh() - lambda.sin()) / (lambda.cosh() + lambda.cos());
    let (sine, cosine, sinh, cosh) = ((lambda * x).sin(), (lambda * x).cos(), (lambda * x).sinh(), (lambda * x).cosh());
    [
        cosh - cosine - sigma * (sinh - sine),
        lambda * (sinh + sine - sigma * (cosh - cosine)),
        lambda * lambda * (cosh + cosine - sigma * (sinh + sine)),
    ]
}

/// The matrices by Galerkin: integrals of products of the modes, by Simpson's rule.
#[test]
fn matrices_are_integrals_of_the_modes() {
    const PARTS: usize = 2000;
    let integral = |of: &dyn Fn(f64) -> f64| {
        let weights = |at: usize| if at == 0 || at == PARTS { 1.0 } else { 2.0 + 2.0 * (at % 2) as f64 };
        (0..=PARTS).map(|at| weights(at) * of(at as f64 / PARTS as f64)).sum::<f64>() / (3.0 * PARTS as f64)
    };
    let product = |derivative: usize| {
        Matrix::<f64, 4>::from_fn(|row, column| integral(&|x| mode(row, x)[0] * mode(column, x)[derivative]))
    };
    // The fourth derivative by parts twice: clamped at one end, free at the other.
    let bending = Matrix::<f64, 4>::from_fn(|row, column| integral(&|x| mode(row, x)[2] * mode(column, x)[2]));
    let CantileveredPipe { l, EI, m, f } = CantileveredPipe { l: 2.5, EI: 7.0, m: 1.3, f: 0.6 };
    let found = CantileveredPipe { l, EI, m, f }.coefficients();
    for (found, expected) in [
        (found.m, product(0) * ((m + f) * l)),
        (found.c1, product(1) * (2.0 * f)),
        (found.kc, bending * (EI / l.powi(3))),
        (found.k2, product(2) * (f / l)),
    ] {
        assert!((found - expected).amax() <= 1e-8 * expected.amax(), "{found} instead of {expected}");
    }
}

/// The root of cos x cosh x = -1 of a mode of the cantilever.
fn cantilever(mode: usize) -> f64 {
    let mut x = (mode as f64 + 0.5) * PI + if mode == 0 { 0.3 } else { 0.0 };
    for _ in 0..20 {
        x -= (x.cos() + 1.0 / x.cosh()) / (-x.sin() - x.tanh() / x.cosh());
    }
    x
}

/// A cantilevered pipe that carries a fluid, in its first modes, without damping and gravity: `q'' + 2 sqrt(beta) u B q' +
/// (diag(lambda^4) + u^2 D) q = 0` with B and D in closed form (Gregory & Paidoussis 1966).
fn pipe_of<const N: usize>(beta: f64) -> Coefficients<f64, N> {
    let lambda: [f64; N] = std::array::from_fn(cantilever);
    let sigma = lambda.map(|x| (x.sinh() - x.sin()) / (x.cosh() + x.cos()));
    let sign = |i: usize, j: usize| if (i + j).is_multiple_of(2) { 1.0 } else { -1.0 };
    let ratio = |i: usize, j: usize| (lambda[i] / lambda[j]).powi(2);
    let product = |i: usize| lambda[i] * sigma[i];
    let b = Matrix::<f64, N>::from_fn(|i, j| if i == j { 2.0 } else { 4.0 / (ratio(i, j) + sign(i, j)) });
    let d = Matrix::<f64, N>::from_fn(|i, j| match i == j {
        true => product(i) * (2.0 - product(i)),
        false => 4.0 * (product(j) - product(i)) / (sign(i, j) - ratio(i, j)),
    });
    Coefficients {
        m: Matrix::identity(),
        c1: b * (2.0 * beta.sqrt()),
        kc: Matrix::from_diagonal(&lambda.map(|x| x.powi(4)).into()),
        k2: d,
        ..Default::default()
    }
}

/// Up to the last listed one these are all speeds at which stability is lost or won; they were found by a search along the
/// speed with the eigenvalues of NumPy, which for six and more modes have fewer digits.
fn check_pipe<const N: usize>(beta: f64, expected: &[f64], accuracy: f64) {
    let ends = ends_of_stability(&pipe_of::<N>(beta));
    assert_eq!(ends.len(), expected.len(), "{N} modes, {beta}: {ends:?}");
    ends.into_iter().zip(expected).for_each(|(found, &expected)| assert_near(found, expected, accuracy));
}

/// For a share of 0.69 Paidoussis has three thresholds, the pipe being stable once more "from about 11 to about 12.8"
/// (Fluid-Structure Interactions, volume 1, page 114).
#[test]
fn a_pipe_of_any_number_of_modes_flutters() {
    check_pipe::<2>(0.5, &[8.24857489880456], 1e-12);
    check_pipe::<3>(0.1, &[4.759311489246753], 1e-12);
    check_pipe::<3>(0.7, &[10.622283531286197], 1e-12);
    check_pipe::<6>(0.69, &[10.948378530522229, 11.433777619799853, 12.778005059175808], 1e-8);
    check_pipe::<8>(0.69, &[10.934089516710383, 11.438152704503482, 12.71074781324639], 1e-8);
    check_pipe::<10>(0.69, &[10.931066075917807, 11.439123970611265, 12.697859827571685], 1e-7);
    check_pipe::<10>(0.1, &[4.749980678598311], 1e-8);
}
