//! Values and all derivatives against the values alone, of one design that stays in cache.
//!
//! First both are timed in turns, a few microseconds each, so that what else the machine does falls on both: the ratio is
//! the median of those of all rounds. Then criterion times each by itself.

#![allow(missing_docs)] // `criterion_group!` makes public functions.

use std::hint::black_box;
use std::time::Instant;

use carvallo_models::{Whipple, WhippleMechanism};
use carvallo_tests::designs;
use criterion::{Criterion, criterion_group, criterion_main};

const ROUNDS: usize = 20_001;
const CALLS: u32 = 200;

/// The median times of two functions in nanoseconds, and the median of their ratios in one round.
fn in_turns<A, B>(mut one: impl FnMut() -> A, mut other: impl FnMut() -> B) -> [f64; 3] {
    fn time<R>(function: &mut impl FnMut() -> R) -> f64 {
        let start = Instant::now();
        for _ in 0..CALLS {
            // Left where it is: copying a kilobyte takes as long as computing it.
            black_box(&function());
        }
        start.elapsed().as_secs_f64() * 1e9 / f64::from(CALLS)
    }
    let rounds: Vec<[f64; 2]> = (0..ROUNDS).map(|_| [time(&mut one), time(&mut other)]).collect();
    let median = |of: fn(&[f64; 2]) -> f64| {
        let mut values: Vec<f64> = rounds.iter().map(of).collect();
        values.sort_by(f64::total_cmp);
        values[ROUNDS / 2]
    };
    [median(|[one, _]| *one), median(|[_, other]| *other), median(|[one, other]| other / one)]
}

/// Times a model of some kind.
macro_rules! time {
    ($criterion:expr, $name:expr, $model:expr) => {{
        let model = $model;
        let (mut matrices, mut derivatives) = model.matrices_and_derivatives();
        let mut in_place = || {
            black_box(&model).write_matrices_and_derivatives(&mut matrices, &mut derivatives);
            black_box((&matrices, &derivatives));
        };
        let values = || black_box(&model).matrices();
        let both = || black_box(&model).matrices_and_derivatives();
        for (how, [alone, all, ratio]) in
            [("returned", in_turns(values, both)), ("in place", in_turns(values, &mut in_place))]
        {
            let name = $name;
            println!("{name}, {how}: values {alone:.1} ns, with derivatives {all:.1} ns, ratio {ratio:.2}");
        }
        let mut group = $criterion.benchmark_group($name);
        group.bench_function("values", |bencher| bencher.iter(values));
        group.bench_function("with derivatives", |bencher| bencher.iter(both));
        group.bench_function("with derivatives, in place", |bencher| bencher.iter(&mut in_place));
        group.finish();
    }};
}

fn derivatives(criterion: &mut Criterion) {
    let (double, single) = (Whipple::BENCHMARK, designs::narrowed(&Whipple::BENCHMARK));
    time!(criterion, "from bodies, f64", WhippleMechanism::from_array(double.to_array()));
    time!(criterion, "from formulas, f64", double);
    time!(criterion, "from bodies, f32", WhippleMechanism::from_array(single.to_array()));
    time!(criterion, "from formulas, f32", single);
}

criterion_group!(benches, derivatives);
criterion_main!(benches);
