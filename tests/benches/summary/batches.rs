//! Derivatives, nonlinear equations, eigenvalues and nonlinear motions of many, in lanes and one after the other.

use std::hint::black_box;

use carvallo::batch::{Arrival, Batch, Blocks, Eigenvalues, Ensemble, InLanes, Limit};
use carvallo::motion::Unchecked;
use carvallo::simulation::{Simulation, State};
use carvallo::{Scalar, System};
use carvallo_compare::Task;
use carvallo_models::{Whipple, WhippleDerivatives, WhippleMatrices, WhippleMechanism, WhippleMechanismMotion};
use carvallo_tests::designs;

use crate::Summary;
use crate::systems::random;

/// Designs in the cache: 70 kB with their derivatives.
const IN_CACHE: usize = 64;
/// Designs whose derivatives, of a kilobyte each, are in memory; as many states with their rates have 10 MB.
const IN_MEMORY: usize = 50_000;
/// Systems whose eigenvalues are computed in one run.
const SYSTEMS_IN_A_RUN: usize = 5_000;
/// Motions in one run.
const RIDES: usize = 64;

pub fn add(summary: &mut Summary) {
    let designs: Vec<Whipple> = (0..IN_MEMORY as u64).map(designs::numbered).collect();
    let singles: Vec<Whipple<f32>> = designs.iter().map(designs::narrowed).collect();
    for (count, kind) in [(IN_CACHE, "in the cache"), (IN_MEMORY, "in memory")] {
        let name = format!("Four matrices and their Jacobian, {count} designs, {kind}");
        let task = derivatives(Task::new(name, count), "f64", &designs[..count]);
        summary.run(derivatives(task, "f32", &singles[..count]));
    }
    for (count, kind) in [(IN_CACHE, "in the cache"), (IN_MEMORY, "in memory")] {
        let task = Task::new(format!("Rates of positions and speeds, {count} bicycles {kind}"), count);
        summary.run(equations::<f32>(equations::<f64>(task, "f64", count), "f32", count));
    }
    eigenvalues(summary);
    falls(summary);
}

/// A word about the numbers in front of what is done with them.
fn named(scalar: &str, what: &str) -> String {
    format!("ours, {what}, {scalar}")
}

fn derivatives<'a, T: InLanes>(task: Task<'a>, scalar: &str, designs: &'a [Whipple<T>]) -> Task<'a> {
    let batch = Batch::new();
    let parameters = Blocks::of_designs(designs);
    let mut entries = Blocks::for_entries::<2, Whipple<T>>(designs.len());
    let mut derivatives = Blocks::for_derivatives::<2, Whipple<T>>(designs.len());
    let again = parameters.clone();
    let mut results: Vec<(WhippleMatrices<T>, WhippleDerivatives<T>)> =
        designs.iter().map(Whipple::matrices_and_derivatives).collect();
    task.contender(named(scalar, "one by one"), move || {
        for ((matrices, derivatives), design) in results.iter_mut().zip(black_box(designs)) {
            design.write_matrices_and_derivatives(matrices, derivatives);
        }
        black_box(&results);
    })
    .contender(named(scalar, "batch, blocks"), move || {
        let done = batch.jacobians::<2, Whipple<T>>(black_box(&parameters), &mut entries, &mut derivatives);
        done.expect("blocks that fit");
        black_box(&derivatives);
    })
    .contender(named(scalar, "batch, each block forgotten"), move || {
        let done = batch.each_jacobian::<2, Whipple<T>>(black_box(&again), |portion| {
            black_box(&portion);
        });
        done.expect("blocks that fit");
    })
}

/// Positions, speeds and forces of the state of a number, in one of as many turns as are in the cache.
fn state<T: Scalar>(number: usize) -> [T; 13] {
    let share = (number % IN_CACHE) as f64 / IN_CACHE as f64;
    [0.0, 0.0, 0.3, 0.4 * share, 0.01, -0.2 * share, 0.0, 0.0, -0.6, -0.5 * share, -9.0, 0.0, 0.0].map(T::from_f64)
}

fn equations<'a, T: InLanes>(task: Task<'a>, scalar: &str, count: usize) -> Task<'a> {
    let batch = Batch::new();
    let design = WhippleMechanism::BENCHMARK.cast::<T>();
    let motions = vec![design.motion(); count];
    let states: Vec<[T; 13]> = (0..count).map(state).collect();
    let mut blocks = Blocks::for_states::<2, WhippleMechanism<T>>(count);
    for (place, state) in states.iter().enumerate() {
        state.iter().enumerate().for_each(|(position, number)| blocks.set(place, position, *number));
    }
    let mut results = vec![([T::from_f64(0.0); 8], [T::from_f64(0.0); 3]); count];
    let mut derivatives = Blocks::for_motion_derivatives::<2, WhippleMechanism<T>>(count);
    let one = Blocks::of_designs(&[design]);
    let all = Blocks::of_designs(&vec![design; count]);
    let (again, mut of_each) = (blocks.clone(), derivatives.clone());
    task.contender(named(scalar, "one by one"), move || {
        for ((result, state), motion) in results.iter_mut().zip(black_box(&states)).zip(black_box(&motions)) {
            let [x, y, yaw, lean, pitch, steer, rear, front, a, b, c, f, g] = *state;
            *result = WhippleMechanismMotion::derivatives_unchecked(
                motion,
                &[x, y, yaw, lean, pitch, steer, rear, front],
                &[a, b, c],
                &[f, g],
            );
        }
        black_box(&results);
    })
    .contender(named(scalar, "batch, one design"), move || {
        let done = batch.motion_derivatives::<2, WhippleMechanism<T>>(&one, black_box(&blocks), &mut derivatives);
        done.expect("blocks that fit");
        black_box(&derivatives);
    })
    .contender(named(scalar, "batch, many designs"), move || {
        let done = batch.motion_derivatives::<2, WhippleMechanism<T>>(&all, black_box(&again), &mut of_each);
        done.expect("blocks that fit");
        black_box(&of_each);
    })
}

/// Systems of two coordinates: 12 kB with their eigenvalues, and 88 MB.
fn eigenvalues(summary: &mut Summary) {
    for (count, kind) in [(IN_CACHE, "in the cache"), (summary.designs / 2, "in memory")] {
        let systems = random::<2>(count as u64);
        let in_a_run = count.min(SYSTEMS_IN_A_RUN);
        let name = format!("Eigenvalues of {count} random systems of two coordinates, {kind}");
        let task = Task::new(name, in_a_run)
            .contender(
                "ours, one by one",
                in_turn(&systems, 0, in_a_run, |systems, found| {
                    for (found, system) in found.iter_mut().zip(systems) {
                        *found = system.quartic_eigenvalues();
                    }
                }),
            )
            // So far ahead that it does not find in a cache what the other one has read.
            .contender(
                "ours, batch",
                in_turn(&systems, count / 2, in_a_run, |systems, found| {
                    Batch::new().eigenvalues(systems, found).expect("slices of equal length");
                }),
            );
        summary.run(task);
    }
}

/// So many systems from one on, and the next ones in the next run.
fn in_turn(
    systems: &[System<2>],
    first: usize,
    in_a_run: usize,
    compute: fn(&[System<2>], &mut [Eigenvalues]),
) -> impl FnMut() {
    let mut found = vec![Ok(Default::default()); systems.len()];
    let portions = systems.len() / in_a_run;
    let mut turn = first / in_a_run;
    move || {
        let portion = turn % portions * in_a_run..(turn % portions + 1) * in_a_run;
        turn += 1;
        compute(black_box(&systems[portion.clone()]), black_box(&mut found[portion]));
    }
}

/// The benchmark bicycle at 3 m/s, pushed: it falls within two seconds.
fn falls(summary: &mut Summary) {
    let limits = [Limit::symmetric(3, 45_f64.to_radians())];
    let ensemble = Ensemble { duration: 10.0, tolerance: 1e-8, limits: &limits };
    let design = WhippleMechanism::BENCHMARK;
    let pushes: Vec<f64> = (0..RIDES).map(|ride| 0.1 + 0.01 * ride as f64).collect();
    let mut begin = Blocks::for_states::<2, WhippleMechanism>(RIDES);
    for (ride, push) in pushes.iter().enumerate() {
        begin.set(ride, 8, *push);
        begin.set(ride, 10, -3.0 / design.rR);
    }
    let parameters = Blocks::of_designs(&[design]);
    let mut task =
        Task::new(format!("Falls from 3 m/s to 45 degrees of lean, errors of 1e-8 a step, {RIDES} rides"), RIDES);
    for batch in Batch::levels() {
        let (begin, parameters) = (begin.clone(), parameters.clone());
        let mut outcomes = vec![Ok(Arrival::Reached); RIDES];
        task = task.contender(format!("ours, batch, {batch}"), move || {
            let mut states = black_box(&begin).clone();
            let done = batch.simulate::<2, WhippleMechanism>(&ensemble, &parameters, &mut states, &mut outcomes);
            done.expect("blocks that fit");
            black_box((&states, &outcomes));
        });
    }
    let motion = design.motion();
    let rides = pushes.into_iter().map(|push| State::new(&motion, &[], &[("phi", push), ("thetaR", -3.0 / design.rR)]));
    let rides: Vec<State> = rides.collect::<Result<_, _>>().expect("it stands on both wheels");
    let one_by_one = || {
        for start in black_box(&rides) {
            let simulation = Simulation::new(&motion).tolerance(1e-8);
            let simulation = simulation.until("fall", |moment| moment.positions[3].abs() - limits[0].high);
            black_box(simulation.run(start, &[0.0, 10.0]).expect("a motion"));
        }
    };
    summary.run(task.contender("ours, simulations one by one", one_by_one));
}
