//! Values and all derivatives against the values alone, of one design that stays in cache.
//!
//! The two are measured in turns, round by round, so that what else the machine does falls on both; the ratio is that of
//! the medians.

#![allow(missing_docs)] // `criterion_group!` makes public functions.

use std::hint::black_box;

use carvallo::Scalar;
use carvallo_models::{Whipple, WhippleMechanism};
use carvallo_tests::designs;
use criterion::{Criterion, criterion_group, criterion_main};

fn one_design<T: Scalar>(criterion: &mut Criterion, scalar: &str, design: Whipple<T>) {
    let mechanism = WhippleMechanism::from_array(design.to_array());
    let mut group = criterion.benchmark_group(format!("derivatives in cache, {scalar}"));
    group.bench_function("from bodies, values", |bencher| bencher.iter(|| black_box(&mechanism).matrices()));
    group.bench_function("from bodies, with derivatives", |bencher| {
        bencher.iter(|| black_box(&mechanism).matrices_and_derivatives());
    });
    group.bench_function("from formulas, values", |bencher| bencher.iter(|| black_box(&design).matrices()));
    group.bench_function("from formulas, with derivatives", |bencher| {
        bencher.iter(|| black_box(&design).matrices_and_derivatives());
    });
    group.finish();
}

fn derivatives(criterion: &mut Criterion) {
    one_design(criterion, "f64", Whipple::BENCHMARK);
    one_design(criterion, "f32", designs::narrowed(&Whipple::BENCHMARK));
}

criterion_group!(benches, derivatives);
criterion_main!(benches);
