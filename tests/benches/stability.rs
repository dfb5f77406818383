//! All critical speeds and stable ranges of one design, and its modes at one speed.

#![allow(missing_docs)] // `criterion_group!` makes public functions.

use std::hint::black_box;

use carvallo::{Model, Modes, Stability};
use carvallo_models::Whipple;
use criterion::{Criterion, criterion_group, criterion_main};

fn stability(criterion: &mut Criterion) {
    let bicycle = Whipple::BENCHMARK;
    let coefficients = bicycle.coefficients();
    criterion.bench_function("critical speeds and stable ranges", |bencher| {
        bencher.iter(|| Stability::new(black_box(&coefficients), bicycle.g));
    });
    let modes = Modes::new(&coefficients, bicycle.g).expect("modes");
    criterion.bench_function("modes at one speed", |bencher| bencher.iter(|| modes.at(black_box(5.0))));
}

criterion_group!(benches, stability);
criterion_main!(benches);
