//! Derivatives of nonlinear equations of motion, against differences of dynamics in floating point that share no code, and
//! against numbers that carry their derivatives through the programs of the equations.

use carvallo::motion::{Linearizable, Linearization};
use carvallo::{Model, Motion, MotionError};
use carvallo_models::{DoublePendulum, DoublePendulumMotion, Whipple, WhippleMechanism, WhippleMechanismMotion};
use carvallo_tests::bicycles;
use carvallo_tests::multibody::bicycle::{Bicycle, Extras};
use carvallo_tests::multibody::dynamics::Drive;
use nalgebra::{SMatrix, SVector};

const LEAN: usize = 3;
const PITCH: usize = 4;
const STEER: usize = 5;
const POSITIONS: usize = 8;

/// The derivative of a function, by six points: what is left out is the sixth power of the step, and rounding is divided by
/// it.
pub fn slope<const N: usize>(step: f64, function: impl Fn(f64) -> SVector<f64, N>) -> SVector<f64, N> {
    let pair = |steps: f64| function(steps * step) - function(-steps * step);
    (pair(1.0) * 45.0 - pair(2.0) * 9.0 + pair(3.0)) / (60.0 * step)
}

/// Lean, steer and angle of the rear wheel, their rates, and the two torques.
#[derive(Clone, Copy)]
struct State {
    q: [f64; 3],
    u: [f64; 3],
    f: [f64; 2],
}

/// In a turn, in straight running at no speed, and steered far while it rolls back.
const STATES: [State; 3] = [
    State { q: [0.4, -0.2, 0.0], u: [-0.6, -0.5, -9.0], f: [20.0, -3.0] },
    State { q: [0.0, 0.0, 0.0], u: [0.0, 0.0, 0.0], f: [0.0, 0.0] },
    State { q: [-0.7, 1.1, 0.3], u: [1.5, -2.0, 14.0], f: [-50.0, 8.0] },
];

/// The accelerations of lean, steer and rear wheel by the dynamics of `multibody`.
fn accelerate(design: &Whipple, State { q, u, f }: State) -> SVector<f64, 3> {
    let bicycle = Bicycle::new(design, &Extras::default());
    let independent = [bicycle.root.lean, bicycle.steer, bicycle.rear_wheel];
    let drive = Drive { gravity: design.g, ..Drive::new(independent, None) };
    // Forces are linear in accelerations: three motions tell the masses, and one the rest.
    let taken =
        |rates| SVector::<f64, 3>::from_column_slice(bicycle.mechanism.forces(&drive, [q, u, rates]).as_slice());
    let still = taken([0.0; 3]);
    let column = |speed: usize| taken(std::array::from_fn(|other| f64::from(u8::from(other == speed)))) - still;
    let mass = SMatrix::<f64, 3, 3>::from_columns(&[column(0), column(1), column(2)]);
    mass.try_inverse().expect("masses") * (SVector::from([f[0], f[1], 0.0]) - still)
}

fn close(motion: &WhippleMechanismMotion, state: &State) -> [f64; POSITIONS] {
    let [lean, steer, rear] = state.q;
    motion.close(&[0.0, 0.0, 0.3, lean, 0.0, steer, rear, 0.0]).expect("it stands on both wheels")
}

/// Compares three numbers with what they should be, by the largest of all that belongs together.
fn hold(what: &str, found: SVector<f64, 3>, expected: SVector<f64, 3>, size: f64) {
    let error = (found - expected).amax();
    assert!(error <= 1e-9 * size.max(expected.amax()), "{what}: {found} is not {expected}: {error:e}");
}

#[test]
fn accelerations_of_a_bicycle_change_with_state_and_forces_as_those_of_other_dynamics() {
    let design = bicycles::named("benchmark");
    let motion = WhippleMechanism::BENCHMARK.motion();
    for state in STATES {
        let positions = close(&motion, &state);
        let Linearization { a, b } = motion.linearize(&positions, &state.u, &state.f).expect("regular");
        let column = |column: usize| SVector::<f64, 3>::from_fn(|speed, _| a[POSITIONS + speed][column]);
        let size = (0..11).map(|place| column(place).amax()).fold(1.0, f64::max);
        for (coordinate, place) in [LEAN, STEER, 6].into_iter().enumerate() {
            let moved = |by: f64| {
                let mut moved = state;
                moved.q[coordinate] += by;
                accelerate(&design, moved)
            };
            hold("by a position", column(place), slope(4e-3, moved), size);
            let moved = |by: f64| {
                let mut moved = state;
                moved.u[coordinate] += by;
                accelerate(&design, moved)
            };
            hold("by a speed", column(POSITIONS + coordinate), slope(1e-2, moved), size);
        }
        for place in [0, 1, 2, PITCH, 7] {
            assert_eq!(column(place), SVector::<f64, 3>::zeros(), "position {place}");
        }
        for force in 0..2 {
            let moved = |by: f64| {
                let mut moved = state;
                moved.f[force] += by;
                accelerate(&design, moved)
            };
            hold("by a force", SVector::from_fn(|speed, _| b[POSITIONS + speed][force]), slope(1.0, moved), 1.0);
            assert!(b[..POSITIONS].iter().all(|row| row[force] == 0.0));
        }
    }
}

#[test]
fn accelerations_of_a_bicycle_change_with_its_parameters_as_those_of_other_dynamics() {
    let design = bicycles::named("benchmark");
    let motion = WhippleMechanism::BENCHMARK.motion();
    let names: Vec<&str> = WhippleMechanism::INFO.parameters.iter().map(|parameter| parameter.name).collect();
    assert_eq!(names, Whipple::INFO.parameters.iter().map(|parameter| parameter.name).collect::<Vec<_>>());
    let values = design.to_array();
    for state in STATES {
        let all = motion.by_parameters(&close(&motion, &state), &state.u, &state.f).expect("regular");
        for (parameter, value) in values.iter().enumerate() {
            let moved = |by: f64| {
                let mut moved = values;
                moved[parameter] = value + by;
                accelerate(&Whipple::from_array(moved), state)
            };
            let found = SVector::from_fn(|speed, _| all[POSITIONS + speed][parameter]);
            let size = value.abs().max(0.1);
            let expected = slope(2e-3 * size, moved);
            hold(names[parameter], found, expected, accelerate(&design, state).amax().max(1.0) / size);
        }
    }
}

/// How fast wheels turn, the place changes and pitch follows, in states in which the wheels are on the ground.
#[test]
fn rates_of_all_positions_change_as_in_positions_that_are_closed() {
    let motion = WhippleMechanism::BENCHMARK.motion();
    for state in STATES {
        let positions = close(&motion, &state);
        let Linearization { a, .. } = motion.linearize(&positions, &state.u, &state.f).expect("regular");
        let rates = |positions: [f64; POSITIONS], u: [f64; 3]| {
            let closed = motion.close(&positions).expect("it stands on both wheels");
            SVector::from(motion.rates(&closed, &u).expect("it rolls"))
        };
        let hold = |what: usize, expected: SVector<f64, POSITIONS>| {
            let found = SVector::<f64, POSITIONS>::from_fn(|row, _| a[row][what]);
            let error = (found - expected).amax();
            assert!(error <= 1e-10 * expected.amax().max(1.0), "{what}: {found} is not {expected}: {error:e}");
        };
        for place in (0..POSITIONS).filter(|place| *place != PITCH) {
            let moved = |by: f64| {
                let mut moved = positions;
                moved[place] += by;
                rates(moved, state.u)
            };
            hold(place, slope(4e-3, moved));
        }
        for speed in 0..3 {
            let moved = |by: f64| {
                let mut moved = state.u;
                moved[speed] += by;
                rates(positions, moved)
            };
            hold(POSITIONS + speed, slope(0.1, moved));
        }
        assert!(a.iter().all(|row| row[PITCH] == 0.0), "pitch follows");
    }
}

#[test]
fn what_has_no_derivatives_is_told() {
    let motion = WhippleMechanism::BENCHMARK.motion();
    let state = STATES[0];
    let positions = close(&motion, &state);
    let mut wrong = positions;
    wrong[STEER] = f64::NAN;
    let found = motion.linearize(&wrong, &state.u, &state.f);
    assert!(matches!(found, Err(MotionError::NotFinite { name: "delta", what: "position", .. })), "{found:?}");
    let found = motion.by_parameters(&positions, &state.u, &[f64::INFINITY, 0.0]);
    assert!(matches!(found, Err(MotionError::NotFinite { name: "Tphi", what: "force", .. })), "{found:?}");
    // The rear wheel lies flat.
    let mut flat = positions;
    flat[LEAN] = std::f64::consts::FRAC_PI_2;
    flat[PITCH] = 0.0;
    let found = motion.linearize(&flat, &[0.0, 0.0, 1e300], &state.f);
    assert!(matches!(found, Err(MotionError::Singular { .. })), "{found:?}");
}

#[test]
fn in_single_precision_they_differ_by_rounding() {
    let (motion, single) = (WhippleMechanism::BENCHMARK.motion(), WhippleMechanism::BENCHMARK.to_f32().motion());
    let state = STATES[0];
    let positions = close(&motion, &state);
    let exact = motion.linearize(&positions, &state.u, &state.f).expect("regular");
    let (narrow, speeds, forces) = (positions.map(|x| x as f32), state.u.map(|x| x as f32), state.f.map(|x| x as f32));
    let found = single.linearize(&narrow, &speeds, &forces).expect("regular");
    let size = exact.a.iter().flatten().fold(1.0_f64, |size, entry| size.max(entry.abs()));
    for (found, exact) in found.a.iter().flatten().zip(exact.a.iter().flatten()) {
        assert!((f64::from(*found) - exact).abs() < 1e-4 * size, "{found} is not {exact}");
    }
}

/// On a fixed base nothing follows: about rest A has the identity and -M^-1 K.
#[test]
fn code_that_takes_any_motion_is_given_the_same_entries() {
    let pendulum = DoublePendulum::RODS;
    let motion: DoublePendulumMotion = pendulum.motion();
    let (positions, speeds, forces) = ([0.0; 2], [0.0; 2], [0.0; 2]);
    let Linearization { a, b } = motion.linearize(&positions, &speeds, &forces).expect("regular");
    let (mut to_a, mut to_b) = (vec![f64::NAN; 16], vec![f64::NAN; 8]);
    let written = motion.linearize_into(&positions, &speeds, &forces, &mut to_a, &mut to_b);
    assert_eq!(written, Some(Ok(())));
    assert_eq!((to_a, to_b), (a.concat(), b.concat()));
    let coefficients = pendulum.coefficients();
    let system = coefficients.at(0.0, pendulum.g).expect("finite numbers");
    let stiffness = system.m.try_inverse().expect("masses") * system.k;
    for (row, column) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        assert_eq!(a[row][2 + column], f64::from(u8::from(row == column)));
        assert!((a[2 + row][column] + stiffness[(row, column)]).abs() < 1e-12 * stiffness.amax(), "{a:?}");
    }
}
