//! Generated against hand-written matrices: of one design and 64 that stay in cache, and of a million distinct designs.
//!
//! A million designs are 208 MB of parameters and 128 MB of matrices in `f64`, half of that in `f32`: more than any
//! cache. Both sides read and write the same memory.

#![allow(missing_docs)] // `criterion_group!` makes public functions.

use std::hint::black_box;

use carvallo_compare::Contender;
use carvallo_models::{Whipple, WhippleMechanism};
use carvallo_tests::hand_written::{self, Float};
use carvallo_tests::peers::symplex::{self, Symplex};
use carvallo_tests::{designs, rounding};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};

const DESIGNS: u64 = 1_000_000;

/// One design and 64 of them, as the library compares them.
fn in_cache(criterion: &mut Criterion) {
    let tasks = rounding::four_ways((0..64).map(designs::numbered)).tasks().expect("designs");
    for task in tasks {
        let mut group = criterion.benchmark_group(format!("matrices, {}", task.name));
        group.throughput(Throughput::Elements(task.repetitions));
        for Contender { name, mut run, .. } in task.contenders {
            group.bench_function(name, |bencher| bencher.iter(&mut run));
        }
        group.finish();
    }
}

fn million_designs<T: Float + Symplex>(criterion: &mut Criterion, scalar: &str, design: fn(u64) -> Whipple<T>) {
    let designs: Vec<Whipple<T>> = (0..DESIGNS).map(design).collect();
    let mechanisms: Vec<_> = designs.iter().map(|design| WhippleMechanism::from_array(design.to_array())).collect();
    let mut group = criterion.benchmark_group(format!("matrices of a million designs, {scalar}"));
    group.throughput(Throughput::Elements(DESIGNS)).sample_size(10);
    all(&mut group, "from bodies", &mechanisms, WhippleMechanism::matrices);
    all(&mut group, "from formulas", &designs, Whipple::matrices);
    all(&mut group, "hand-written", &designs, hand_written::matrices);
    all(&mut group, "symplex-build", &designs, symplex::matrices);
    group.finish();
}

fn all<D, M>(group: &mut BenchmarkGroup<'_, WallTime>, name: &str, designs: &[D], compute: fn(&D) -> M) {
    // Once before, so that the memory of the results is there.
    let mut matrices: Vec<M> = designs.iter().map(compute).collect();
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            for (matrices, design) in matrices.iter_mut().zip(designs) {
                *matrices = compute(design);
            }
            black_box(&mut matrices);
        });
    });
}

fn matrices(criterion: &mut Criterion) {
    in_cache(criterion);
    million_designs(criterion, "f64", designs::numbered);
    million_designs(criterion, "f32", |number| designs::narrowed(&designs::numbered(number)));
}

criterion_group!(benches, matrices);
criterion_main!(benches);
