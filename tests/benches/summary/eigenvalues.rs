//! The four eigenvalues of a bicycle at a speed.

use std::hint::black_box;

use carvallo::batch::{Batch, Eigenvalues};
use carvallo::{Coefficients, Matrix, Model, System};
use carvallo_compare::Task;
use carvallo_tests::bicycles;
use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, evd_real, evd_scratch};
use faer::{Mat, Par};
use nalgebra::{Matrix4, Schur};

use crate::Summary;

/// A fixed bound, since an unbounded iteration has been seen not to end.
const ITERATIONS: usize = 500;

/// From 0 to 10 m/s in steps of 0.05 m/s, through all double roots.
const SPEEDS: usize = 201;

fn speeds() -> [f64; SPEEDS] {
    std::array::from_fn(|step| 0.05 * step as f64)
}

/// In each round one of the fourteen bicycles, the same for all contenders.
pub fn add(summary: &mut Summary) {
    let bicycles: Vec<_> = bicycles::all().iter().map(|(_, bicycle)| (bicycle.coefficients(), bicycle.g)).collect();
    let system = |(coefficients, gravity): &(Coefficients<f64, 2>, f64), speed| coefficients.at(speed, *gravity);
    let of_bicycle = |bicycle| speeds().map(|speed| system(bicycle, speed).expect("a system"));
    let systems: Vec<[System<2>; SPEEDS]> = bicycles.iter().map(of_bicycle).collect();
    let of_system = |system: System<2>| system.state_space().expect("a state space").a();
    let matrices: Vec<[Matrix4<f64>; SPEEDS]> = systems.iter().map(|systems| systems.map(of_system)).collect();
    let task = Task::new("Eigenvalues, 14 bicycles at 201 speeds each", SPEEDS)
        .contender("nalgebra 0.35, complex_eigenvalues", each(&matrices, Matrix::complex_eigenvalues))
        .contender(
            "nalgebra 0.35, Schur::try_new",
            each(&matrices, |matrix| {
                Schur::try_new(*matrix, f64::EPSILON, ITERATIONS).map(|schur| schur.complex_eigenvalues())
            }),
        )
        .contender("faer 0.24, evd_real", faer(&matrices))
        .contender("ours, from M, C and K", each(&systems, System::quartic_eigenvalues))
        .contender("ours, batch of systems", batch(&systems))
        .contender("ours, batch along the speed", along(&bicycles));
    summary.run(task);
}

fn each<S, E>(bicycles: &[[S; SPEEDS]], compute: impl Fn(&S) -> E) -> impl FnMut() {
    let mut bicycles = bicycles.iter().cycle();
    move || {
        for system in bicycles.next().expect("bicycles without end") {
            black_box(compute(black_box(system)));
        }
    }
}

fn batch(bicycles: &[[System<2>; SPEEDS]]) -> impl FnMut() {
    let mut bicycles = bicycles.iter().cycle();
    let mut found: [Eigenvalues; SPEEDS] = [const { Ok([nalgebra::Complex::new(0.0, 0.0); 4]) }; SPEEDS];
    move || {
        let systems = bicycles.next().expect("bicycles without end");
        Batch::new().eigenvalues(black_box(systems), black_box(&mut found)).expect("slices of equal length");
    }
}

/// The same systems, from the coefficients of each bicycle and the speeds.
fn along(bicycles: &[(Coefficients<f64, 2>, f64)]) -> impl FnMut() {
    let mut bicycles = bicycles.iter().cycle();
    let speeds = speeds();
    let mut found: [Eigenvalues; SPEEDS] = [const { Ok([nalgebra::Complex::new(0.0, 0.0); 4]) }; SPEEDS];
    move || {
        let (coefficients, gravity) = bicycles.next().expect("bicycles without end");
        let (coefficients, speeds) = (black_box(coefficients), black_box(&speeds));
        let done = Batch::new().eigenvalues_along(coefficients, *gravity, speeds, black_box(&mut found));
        done.expect("slices of equal length");
    }
}

/// Without eigenvectors, in memory that is there already.
fn faer(bicycles: &[[Matrix4<f64>; SPEEDS]]) -> impl FnMut() + use<> {
    let matrix = |a: &Matrix4<f64>| Mat::from_fn(4, 4, |i, j| a[(i, j)]);
    let bicycles: Vec<Vec<Mat<f64>>> = bicycles.iter().map(|matrices| matrices.iter().map(matrix).collect()).collect();
    let no = ComputeEigenvectors::No;
    let mut memory = MemBuffer::new(evd_scratch::<f64>(4, no, no, Par::Seq, Default::default()));
    let (mut re, mut im) = (Diag::zeros(4), Diag::zeros(4));
    let mut turn = (0..bicycles.len()).cycle();
    move || {
        for matrix in &bicycles[turn.next().expect("bicycles without end")] {
            let (matrix, stack) = (black_box(matrix).as_ref(), MemStack::new(&mut memory));
            let done = evd_real(matrix, re.as_mut(), im.as_mut(), None, None, Par::Seq, stack, Default::default());
            black_box((done.is_ok(), &re, &im));
        }
    }
}
