//! All critical speeds and stable ranges of one design, and its modes at one speed; beside the four eigenvalues at one
//! speed by nalgebra's QR iteration, for the ratio.

#![allow(missing_docs)] // `criterion_group!` makes public functions.

use std::hint::black_box;

use carvallo::{Coefficients, Model, Modes, Stability};
use carvallo_models::Whipple;
use carvallo_tests::facts::{RandomSystem, random_systems};
use carvallo_tests::{bicycles, designs};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use nalgebra::{Matrix4, Schur};

/// More random designs than branch predictors learn; their matrices are 1.5 MB.
const DESIGNS: u64 = 8192;

/// A fixed bound, since an unbounded iteration has been seen not to end.
const ITERATIONS: usize = 200;

type Design = (Coefficients<f64, 2>, f64);

fn with_gravity(design: &Whipple) -> Design {
    (design.coefficients(), design.g)
}

fn stability(criterion: &mut Criterion) {
    let bicycle = Whipple::BENCHMARK;
    let coefficients = bicycle.coefficients();
    let system = coefficients.at(5.0, bicycle.g).expect("a system");
    let matrix = system.state_space().expect("a state space").a();

    let mut group = criterion.benchmark_group("critical speeds and stable ranges");
    group.bench_function("the benchmark bicycle", |bencher| {
        bencher.iter(|| Stability::new(black_box(&coefficients), bicycle.g));
    });
    for (name, bicycle) in bicycles::all() {
        let (coefficients, gravity) = with_gravity(&bicycle);
        group.bench_function(name, |bencher| bencher.iter(|| Stability::new(black_box(&coefficients), gravity)));
    }
    let shipped: Vec<Design> = bicycles::all().iter().map(|(_, bicycle)| with_gravity(bicycle)).collect();
    let random: Vec<Design> = (0..DESIGNS).map(|number| with_gravity(&designs::numbered(number))).collect();
    for (name, designs) in [("all shipped bicycles", shipped), ("random designs", random)] {
        group.throughput(Throughput::Elements(designs.len() as u64));
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                for (coefficients, gravity) in &designs {
                    let _ = black_box(Stability::new(black_box(coefficients), *gravity));
                }
            });
        });
    }
    random_systems_of::<3>(&mut group);
    random_systems_of::<6>(&mut group);
    group.finish();

    let modes = Modes::new(&coefficients, bicycle.g).expect("modes");
    criterion.bench_function("modes along speed", |bencher| {
        bencher.iter(|| Modes::new(black_box(&coefficients), bicycle.g));
    });
    criterion.bench_function("modes at one speed", |bencher| bencher.iter(|| modes.at(black_box(5.0))));
    criterion.bench_function("eigenvalues at one speed by nalgebra, from A", |bencher| {
        bencher.iter(|| {
            let matrix: Matrix4<f64> = *black_box(&matrix);
            Schur::try_new(matrix, f64::EPSILON, ITERATIONS).map(|schur| schur.complex_eigenvalues())
        });
    });
}

/// All random systems of so many coordinates, for which critical speeds are known, each as often as the others.
fn random_systems_of<const N: usize>(group: &mut BenchmarkGroup<'_, WallTime>) {
    let systems = random_systems().into_iter().filter(|system| system.coordinates == N);
    let systems: Vec<Coefficients<f64, N>> = systems.map(|system| system.coefficients()).collect();
    group.throughput(Throughput::Elements(systems.len() as u64));
    group.bench_function(format!("random systems of {N} coordinates"), |bencher| {
        bencher.iter(|| {
            for coefficients in &systems {
                let _ = black_box(Stability::new(black_box(coefficients), RandomSystem::GRAVITY));
            }
        });
    });
}

criterion_group!(benches, stability);
criterion_main!(benches);
