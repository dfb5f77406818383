//! All critical speeds and stable ranges of a design.

use std::hint::black_box;

use carvallo::batch::Batch;
use carvallo::{Coefficients, Model, Sensitivity, Stability, SystemError};
use carvallo_compare::Task;
use carvallo_models::{Whipple, WhippleMechanism};
use carvallo_tests::facts::{RandomSystem, random_systems};
use carvallo_tests::{bicycles, designs};

use crate::Summary;

/// Designs of a sweep that are computed in one round.
const IN_A_ROUND: usize = 100;

pub fn add(summary: &mut Summary) {
    let bicycles: Vec<_> = bicycles::all().iter().map(|(_, bicycle)| (bicycle.coefficients(), bicycle.g)).collect();
    let critical = |(coefficients, gravity): &(Coefficients<f64, 2>, f64)| Stability::new(coefficients, *gravity);
    let task = Task::new("Critical speeds and stable ranges, 14 bicycles", bicycles.len());
    summary.run(task.contender("ours, one by one", each(&bicycles, bicycles.len(), critical)));

    let bicycle = Whipple::BENCHMARK;
    let known = Stability::new(&bicycle.coefficients(), bicycle.g).expect("critical speeds");
    let task = Task::new("Derivatives of all critical speeds by all parameters, the benchmark bicycle", IN_A_ROUND)
        .contender("ours, the critical speeds alone", || {
            for _ in 0..IN_A_ROUND {
                let _ = black_box(Stability::new(&black_box(&bicycle).coefficients(), bicycle.g));
            }
        })
        .contender("ours, the derivatives", || {
            for _ in 0..IN_A_ROUND {
                derivatives(black_box(&bicycle), &known);
            }
        });
    summary.run(task);

    add_random::<3>(summary);
    add_random::<6>(summary);

    let designs: Vec<Whipple> = (0..summary.designs as u64 / 10).map(designs::numbered).collect();
    add_batch(summary, &designs[..IN_A_ROUND]);
    let mechanisms: Vec<_> = designs.iter().map(|design| WhippleMechanism::from_array(design.to_array())).collect();
    let name = format!("Sweep: matrices, critical speeds and stable ranges of {} distinct designs", designs.len());
    let sweep = |design: &WhippleMechanism| Stability::new(&design.coefficients(), design.g);
    summary.run(Task::new(name, IN_A_ROUND).contender("ours, one by one", each(&mechanisms, IN_A_ROUND, sweep)));
}

/// Of designs in the cache whose matrices are known.
fn add_batch(summary: &mut Summary, designs: &[Whipple]) {
    let coefficients: Vec<Coefficients<f64, 2>> = designs.iter().map(Model::coefficients).collect();
    let gravity: Vec<f64> = designs.iter().map(|design| design.g).collect();
    let task = Task::new(format!("Critical speeds and stable ranges, {IN_A_ROUND} designs in the cache"), IN_A_ROUND);
    let systems: Vec<_> = coefficients.iter().copied().zip(gravity.iter().copied()).collect();
    let mut alone = vec![Err(SystemError::AtRest); IN_A_ROUND];
    let mut found = alone.clone();
    let task = task.contender("ours, one by one", move || {
        for (found, (coefficients, gravity)) in alone.iter_mut().zip(black_box(&systems)) {
            *found = Stability::new(coefficients, *gravity);
        }
    });
    let batch = Batch::new();
    summary.run(task.contender("ours, batch", move || {
        let done = batch.stability(black_box(&coefficients), &gravity, &mut found);
        done.expect("slices of equal length");
    }));
}

fn derivatives(bicycle: &Whipple, known: &Stability) {
    let sensitivity = Sensitivity::of(bicycle).expect("derivatives of a bicycle");
    for critical in &known.critical_speeds {
        black_box(sensitivity.critical_speed(critical)).expect("derivatives of a critical speed");
    }
}

/// Random systems with follower loads, gyroscopic ones and others.
fn add_random<const N: usize>(summary: &mut Summary) {
    let systems = random_systems().into_iter().filter(|system| system.coordinates == N);
    let systems: Vec<Coefficients<f64, N>> = systems.map(|system| system.coefficients()).collect();
    let critical = |coefficients: &Coefficients<f64, N>| Stability::new(coefficients, RandomSystem::GRAVITY);
    let task =
        Task::new(format!("Critical speeds of {} random systems of {N} coordinates", systems.len()), systems.len());
    summary.run(task.contender("ours, one by one", each(&systems, systems.len(), critical)));
}

/// So many in each run, and the next ones in the next.
fn each<D, S>(designs: &[D], in_a_round: usize, compute: impl Fn(&D) -> S) -> impl FnMut() {
    let mut rounds = designs.chunks_exact(in_a_round).cycle();
    move || {
        for design in rounds.next().expect("rounds without end") {
            black_box(compute(black_box(design)));
        }
    }
}
