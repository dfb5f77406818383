//! The published benchmarks, digit by digit.

use carvallo::{Complex, Model};
use carvallo_compare::Real;
use carvallo_tests::exact::{Matrices, matrices};
use carvallo_tests::published::{BENCHMARK_2005, BENCHMARK_2007, Benchmark, EIGENVALUES_2007};
use carvallo_tests::{bicycles, facts};

/// Fails if a value is farther from print than print is from the exact value, and `epsilon` relative to it.
fn check(benchmark: &Benchmark, epsilon: f64, value: impl Fn(usize, usize, usize) -> Real) {
    for (matrix, name) in ["M", "C1", "K0", "K2"].into_iter().enumerate() {
        let scale = Real::from(if name == "K0" { benchmark.gravity } else { 1.0 });
        for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let text = benchmark.matrices[matrix][row][column];
            let printed = Real::parse(text);
            let decimals = text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            let allowed = benchmark.units * 10f64.powi(-(decimals as i32)) + epsilon * printed.abs().to_f64();
            let off = (value(matrix, row, column) * scale - printed).abs().to_f64();
            assert!(off <= allowed, "{}: {name}[{row}, {column}] is {off:e} off {text}", benchmark.bicycle);
        }
    }
}

#[test]
fn exact_matrices_round_to_the_printed_digits() {
    for benchmark in [BENCHMARK_2007, BENCHMARK_2005] {
        let exact: Matrices<Real> = matrices(&bicycles::named(benchmark.bicycle));
        check(&benchmark, 0.0, |matrix, row, column| exact[matrix][row][column]);
    }
}

#[test]
fn generated_matrices_are_a_rounding_from_the_printed_digits() {
    for benchmark in [BENCHMARK_2007, BENCHMARK_2005] {
        let coefficients = bicycles::named(benchmark.bicycle).coefficients();
        let computed = [coefficients.m, coefficients.c1, coefficients.k0, coefficients.k2];
        check(&benchmark, f64::EPSILON, |matrix, row, column| Real::from(computed[matrix][(row, column)]));
    }
}

/// The four eigenvalues of a bicycle, by real and then imaginary part.
fn eigenvalues(bicycle: &str, speed: f64) -> [Complex<f64>; 4] {
    let bicycle = bicycles::named(bicycle);
    bicycle.coefficients().at(speed, bicycle.g).unwrap().quartic_eigenvalues().unwrap()
}

#[test]
fn eigenvalues_are_the_published_ones() {
    for (speed, [a, b, capsize, castering]) in EIGENVALUES_2007 {
        let first_two = if speed == 0.0 { [(a, 0.0), (b, 0.0)] } else { [(a, -b), (a, b)] };
        let mut expected = [(castering, 0.0), (capsize, 0.0), first_two[0], first_two[1]];
        expected.sort_by(|a, b| a.partial_cmp(b).unwrap());
        for (found, (re, im)) in eigenvalues("benchmark", speed).into_iter().zip(expected) {
            assert!((found - Complex::new(re, im)).norm() <= 1e-12, "at {speed}: {found} instead of {re} + {im}i");
        }
    }
}

#[test]
fn eigenvalues_are_the_recomputed_ones() {
    for four in facts::eigenvalues().chunks(4) {
        let facts::Eigenvalue { bicycle, speed, .. } = four[0];
        let largest = four.iter().map(|expected| expected.value.norm()).fold(0.0, f64::max);
        for (found, expected) in eigenvalues(bicycle, speed).into_iter().zip(four) {
            let off = (found - expected.value).norm() / largest;
            assert!(off <= 2e-14, "{bicycle} at {speed}: {found} is off {} by {off:e}", expected.value);
        }
    }
}
