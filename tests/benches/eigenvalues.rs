//! Eigenvalues side by side with those of nalgebra and faer, which take them from the state matrix.

#![allow(missing_docs)] // `criterion_group!` makes public functions.

#[path = "summary/systems.rs"]
mod systems;

use std::hint::black_box;
use std::time::Duration;

use carvallo::batch::Batch;
use carvallo::{Complex, Model, System};
use carvallo_models::{ThreePipes, WhippleLeaning};
use carvallo_tests::bicycles;
use carvallo_tests::textbook::pendulum::{Link, standing_at_hinges};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main};
use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, evd_real, evd_scratch};
use faer::{Mat, Par};
use nalgebra::{DMatrix, SMatrix, Schur};

/// A fixed bound, since an unbounded iteration has been seen not to end.
const ITERATIONS: usize = 500;

fn speeds() -> Vec<f64> {
    (0..=200).map(|step| 0.05 * f64::from(step)).collect()
}

/// The fourteen bicycles from 0 to 10 m/s in steps of 0.05 m/s, through all their double roots.
fn real_bicycles() -> Vec<System<2>> {
    let along = |bicycle: carvallo_models::Whipple| {
        let coefficients = bicycle.coefficients();
        speeds().into_iter().map(move |speed| coefficients.at(speed, bicycle.g).expect("a system"))
    };
    bicycles::all().into_iter().flat_map(|(_, bicycle)| along(bicycle)).collect()
}

fn state_matrix<const N: usize>(system: &System<N>) -> DMatrix<f64> {
    let blocks = system.state_space().expect("a state space");
    DMatrix::from_fn(2 * N, 2 * N, |i, j| match (i.checked_sub(N), j.checked_sub(N)) {
        (None, None) => 0.0,
        (None, Some(j)) => f64::from(u8::from(i == j)),
        (Some(i), None) => blocks.stiffness[(i, j)],
        (Some(i), Some(j)) => blocks.damping[(i, j)],
    })
}

/// faer's eigenvalues without eigenvectors, in memory that is there already.
fn faer(group: &mut BenchmarkGroup<WallTime>, matrices: &[DMatrix<f64>]) {
    let n = matrices[0].nrows();
    let matrices: Vec<Mat<f64>> = matrices.iter().map(|a| Mat::from_fn(n, n, |i, j| a[(i, j)])).collect();
    let no = ComputeEigenvectors::No;
    let mut memory = MemBuffer::new(evd_scratch::<f64>(n, no, no, Par::Seq, Default::default()));
    let (mut re, mut im) = (Diag::zeros(n), Diag::zeros(n));
    group.bench_function("faer", |bencher| {
        bencher.iter(|| {
            for a in &matrices {
                let stack = MemStack::new(&mut memory);
                let done = evd_real(
                    black_box(a).as_ref(),
                    re.as_mut(),
                    im.as_mut(),
                    None,
                    None,
                    Par::Seq,
                    stack,
                    Default::default(),
                );
                black_box((done.is_ok(), &re, &im));
            }
        });
    });
}

/// The eigenvalues of many bicycles at once, at every level of the processor: from their systems, and along speed.
fn batches(group: &mut BenchmarkGroup<WallTime>) {
    let (systems, speeds) = (real_bicycles(), speeds());
    let designs = bicycles::all().into_iter().map(|(_, bicycle)| (bicycle.coefficients(), bicycle.g));
    let designs: Vec<_> = designs.collect();
    let mut eigenvalues = vec![Ok([Complex::new(0.0, 0.0); 4]); systems.len()];
    for batch in Batch::levels() {
        group.bench_function(format!("ours, systems, {batch}"), |bencher| {
            bencher.iter(|| batch.eigenvalues(black_box(&systems), black_box(&mut eigenvalues)));
        });
        group.bench_function(format!("ours, along speed, {batch}"), |bencher| {
            bencher.iter(|| {
                for ((coefficients, gravity), eigenvalues) in designs.iter().zip(eigenvalues.chunks_mut(speeds.len())) {
                    let done = batch.eigenvalues_along(black_box(coefficients), *gravity, &speeds, eigenvalues);
                    black_box((done.is_ok(), eigenvalues));
                }
            });
        });
    }
}

/// One group for systems of N coordinates, whose state matrices have 2 N rows.
macro_rules! compare {
    ($criterion:expr, $name:expr, $systems:expr, $rows:literal, $ours:expr, $more:expr) => {{
        let systems = $systems;
        let mut group = $criterion.benchmark_group($name);
        group.throughput(Throughput::Elements(systems.len() as u64));
        group.warm_up_time(Duration::from_millis(500)).measurement_time(Duration::from_secs(1)).sample_size(20);
        let ours = $ours;
        group.bench_function("ours, from M, C and K", |bencher| {
            bencher.iter(|| {
                for system in &systems {
                    let _ = black_box(ours(black_box(system)));
                }
            });
        });
        let matrices: Vec<_> = systems.iter().map(state_matrix).collect();
        let fixed: Vec<SMatrix<f64, $rows, $rows>> =
            matrices.iter().map(|a| SMatrix::from_fn(|i, j| a[(i, j)])).collect();
        group.bench_function("nalgebra, Schur", |bencher| {
            bencher.iter(|| {
                for a in &fixed {
                    let schur = Schur::try_new(*black_box(a), f64::EPSILON, ITERATIONS);
                    black_box(schur.map(|schur| schur.complex_eigenvalues()));
                }
            });
        });
        // Without Q and without a bound: these matrices are such that it ends.
        group.bench_function("nalgebra, complex_eigenvalues", |bencher| {
            bencher.iter(|| {
                for a in &fixed {
                    black_box(black_box(a).complex_eigenvalues());
                }
            });
        });
        faer(&mut group, &matrices);
        for batch in Batch::levels() {
            let mut eigenvalues = vec![Ok(Vec::new()); systems.len()];
            group.bench_function(format!("ours, systems of any size, {batch}"), |bencher| {
                bencher.iter(|| batch.eigenvalues_of_any(black_box(&systems), black_box(&mut eigenvalues)));
            });
        }
        $more(&mut group);
        group.finish();
    }};
}

/// Links that differ a little, with damping in their hinges if there is any.
fn chain<const N: usize>(damping: f64) -> System<N> {
    let links = std::array::from_fn(|link| {
        let l = 0.4 + 0.05 * link as f64;
        Link { l, a: 0.5 * l, m: 1.5 - 0.1 * link as f64, i: 0.02 + 0.001 * link as f64 }
    });
    let mut system = standing_at_hinges::<N>(links).at(0.0, -9.81).expect("a chain");
    system.c.fill_diagonal(damping);
    system
}

fn eigenvalues(criterion: &mut Criterion) {
    compare!(criterion, "N = 2, bicycles", real_bicycles(), 4, System::quartic_eigenvalues, batches);
    let leaning = WhippleLeaning::EXAMPLE;
    let speeds = (0..=50).map(|step| 0.2 * f64::from(step));
    let systems: Vec<_> = speeds.map(|speed| leaning.coefficients().at(speed, leaning.g).expect("a system")).collect();
    compare!(criterion, "N = 3, bicycle with a leaning rider", systems, 6, System::eigenvalues, |_: &mut _| ());
    let speeds = (0..=50).map(|step| 0.2 * f64::from(step));
    let hose = ThreePipes::HOSE.coefficients();
    let systems: Vec<_> = speeds.map(|speed| hose.at(speed, 9.81).expect("a system")).collect();
    compare!(criterion, "N = 3, pipes", systems, 6, System::eigenvalues, |_: &mut _| ());
    macro_rules! sizes {
        ($($n:literal $rows:literal)*) => {$(
            let name = |kind: &str| format!("N = {}, {kind}", $n);
            compare!(criterion, name("chain"), [chain::<$n>(0.0)], $rows, System::eigenvalues, |_: &mut _| ());
            compare!(criterion, name("damped chain"), [chain::<$n>(0.2)], $rows, System::eigenvalues, |_: &mut _| ());
            compare!(criterion, name("random"), systems::random::<$n>(50), $rows, System::eigenvalues, |_: &mut _| ());
        )*};
    }
    sizes!(1 2 3 6 4 8 5 10 6 12 7 14 8 16);
}

criterion_group!(benches, eigenvalues);
criterion_main!(benches);
