//! Integration of nonlinear equations, against closed forms.

use carvallo::motion::MotionError;
use carvallo::simulation::{Crossing, End, Force, Happening, Simulation, SimulationError, State};

use super::pendulums::{Bob, Swing};

/// Every tenth of a second.
fn tenths(count: u32) -> Vec<f64> {
    (0..=count).map(|tenth| f64::from(tenth) / 10.0).collect()
}

/// A quarter of the period of a pendulum of unit length, by the mean of Gauss: pi / (2 agm(1, cos(angle/2)) sqrt(g)).
fn quarter(angle: f64, gravity: f64) -> f64 {
    let (mut a, mut b) = (1.0_f64, (angle / 2.0).cos());
    for _ in 0..10 {
        (a, b) = ((a + b) / 2.0, (a * b).sqrt());
    }
    std::f64::consts::FRAC_PI_2 / (a * gravity.sqrt())
}

#[test]
fn a_pendulum_passes_its_lowest_point_when_the_elliptic_integral_says() {
    let (swing, angle) = (Swing { gravity: 9.81 }, 2.5_f64);
    let start = State::new(&swing, &[("angle", angle)], &[]).expect("a state");
    let simulation = Simulation::new(&swing).noting("lowest", |moment| moment.positions[0]);
    let ride = simulation.run(&start, &tenths(600)).expect("a motion");
    assert_eq!((ride.rows.len(), &ride.end, ride.drift), (601, &End::Reached, 0.0));
    let quarter = quarter(angle, 9.81);
    assert_eq!(ride.events.len(), (60.0 / quarter / 2.0 + 0.5) as usize);
    for (Happening { name, row }, odd) in ride.events.iter().zip((1..).step_by(2)) {
        let (time, expected) = (row.time, f64::from(odd) * quarter);
        assert!(name == "lowest" && (time - expected).abs() < 1e-8, "{time} is not {expected}");
        assert!(row.positions[0].abs() < 1e-13, "{row:?}");
    }
    let energy = |row: usize| ride.rows[row].energy.kinetic + ride.rows[row].energy.potential;
    let worst = (0..601).map(|row| (energy(row) - energy(0)).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-9, "energy drifts by {worst} J");
}

/// The same motion in coordinates of which one follows: where the lowest points of wheels would be on the ground, here the
/// rod has its length.
#[test]
fn positions_that_depend_on_others_follow_to_rounding() {
    let (swing, bob, angle) = (Swing { gravity: 9.81 }, Bob { gravity: 9.81 }, 1.0_f64);
    let first = State::new(&swing, &[("angle", angle)], &[]).expect("a state");
    // Found from near.
    let second = State::new(&bob, &[("x", angle.sin()), ("z", 1.0)], &[]).expect("a state");
    assert!((second.positions[1] - angle.cos()).abs() < 1e-15);
    let first = Simulation::new(&swing).run(&first, &tenths(100)).expect("a motion");
    let second = Simulation::new(&bob).run(&second, &tenths(100)).expect("a motion");
    assert!(second.drift > 0.0 && second.drift < 1e-11, "{}", second.drift);
    for (first, second) in first.rows.iter().zip(&second.rows) {
        let (sin, cos) = first.positions[0].sin_cos();
        let [x, z] = second.positions[..] else { panic!("two positions") };
        assert!((x - sin).abs() < 1e-9 && (z - cos).abs() < 1e-9, "{x} {z}");
        assert!((x * x + z * z - 1.0).abs() < 4e-16, "the rod is {} long", x.hypot(z));
        assert!((x * second.rates[0] + z * second.rates[1]).abs() < 1e-15);
        // The tension is g cos + angle'².
        let [force] = second.contact_forces[..] else { panic!("one force") };
        let tension = 9.81 * cos + first.rates[0].powi(2);
        assert!((force[0] + tension * sin).abs() < 1e-7 && (force[2] + tension * cos).abs() < 1e-7, "{force:?}");
    }
}

/// The work of a torque that jumps twice is in the energy: 2 N m from 1 s to 2 s.
#[test]
fn forces_do_the_work_that_they_should() {
    let swing = Swing { gravity: 9.81 };
    let start = State::new(&swing, &[("angle", 0.3)], &[("angle", -1.0)]).expect("a state");
    let push = Force::through(&[(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (2.0, 2.0), (2.0, 0.0)]).expect("a force");
    let simulation = Simulation::new(&swing).force("T", push).expect("a force of that name");
    let rows = simulation.run(&start, &[0.0, 1.0, 1.5, 2.0, 5.0]).expect("a motion").rows;
    let energy = |row: usize| rows[row].energy.kinetic + rows[row].energy.potential;
    let work = |row: usize| 2.0 * (rows[row].positions[0] - rows[1].positions[0]);
    for (row, work) in [(1, 0.0), (2, work(2)), (3, work(3)), (4, work(3))] {
        assert!((energy(row) - energy(0) - work).abs() < 1e-10, "row {row}");
    }
    // Where the torque jumps, rows have what it jumps to.
    assert_eq!(rows.iter().map(|row| row.forces[0]).collect::<Vec<_>>(), [0.0, 2.0, 2.0, 0.0, 0.0]);
}

/// A torque that makes up for gravity and holds with a spring and a damper: x'' = -5 x' - 4 x, so x = (4 exp(-t) - exp(-4t))/3.
#[test]
fn a_controller_sees_the_motion_and_acts_on_it() {
    let swing = Swing { gravity: 9.81 };
    let start = State::new(&swing, &[("angle", 1.0)], &[]).expect("a state");
    let simulation = Simulation::new(&swing).controlled_by(|moment, torque| {
        let ([angle], [rate]) = (moment.positions, moment.rates) else { return };
        torque[0] += 9.81 * angle.sin() - 5.0 * rate - 4.0 * angle;
    });
    for row in simulation.run(&start, &tenths(50)).expect("a motion").rows {
        let (slow, fast) = ((-row.time).exp(), (-4.0 * row.time).exp());
        assert!((row.positions[0] - (4.0 * slow - fast) / 3.0).abs() < 1e-10, "{row:?}");
        assert!((row.accelerations[0] - (4.0 * slow - 16.0 * fast) / 3.0).abs() < 1e-9, "{row:?}");
    }
}

/// Free fall along an arc from rest: it is simulated until it has turned by one radian, where `rate² = 2 g (cos 0.5 - cos 1.5)`.
#[test]
fn a_simulation_ends_where_it_should() {
    let swing = Swing { gravity: 9.81 };
    let start = State::new(&swing, &[("angle", 1.5)], &[]).expect("a state");
    let simulation = Simulation::new(&swing)
        .noting("at 1", |moment| moment.positions[0] - 1.0)
        .until("at 0.5", |moment| moment.positions[0] - 0.5);
    let ride = simulation.run(&start, &tenths(100)).expect("a motion");
    let last = ride.rows.last().expect("a row");
    assert_eq!(ride.end, End::Event { name: "at 0.5".to_owned(), time: last.time });
    assert!((last.positions[0] - 0.5).abs() < 1e-14);
    let rate = -(2.0 * 9.81 * (0.5_f64.cos() - 1.5_f64.cos())).sqrt();
    assert!((last.rates[0] - rate).abs() < 1e-10, "{} is not {rate}", last.rates[0]);
    assert_eq!(ride.events.iter().map(|event| event.name.as_str()).collect::<Vec<_>>(), ["at 1", "at 0.5"]);
    assert!(ride.rows[ride.rows.len() - 2].time < last.time);
}

/// It passes its lowest point backward after one quarter of its period, forward after three, and so on.
#[test]
fn a_simulation_ends_when_something_has_happened_so_often() {
    let (swing, angle) = (Swing { gravity: 9.81 }, 1.0_f64);
    let (start, quarter) = (State::new(&swing, &[("angle", angle)], &[]).expect("a state"), quarter(angle, 9.81));
    for (crossing, ends, quarters) in [
        (Crossing::Rising, 2, vec![3.0, 7.0]),
        (Crossing::Falling, 3, vec![1.0, 5.0, 9.0]),
        (Crossing::Any, 4, vec![1.0, 3.0, 5.0, 7.0]),
    ] {
        // A force that jumps does not make it count anew.
        let jump = Force::through(&[(0.0, 0.0), (1.0, 0.0), (1.0, 0.0), (2.0, 0.0)]).expect("a force");
        let simulation = Simulation::new(&swing).force("T", jump).expect("a force");
        let simulation = simulation.watching("lowest", crossing, Some(ends), |moment| moment.positions[0]);
        let ride = simulation.run(&start, &tenths(100)).expect("a motion");
        let times: Vec<f64> = ride.events.iter().map(|event| event.row.time).collect();
        let is_near = |(time, expected): (&f64, &f64)| (time - expected * quarter).abs() < 1e-8;
        assert!(times.len() == ends && times.iter().zip(&quarters).all(is_near), "{crossing:?}: {times:?}");
        assert_eq!(ride.end, End::Event { name: "lowest".to_owned(), time: times[ends - 1] });
        assert_eq!(ride.rows.last().map(|row| row.time), times.last().copied());
    }
}

/// A controller that has no value beyond an angle: the rows until then are there.
#[test]
fn a_motion_goes_as_far_as_its_equations() {
    let swing = Swing { gravity: 9.81 };
    let start = State::new(&swing, &[], &[("angle", 6.0)]).expect("a state");
    let free = Simulation::new(&swing).until("there", |moment| moment.positions[0] - 1.0);
    let End::Event { time: expected, .. } = free.run(&start, &tenths(20)).expect("a motion").end else {
        panic!("it turns by more than a radian")
    };
    let cliff = Simulation::new(&swing).controlled_by(|moment, torque| {
        torque[0] += 0.0 * (1.0 - moment.positions[0]).sqrt();
    });
    let ride = cliff.run(&start, &tenths(20)).expect("a motion");
    let last = ride.rows.last().expect("a row");
    let End::Singular { time, error } = ride.end else { panic!("{:?}", ride.end) };
    assert!(matches!(error, MotionError::NotFinite { name: "T", what: "force", .. }), "{error}");
    assert!((time - expected).abs() < 1e-10, "{time} is not {expected}");
    assert!(last.time == time && (last.positions[0] - 1.0).abs() < 1e-9, "{last:?}");
    assert_eq!(ride.rows.len(), (expected * 10.0) as usize + 2);
}

#[test]
fn names_that_there_are_not_are_refused() {
    let bob = Bob { gravity: 9.81 };
    let unknown = |what, name: &str| SimulationError::Unknown { what, name: name.to_owned() };
    assert_eq!(State::new(&bob, &[("y", 1.0)], &[]), Err(unknown("position", "y")));
    assert_eq!(State::new(&bob, &[("z", 1.0)], &[("z", 1.0)]), Err(unknown("free rate", "z")));
    assert_eq!(Simulation::new(&bob).force("T", Force::constant(1.0)).err(), Some(unknown("force", "T")));
    let apart = State::new(&bob, &[("x", 2.0), ("z", 1.0)], &[]);
    assert!(matches!(apart, Err(SimulationError::Motion { error: MotionError::NotClosed { .. }, .. })), "{apart:?}");
    let message = apart.unwrap_err().to_string();
    assert!(message.starts_with("at 0 s: no position was found"), "{message}");
}

/// A controller that shakes a million times in a second: it is told that the motion hardly goes on, with what there is.
#[test]
fn a_motion_that_hardly_goes_on_ends() {
    let swing = Swing { gravity: 9.81 };
    let start = State::new(&swing, &[("angle", 0.1)], &[]).expect("a state");
    let shaken = Simulation::new(&swing).controlled_by(|moment, torque| torque[0] += 1e9 * (1e7 * moment.time).sin());
    let ride = shaken.run(&start, &[0.0, 1e-3, 10.0]).expect("a motion");
    let End::Stalled { time, steps } = ride.end else { panic!("{:?}", ride.end) };
    // More than 100,000, and 10,000 for each second.
    assert!(time < 10.0 && steps == (1e5 + 1e4 * time) as usize + 1, "{time} after {steps}");
    assert!(ride.rows.last().is_some_and(|row| row.time == time));
}
