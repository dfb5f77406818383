//! Nonlinear motion and steady turns under laws of feedback, against other dynamics and the linear equations.

use carvallo::simulation::{End, Force, LinearMotion, Machine, Ride, Simulation, State};
use carvallo::turns::Turns;
use carvallo::{CriticalKind, Model, Stability};
use carvallo_design::feedback::{self, Closed, Gain, Law, Unclosed};
use carvallo_models::{DoublePendulum, RollingDisc, WhippleMechanism};
use carvallo_tests::bicycles;
use carvallo_tests::multibody::bicycle::{Bicycle, Extras};
use carvallo_tests::multibody::dynamics::Drive;

const LEAN: usize = 3;
const STEER: usize = 5;
const REAR_WHEEL: usize = 6;

/// All powers of the speed that a law may have, on both forces.
const LAWS: [&str; 2] = [
    "Tphi = -20*phi + 3*v*delta - 2/v*delta_rate",
    "Tdelta = 10*(4.7 - v)*phi_rate - 0.5*delta_rate + 0.2*v^2*phi - 2*delta",
];

fn laws(texts: &[&str]) -> Vec<Law> {
    let texts: Vec<String> = texts.iter().map(|&text| text.to_owned()).collect();
    feedback::laws(&texts, WhippleMechanism::<f64>::INFO).expect("laws")
}

fn closed<'a>(machine: &'a dyn Machine, texts: &[&str]) -> Closed<'a> {
    Closed::new(machine, WhippleMechanism::<f64>::INFO, &laws(texts)).expect("a closed loop")
}

fn ride(machine: &dyn Machine, speed: f64, [lean, lean_rate]: [f64; 2], times: &[f64]) -> Ride {
    let rates = [("phi", lean_rate), ("thetaR", -speed / WhippleMechanism::BENCHMARK.rR)];
    let start = State::new(machine, &[("phi", lean), ("delta", -0.1 * lean)], &rates).expect("a state");
    let push = Force::through(&[(0.0, 1.0), (1.0, -1.0)]).expect("a force");
    let simulation = Simulation::new(machine).force("Tdelta", push).expect("a torque");
    simulation.run(&start, times).expect("a motion")
}

/// Kane's equations of the same mechanism, in numbers, take what is applied and what the laws say, here by hand, at large leans
/// and steers and at speeds that change.
#[test]
fn other_dynamics_take_the_forces_of_the_laws() {
    let bicycle = WhippleMechanism::BENCHMARK.motion();
    let closed = closed(&bicycle, &LAWS);
    let times: Vec<f64> = (0..=60).map(|row| f64::from(row) / 20.0).collect();
    let peer = Bicycle::new(&bicycles::named("benchmark"), &Extras::default());
    let drive = Drive { gravity: 9.81, ..Drive::new([peer.root.lean, peer.steer, peer.rear_wheel], None) };
    let (mut largest, mut slowest, mut fastest) = (0.0_f64, f64::INFINITY, 0.0_f64);
    for start in [[0.0, 1.5], [0.1, -1.0]] {
        let ride = ride(&closed, 4.0, start, &times);
        assert_eq!(ride.end, End::Reached);
        for row in &ride.rows {
            let of = |values: &[f64]| [values[LEAN], values[STEER], values[REAR_WHEEL]];
            let [q, u, accelerations] = [&row.positions, &row.rates, &row.accelerations].map(|values| of(values));
            let taken = peer.mechanism.forces(&drive, [[q[0], q[1], 0.0], u, accelerations]);
            let ([phi, delta, _], [phi_rate, delta_rate, wheel]) = (q, u);
            let v = -0.3 * wheel;
            let lean_torque = -20.0 * phi + 3.0 * v * delta - 2.0 / v * delta_rate;
            let steer_torque = 10.0 * (4.7 - v) * phi_rate - 0.5 * delta_rate + 0.2 * v * v * phi - 2.0 * delta;
            let applied = 1.0 - 2.0 * row.time.min(1.0);
            for (taken, expected) in taken.iter().zip([lean_torque, steer_torque + applied, 0.0]) {
                assert!((taken - expected).abs() < 1e-10 * 94.0 * 9.81, "{}: {taken} {expected}", row.time);
            }
            largest = largest.max(delta.abs());
            (slowest, fastest) = (slowest.min(v), fastest.max(v));
        }
    }
    // Far from what is linear.
    assert!(largest > 0.4 && fastest - slowest > 0.2, "{largest} {slowest} {fastest}");
}

/// By the linear equations of the closed loop a motion is as many times as large as its start; what the nonlinear ones add to lean
/// and steer, which are odd, is of third order.
#[test]
fn small_motions_are_those_of_the_linear_closed_loop() {
    let bicycle = WhippleMechanism::BENCHMARK;
    let (machine, gains) = (bicycle.motion(), laws(&LAWS).into_iter().flat_map(|law| law.gains).collect::<Vec<Gain>>());
    let closed = closed(&machine, &LAWS);
    let system = feedback::close(bicycle.coefficients(), &gains).at(4.0, bicycle.g).expect("a system");
    let linear = LinearMotion::new(&system).expect("a motion");
    let times: Vec<f64> = (0..=20).map(|row| f64::from(row) / 10.0).collect();
    let differences = [1e-2, 1e-3].map(|size| {
        let rates = [("phi", size), ("thetaR", -4.0 / bicycle.rR)];
        let start = State::new(&closed, &[("delta", size)], &rates).expect("a state");
        let ride = Simulation::new(&closed).run(&start, &times).expect("a motion");
        let rows = linear.run(&[0.0, size], &[size, 0.0], &[Force::constant(0.0), Force::constant(0.0)], &times);
        let rows = rows.expect("a motion");
        let difference = |(nonlinear, linear): (&carvallo::simulation::RideRow, &carvallo::simulation::Snapshot)| {
            (nonlinear.positions[LEAN] - linear.positions[0])
                .abs()
                .max((nonlinear.positions[STEER] - linear.positions[1]).abs())
        };
        ride.rows.iter().zip(&rows).map(difference).fold(0.0, f64::max)
    });
    let ratio = differences[0] / differences[1];
    assert!(differences[0] < 1e-5 && (900.0..1100.0).contains(&ratio), "{differences:?}");
}

/// Circles of the closed loop, in each of which the forces of other dynamics are what the law says.
#[test]
fn steady_turns_are_those_of_the_closed_loop() {
    let (bicycle, machine) = (WhippleMechanism::BENCHMARK, WhippleMechanism::BENCHMARK.motion());
    let law = ["Tdelta = -2*delta - 0.2*v*delta"];
    let closed = closed(&machine, &law);
    let gains: Vec<Gain> = laws(&law).into_iter().flat_map(|law| law.gains).collect();
    let coefficients = feedback::close(bicycle.coefficients(), &gains);
    let stability = Stability::new(&coefficients, bicycle.g).expect("finite numbers");
    let capsize = stability.critical_speeds.iter().find(|critical| critical.kind == CriticalKind::Capsize);
    let turns = Turns::from_capsize(&closed, capsize.expect("a capsize speed").speed).expect("turns").turns;
    let peer = Bicycle::new(&bicycles::named("benchmark"), &Extras::default());
    let drive = Drive { gravity: 9.81, ..Drive::new([peer.root.lean, peer.steer, peer.rear_wheel], None) };
    let steered = turns.iter().filter(|turn| turn.positions[STEER].abs() > 0.1 && turn.speed > 1.0);
    let mut count = 0;
    for turn in steered.step_by(5) {
        let [phi, delta] = [turn.positions[LEAN], turn.positions[STEER]];
        let u = [0.0, 0.0, turn.rates[REAR_WHEEL]];
        let taken = peer.mechanism.forces(&drive, [[phi, delta, 0.0], u, [0.0; 3]]);
        let expected = [0.0, -2.0 * delta + 0.2 * 0.3 * turn.rates[REAR_WHEEL] * delta, 0.0];
        for (taken, expected) in taken.iter().zip(expected) {
            assert!((taken - expected).abs() < 1e-8 * 94.0 * 9.81, "{delta}: {taken} {expected}");
        }
        count += 1;
    }
    assert!(count > 2, "{count}");
}

/// What cannot be fed back is told, and not left out.
#[test]
fn laws_that_have_no_place_are_refused() {
    let of = |machine: &dyn Machine, info, text: &str| {
        let laws = feedback::laws(&[text.to_owned()], info).expect("a law");
        Closed::new(machine, info, &laws).err()
    };
    let pendulum = DoublePendulum::RODS.motion();
    assert_eq!(of(&pendulum, DoublePendulum::<f64>::INFO, "Ttheta1 = -theta1"), None);
    let disc = RollingDisc::UNIFORM.motion();
    assert_eq!(of(&disc, RollingDisc::<f64>::INFO, "Tphi = -phi"), Some(Unclosed::Force(0)));
}
