//! The derivatives of all critical speeds with respect to all parameters, beside the critical speeds themselves.

#![allow(missing_docs)] // `criterion_group!` makes public functions.

use std::hint::black_box;

use carvallo::{Model, Sensitivity, Stability};
use carvallo_tests::bicycles;
use criterion::{Criterion, criterion_group, criterion_main};

fn sensitivity(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("sensitivity");
    for name in ["benchmark", "browser"] {
        let bicycle = bicycles::named(name);
        let stability = Stability::new(&bicycle.coefficients(), bicycle.g).expect("stability of a bicycle");
        group.bench_function(format!("critical speeds/{name}"), |bencher| {
            bencher.iter(|| Stability::new(&black_box(&bicycle).coefficients(), bicycle.g))
        });
        group.bench_function(format!("derivatives of critical speeds/{name}"), |bencher| {
            bencher.iter(|| {
                let sensitivity = Sensitivity::of(black_box(&bicycle)).expect("derivatives of a bicycle");
                stability.critical_speeds.iter().for_each(|critical| {
                    black_box(sensitivity.critical_speed(critical)).expect("derivatives of a critical speed");
                });
            })
        });
        group.bench_function(format!("derivatives of the eigenvalues/{name}"), |bencher| {
            bencher.iter(|| {
                let sensitivity = Sensitivity::of(black_box(&bicycle)).expect("derivatives of a bicycle");
                sensitivity.eigenvalues(black_box(5.0))
            })
        });
    }
    group.finish();
}

criterion_group!(benches, sensitivity);
criterion_main!(benches);
