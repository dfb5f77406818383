//! Values and all derivatives against the values alone, of one design that stays in cache.
//!
//! First both are timed in turns, a few microseconds each, so that what else the machine does falls on both: the ratio is
//! the median of those of all rounds. Then criterion times each by itself.

#![allow(missing_docs)] // `criterion_group!` makes public functions.

use std::hint::black_box;
use std::time::Instant;

use carvallo::Scalar;
use carvallo_models::{Whipple, WhippleMechanism};
use carvallo_tests::designs;
use criterion::{Criterion, criterion_group, criterion_main};

const ROUNDS: usize = 20_001;
const CALLS: u32 = 200;

/// The median times of two functions in nanoseconds, and the median of their ratios in one round.
fn in_turns<A, B>(one: impl Fn() -> A, other: impl Fn() -> B) -> [f64; 3] {
    fn time<R>(function: &impl Fn() -> R) -> f64 {
        let start = Instant::now();
        for _ in 0..CALLS {
            black_box(function());
        }
        start.elapsed().as_secs_f64() * 1e9 / f64::from(CALLS)
    }
    let rounds: Vec<[f64; 2]> = (0..ROUNDS).map(|_| [time(&one), time(&other)]).collect();
    let median = |of: fn(&[f64; 2]) -> f64| {
        let mut values: Vec<f64> = rounds.iter().map(of).collect();
        values.sort_by(f64::total_cmp);
        values[ROUNDS / 2]
    };
    [median(|[one, _]| *one), median(|[_, other]| *other), median(|[one, other]| other / one)]
}

fn one_design<T: Scalar>(criterion: &mut Criterion, scalar: &str, design: Whipple<T>) {
    let mechanism = WhippleMechanism::from_array(design.to_array());
    let print = |name: &str, [values, all, ratio]: [f64; 3]| {
        println!("{name}, {scalar}: values {values:.1} ns, with derivatives {all:.1} ns, ratio {ratio:.2}");
    };
    print(
        "from bodies",
        in_turns(|| black_box(&mechanism).matrices(), || black_box(&mechanism).matrices_and_derivatives()),
    );
    print(
        "from formulas",
        in_turns(|| black_box(&design).matrices(), || black_box(&design).matrices_and_derivatives()),
    );
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
