//! The four eigenvalues of a bicycle at a speed, and those of more coordinates.

use std::hint::black_box;

use carvallo::batch::{Batch, Eigenvalues};
use carvallo::{Coefficients, Matrix, Model, System};
use carvallo_compare::Task;
use carvallo_models::{CantileveredPipe, ThreePipes, WhippleLeaning};
use carvallo_tests::bicycles;
use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{ComputeEigenvectors, evd_real, evd_scratch};
use faer::{Mat, Par};
use nalgebra::{Matrix4, SMatrix, Schur};

use crate::Summary;
use crate::systems::random;

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
        .contender("faer 0.24, evd_real", faer(matrices.iter().map(|of| by_faer(of)).collect()))
        .contender("ours, from M, C and K", each(&systems, System::quartic_eigenvalues))
        .contender("ours, batch of systems", batch(&systems))
        .contender("ours, batch along the speed", along(&bicycles));
    summary.run(task);
    macro_rules! of_coordinates {
        ($($name:expr, $systems:expr, $n:literal $rows:literal)*) => {$({
            let systems = $systems;
            let of_system = |system: &System<$n>| {
                let space = system.state_space().expect("a state space");
                SMatrix::<f64, $rows, $rows>::from_fn(|i, j| match (i.checked_sub($n), j.checked_sub($n)) {
                    (None, j) => f64::from(u8::from(j == Some(i))),
                    (Some(i), None) => space.stiffness[(i, j)],
                    (Some(i), Some(j)) => space.damping[(i, j)],
                })
            };
            let matrices: Vec<_> = systems.iter().map(of_system).collect();
            let mut found = vec![Ok(Vec::new()); systems.len()];
            let task = Task::new($name, systems.len())
                .contender("nalgebra 0.35, complex_eigenvalues", one_by_one(&matrices, Matrix::complex_eigenvalues))
                .contender("nalgebra 0.35, Schur::try_new", one_by_one(&matrices, |matrix| {
                    Schur::try_new(*matrix, f64::EPSILON, ITERATIONS).map(|schur| schur.complex_eigenvalues())
                }))
                .contender("faer 0.24, evd_real", faer(vec![by_faer(&matrices)]))
                .contender("ours, from M, C and K", one_by_one(&systems, System::eigenvalues))
                .contender("ours, batch of systems", || {
                    let done = Batch::new().eigenvalues_of_any(black_box(&systems), black_box(&mut found));
                    done.expect("slices of equal length");
                });
            summary.run(task);
        })*};
    }
    macro_rules! of_random_systems {
        ($($n:literal $rows:literal)*) => {
            of_coordinates!($(
                format!("Eigenvalues of {IN_A_ROUND} random systems of {} coordinates", $n), random::<$n>(IN_A_ROUND), $n $rows
            )*)
        };
    }
    of_random_systems!(3 6 4 8 5 10 6 12 7 14 8 16);
    of_coordinates!(
        "Eigenvalues of a bicycle of 3 coordinates at 200 speeds", along_speeds(&WhippleLeaning::EXAMPLE), 3 6
        "Eigenvalues of pipes of 3 coordinates at 200 speeds", along_speeds(&ThreePipes::HOSE), 3 6
        "Eigenvalues of a pipe of 4 coordinates at 200 speeds", along_speeds(&CantileveredPipe::BETA_05), 4 8
    );
    let systems = of_many_sizes();
    let task = Task::new("Eigenvalues of two coordinates, of sizes from 1e-16 to 1e16", systems.len());
    summary.run(task.contender("ours, from M, C and K", one_by_one(&systems, System::quartic_eigenvalues)));
}

/// A machine from 0.05 to 10 m/s in steps of that.
fn along_speeds<const N: usize>(machine: &impl Model<N, Scalar = f64>) -> Vec<System<N>> {
    let (coefficients, gravity) = (machine.coefficients(), machine.gravity().unwrap_or(9.81));
    speeds()[1..].iter().map(|&speed| coefficients.at(speed, gravity).expect("a system")).collect()
}

/// Systems of three coordinates and more in each round.
const IN_A_ROUND: u64 = 50;

/// Systems whose quartics have coefficients over 32 orders of magnitude.
fn of_many_sizes() -> Vec<System<2>> {
    let size = |number: usize| 10f64.powi((number * 7 % 17) as i32 - 8);
    let system = |system: System<2>, number: usize| {
        System::new(system.m, system.c * size(number), system.k * size(number + 5) * size(number + 5))
    };
    random(200).into_iter().enumerate().map(|(number, of)| system(of, number)).collect()
}

fn one_by_one<S, E>(systems: &[S], compute: impl Fn(&S) -> E) -> impl FnMut() {
    move || {
        for system in systems {
            black_box(compute(black_box(system)));
        }
    }
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

fn by_faer<const R: usize>(matrices: &[SMatrix<f64, R, R>]) -> Vec<Mat<f64>> {
    matrices.iter().map(|a| Mat::from_fn(R, R, |i, j| a[(i, j)])).collect()
}

/// Without eigenvectors, in memory that is there already: in each round other matrices of one size.
fn faer(rounds: Vec<Vec<Mat<f64>>>) -> impl FnMut() {
    let no = ComputeEigenvectors::No;
    let size = rounds[0][0].nrows();
    let mut memory = MemBuffer::new(evd_scratch::<f64>(size, no, no, Par::Seq, Default::default()));
    let (mut re, mut im) = (Diag::zeros(size), Diag::zeros(size));
    let mut turn = (0..rounds.len()).cycle();
    move || {
        for matrix in &rounds[turn.next().expect("rounds without end")] {
            let (matrix, stack) = (black_box(matrix).as_ref(), MemStack::new(&mut memory));
            let done = evd_real(matrix, re.as_mut(), im.as_mut(), None, None, Par::Seq, stack, Default::default());
            black_box((done.is_ok(), &re, &im));
        }
    }
}
