//! The nonlinear bicycle in time, against a simulation of other equations.

use carvallo::Model;
use carvallo::simulation::{End, LinearMotion, Ride, Simulation, State};
use carvallo_models::WhippleMechanism;

use super::table;

const X: usize = 0;
const Y: usize = 1;
const YAW: usize = 2;
const LEAN: usize = 3;
const PITCH: usize = 4;
const STEER: usize = 5;
const REAR_WHEEL: usize = 6;

/// At a speed, with a lean, a steer and their rates.
fn ride(speed: f64, positions: [f64; 2], rates: [f64; 2], times: &[f64]) -> Ride {
    let bicycle = WhippleMechanism::BENCHMARK.motion();
    let ([lean, steer], [lean_rate, steer_rate]) = (positions, rates);
    let wheel = -speed / WhippleMechanism::BENCHMARK.rR;
    let rates = [("phi", lean_rate), ("delta", steer_rate), ("thetaR", wheel)];
    let start = State::new(&bicycle, &[("phi", lean), ("delta", steer)], &rates).expect("a state");
    Simulation::new(&bicycle).run(&start, times).expect("a motion")
}

/// The manoeuvre of the IFToMM benchmark to 1e-8 over 10 s.
#[test]
fn the_uncontrolled_bicycle_goes_as_in_the_benchmark_of_iftomm() {
    let samples = table(include_str!("../../../data/uncontrolled_bicycle.tsv"));
    let times: Vec<f64> = samples.iter().map(|sample| sample[0]).collect();
    let ride = ride(4.6, [0.0, 0.0], [0.5, 0.0], &times);
    assert_eq!((&ride.end, ride.rows.len()), (&End::Reached, 21));
    let mut worst = 0.0_f64;
    for (row, sample) in ride.rows.iter().zip(&samples) {
        let (q, rates) = (&row.positions, &row.rates);
        // The samples have the centre of the rear wheel.
        let aside = WhippleMechanism::BENCHMARK.rR * q[LEAN].sin();
        let (x, y) = (q[X] - aside * q[YAW].sin(), q[Y] + aside * q[YAW].cos());
        let found = [q[LEAN], q[STEER], q[PITCH], q[YAW], rates[LEAN], rates[STEER], rates[REAR_WHEEL]];
        let speed = -WhippleMechanism::BENCHMARK.rR * rates[REAR_WHEEL];
        for (found, expected) in found.into_iter().chain([speed, x, y]).zip(&sample[1..]) {
            worst = worst.max((found - expected).abs());
            assert!((found - expected).abs() < 1e-8, "at {} s {found} is not {expected}", row.time);
        }
    }
    // Both simulations err by less than they differ.
    assert!(worst < 1e-9, "{worst}");
    assert!(ride.drift < 1e-10, "the front wheel had to be moved by {}", ride.drift);
}

/// Nothing damps: over 60 s the energy stays what it was, and the front wheel on the ground.
#[test]
fn energy_is_conserved_for_a_minute() {
    let times: Vec<f64> = (0..=600).map(|tenth| f64::from(tenth) / 10.0).collect();
    let ride = ride(4.6, [0.05, -0.1], [0.5, 0.3], &times);
    assert_eq!(ride.end, End::Reached);
    let energy = |row: usize| ride.rows[row].energy.kinetic + ride.rows[row].energy.potential;
    let worst = (0..=600).map(|row| (energy(row) / energy(0) - 1.0).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-9, "energy drifts by {worst} of itself");
}

/// A bicycle that falls steers across, and where the front wheel stands at a right angle to its way the rate of the rear wheel
/// tells no more how it moves, though it moves on as smoothly: quickly, slowly, and near the turning point of the steer.
#[test]
fn energy_is_conserved_where_the_front_wheel_stands_across() {
    for (speed, positions, rates) in [
        (2.0, [0.0, 0.0], [0.5, 0.0]),
        (-4.637720223970579, [-0.1628286180527443, 2.12482593396322], [-0.8579245032667782, -1.4614907231857202]),
        (-7.933523407379065, [0.24158142349048273, -2.2547207765376904], [0.9509657590633007, 2.6512283928584637]),
    ] {
        let bicycle = WhippleMechanism::BENCHMARK.motion();
        let rates = [("phi", rates[0]), ("delta", rates[1]), ("thetaR", -speed / WhippleMechanism::BENCHMARK.rR)];
        let start = State::new(&bicycle, &[("phi", positions[0]), ("delta", positions[1])], &rates).expect("a state");
        let simulation = Simulation::new(&bicycle).until("fall", |moment| 1.4 - moment.positions[LEAN].abs());
        let times: Vec<f64> = (0..=12_000).map(|row| f64::from(row) / 200.0).collect();
        let ride = simulation.run(&start, &times).expect("a motion");
        assert!(matches!(ride.end, End::Event { .. }), "{speed}: {:?}", ride.end);
        let across = |row: &carvallo::simulation::RideRow| (row.positions[STEER].abs() - 1.6).signum();
        assert!(ride.rows.windows(2).any(|pair| across(&pair[0]) != across(&pair[1])), "{speed}");
        let energy = |row: usize| ride.rows[row].energy.kinetic + ride.rows[row].energy.potential;
        let worst = (0..ride.rows.len()).map(|row| (energy(row) / energy(0) - 1.0).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-9, "{speed}: energy drifts by {worst} of itself");
    }
}

/// The smaller the motion, the closer it is to that of the linear equations: they differ by the cube, as a mirrored motion
/// is the mirror image.
#[test]
fn small_motions_are_linear() {
    let bicycle = WhippleMechanism::BENCHMARK;
    let times: Vec<f64> = (0..=20).map(|tenth| f64::from(tenth) / 10.0).collect();
    let system = bicycle.coefficients().at(5.0, bicycle.g).expect("finite numbers");
    let linear = LinearMotion::new(&system).expect("a regular system");
    let still = [carvallo::simulation::Force::constant(0.0), carvallo::simulation::Force::constant(0.0)];
    let difference = |size: f64| -> f64 {
        let exact = linear.run(&[size, 0.0], &[0.0, size], &still, &times).expect("a motion");
        let ride = ride(5.0, [size, 0.0], [0.0, size], &times);
        let rows = exact.iter().zip(&ride.rows);
        let differences = rows.flat_map(|(exact, row)| {
            let [lean, steer] = [row.positions[LEAN] - exact.positions[0], row.positions[STEER] - exact.positions[1]];
            [lean.abs(), steer.abs()]
        });
        differences.fold(0.0, f64::max)
    };
    let [large, small, tiny] = [1e-1, 1e-2, 1e-3].map(difference);
    assert!(small < 1e-5 && tiny < 1e-8, "{large} {small} {tiny}");
    assert!(
        (500.0..2000.0).contains(&(large / small)) && (500.0..2000.0).contains(&(small / tiny)),
        "{large} {small} {tiny}"
    );
}

/// Kicked over, it ends where the lean is reached.
#[test]
fn a_fall_ends_the_motion() {
    let bicycle = WhippleMechanism::BENCHMARK.motion();
    let start = State::new(&bicycle, &[("phi", 0.1)], &[]).expect("a state");
    let simulation = Simulation::new(&bicycle).until("fall", |moment| 1.0 - moment.positions[LEAN].abs());
    let times: Vec<f64> = (0..100).map(|tenth| f64::from(tenth) / 10.0).collect();
    let ride = simulation.run(&start, &times).expect("a motion");
    let last = ride.rows.last().expect("a row");
    assert!(matches!(&ride.end, End::Event { name, time } if name == "fall" && *time == last.time), "{:?}", ride.end);
    assert!((last.positions[LEAN].abs() - 1.0).abs() < 1e-12);
}
