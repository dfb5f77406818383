//! The published benchmarks, digit by digit.

use carvallo::Model;
use carvallo_models::Whipple;
use carvallo_tests::bicycles;
use carvallo_tests::exact::{Matrices, matrices};
use carvallo_tests::published::{BENCHMARK_2005, BENCHMARK_2007, Benchmark};
use carvallo_tests::real::Real;

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
