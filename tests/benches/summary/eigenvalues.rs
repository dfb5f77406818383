//! The four eigenvalues of a bicycle at a speed.

use std::hint::black_box;

use carvallo::{Matrix, Model, System};
use carvallo_tests::bicycles;
use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, evd_real, evd_scratch};
use faer::{Mat, Par};
use nalgebra::{Matrix4, Schur};

use crate::Summary;
use crate::contest::Task;

/// A fixed bound, since an unbounded iteration has been seen not to end.
const ITERATIONS: usize = 500;

/// The fourteen bicycles from 0 to 10 m/s in steps of 0.05 m/s, through their double roots.
fn systems() -> Vec<System<2>> {
    let along = |bicycle: carvallo_models::Whipple| {
        let coefficients = bicycle.coefficients();
        (0..=200).map(move |step| coefficients.at(0.05 * f64::from(step), bicycle.g).expect("a system"))
    };
    bicycles::all().into_iter().flat_map(|(_, bicycle)| along(bicycle)).collect()
}

pub fn add(summary: &mut Summary) {
    let systems = systems();
    let matrices: Vec<Matrix4<f64>> = systems.iter().map(|system| system.state_space().expect("finite").a()).collect();
    let name = "Eigenvalues, 14 bicycles at 201 speeds each";
    let task = Task::new(name, systems.len())
        .contender("nalgebra 0.35, complex_eigenvalues", each(&matrices, Matrix::complex_eigenvalues))
        .contender(
            "nalgebra 0.35, Schur::try_new",
            each(&matrices, |matrix| {
                Schur::try_new(*matrix, f64::EPSILON, ITERATIONS).map(|schur| schur.complex_eigenvalues())
            }),
        )
        .contender("faer 0.24, evd_real", faer(&matrices))
        .contender("ours, from M, C and K", each(&systems, System::quartic_eigenvalues));
    summary.run(task);
}

fn each<S, E>(systems: &[S], compute: impl Fn(&S) -> E) -> impl FnMut() {
    move || {
        for system in systems {
            black_box(compute(black_box(system)));
        }
    }
}

/// Without eigenvectors, in memory that is there already.
fn faer(matrices: &[Matrix4<f64>]) -> impl FnMut() + use<> {
    let matrices: Vec<Mat<f64>> = matrices.iter().map(|a| Mat::from_fn(4, 4, |i, j| a[(i, j)])).collect();
    let no = ComputeEigenvectors::No;
    let mut memory = MemBuffer::new(evd_scratch::<f64>(4, no, no, Par::Seq, Default::default()));
    let (mut re, mut im) = (Diag::zeros(4), Diag::zeros(4));
    move || {
        for matrix in &matrices {
            let (matrix, stack) = (black_box(matrix).as_ref(), MemStack::new(&mut memory));
            let done = evd_real(matrix, re.as_mut(), im.as_mut(), None, None, Par::Seq, stack, Default::default());
            black_box((done.is_ok(), &re, &im));
        }
    }
}
