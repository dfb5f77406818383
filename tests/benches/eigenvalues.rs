//! Eigenvalues of two coordinates through the characteristic quartic, and of a 4 x 4 matrix by nalgebra's QR iteration.

#![allow(missing_docs)] // `criterion_group!` makes public functions.

use std::hint::black_box;

use carvallo::{Model, System};
use carvallo_models::Whipple;
use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::{Matrix4, Schur};

/// A fixed bound, since an unbounded iteration has been seen not to end.
const ITERATIONS: usize = 200;

fn eigenvalues(criterion: &mut Criterion) {
    let bicycle = Whipple::BENCHMARK;
    let system = bicycle.coefficients().at(5.0, bicycle.g).expect("a system");
    let matrix = system.state_space().expect("a state space").a();
    let mut group = criterion.benchmark_group("eigenvalues");
    group.bench_function("quartic, from M, C and K", |bencher| {
        bencher.iter(|| System::quartic_eigenvalues(black_box(&system)));
    });
    group.bench_function("nalgebra, from A", |bencher| {
        bencher.iter(|| {
            let matrix: Matrix4<f64> = *black_box(&matrix);
            Schur::try_new(matrix, f64::EPSILON, ITERATIONS).map(|schur| schur.complex_eigenvalues())
        });
    });
    group.finish();
}

criterion_group!(benches, eigenvalues);
criterion_main!(benches);
