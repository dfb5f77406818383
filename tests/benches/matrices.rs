//! Generated against hand-written matrices: of one design that stays in cache, and of a million distinct designs.
//!
//! A million designs are 208 MB of parameters and 128 MB of matrices in `f64`, half of that in `f32`: more than any
//! cache. Both sides read and write the same memory.

#![allow(missing_docs)] // `criterion_group!` makes public functions.

use std::hint::black_box;

use carvallo::Scalar;
use carvallo_models::{Whipple, WhippleMatrices};
use carvallo_tests::{designs, hand_written};
use criterion::{Criterion, Throughput, criterion_group, criterion_main};

const DESIGNS: u64 = 1_000_000;

fn one_design<T: Scalar>(criterion: &mut Criterion, scalar: &str, design: Whipple<T>) {
    let mut group = criterion.benchmark_group(format!("matrices in cache, {scalar}"));
    group.bench_function("generated", |bencher| bencher.iter(|| black_box(&design).matrices()));
    group.bench_function("hand-written", |bencher| bencher.iter(|| hand_written::matrices(black_box(&design))));
    group.finish();
}

fn million_designs<T: Scalar>(criterion: &mut Criterion, scalar: &str, design: fn(u64) -> Whipple<T>) {
    let designs: Vec<Whipple<T>> = (0..DESIGNS).map(design).collect();
    let mut matrices: Vec<WhippleMatrices<T>> = designs.iter().map(Whipple::matrices).collect();
    let mut group = criterion.benchmark_group(format!("matrices of a million designs, {scalar}"));
    group.throughput(Throughput::Elements(DESIGNS)).sample_size(10);
    let mut all = |name, compute: fn(&Whipple<T>) -> WhippleMatrices<T>| {
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                for (matrices, design) in matrices.iter_mut().zip(&designs) {
                    *matrices = compute(design);
                }
                black_box(&mut matrices);
            });
        });
    };
    all("generated", Whipple::matrices);
    all("hand-written", hand_written::matrices);
    group.finish();
}

fn matrices(criterion: &mut Criterion) {
    one_design(criterion, "f64", Whipple::BENCHMARK);
    one_design(criterion, "f32", designs::narrowed(&Whipple::BENCHMARK));
    million_designs(criterion, "f64", designs::numbered);
    million_designs(criterion, "f32", |number| designs::narrowed(&designs::numbered(number)));
}

criterion_group!(benches, matrices);
criterion_main!(benches);
