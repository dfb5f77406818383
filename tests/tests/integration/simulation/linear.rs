//! The linear equations solved exactly, against closed forms and a solution of 40 digits.

use carvallo::simulation::{Force, LinearMotion, SimulationError, Snapshot};
use carvallo::{Model, States, System};
use carvallo_models::WhippleMechanism;
use carvallo_tests::bicycles;
use nalgebra::{Matrix1, Matrix2, SMatrix};
use proptest::prelude::*;

fn one(m: f64, c: f64, k: f64) -> LinearMotion {
    LinearMotion::new(&System::new(Matrix1::new(m), Matrix1::new(c), Matrix1::new(k))).expect("a regular system")
}

#[track_caller]
fn assert_near(found: f64, expected: f64, bound: f64) {
    assert!((found - expected).abs() <= bound * expected.abs().max(1.0), "{found} is not {expected}");
}

fn push() -> Force {
    Force::through(&[(0.0, 0.0), (1.0, 0.0), (1.0, 6.0), (3.0, 6.0), (3.0, 0.0)]).expect("a force")
}

/// What eigenvectors do not span: two eigenvalues of -3 with one eigenvector, q = (a + (b + 3a) t) exp(-3t).
#[test]
fn a_critically_damped_mass_is_exact() {
    let times = [0.0, 0.1, 0.35, 2.0, 9.0];
    for row in one(1.0, 6.0, 9.0).run(&[2.0], &[-1.0], &[Force::constant(0.0)], &times).expect("a motion") {
        let (t, decay) = (row.time, (-3.0 * row.time).exp());
        assert_near(row.positions[0], (2.0 + 5.0 * t) * decay, 1e-14);
        assert_near(row.rates[0], (-1.0 - 15.0 * t) * decay, 1e-14);
        assert_near(row.accelerations[0], (-12.0 + 45.0 * t) * decay, 1e-13);
    }
}

/// Two eigenvalues of zero: a mass that nothing holds, pushed from 1 s to 3 s by 6 N.
#[test]
fn a_free_mass_goes_as_newton_says() {
    let rows = one(2.0, 0.0, 0.0).run(&[1.0], &[0.5], &[push()], &[0.0, 1.0, 2.0, 3.0, 10.0]).expect("a motion");
    for (row, (position, rate, acceleration)) in
        rows.iter().zip([(1.0, 0.5, 0.0), (1.5, 0.5, 3.0), (3.5, 3.5, 3.0), (8.5, 6.5, 0.0), (54.0, 6.5, 0.0)])
    {
        let found = [row.positions[0], row.rates[0], row.accelerations[0]];
        found.into_iter().zip([position, rate, acceleration]).for_each(|(x, expected)| assert_near(x, expected, 1e-14));
    }
}

/// A ramp of 1 N/s on an undamped mass: q = (t - sin(w t)/w)/k.
#[test]
fn a_ramp_is_exact_in_one_step() {
    let (m, k) = (0.25_f64, 4.0_f64);
    let ramp = Force::through(&[(0.0, 0.0), (100.0, 100.0)]).expect("a force");
    let w = (k / m).sqrt();
    for row in one(m, 0.0, k).run(&[0.0], &[0.0], &[ramp], &[0.0, 0.2, 5.0, 50.0]).expect("a motion") {
        assert_near(row.positions[0], (row.time - (w * row.time).sin() / w) / k, 2e-13);
        assert_near(row.rates[0], (1.0 - (w * row.time).cos()) / k, 2e-13);
    }
}

/// A stiff one beside a slow one, in units that differ by 1e6: exp(-1e5 t) is gone after a step, and the other is untouched.
#[test]
fn what_is_fast_does_not_blur_what_is_slow() {
    let system = System::new(Matrix2::new(1e6, 0.0, 0.0, 1e-6), Matrix2::zeros(), Matrix2::new(1e6, 0.0, 0.0, 0.0));
    let system = System { c: Matrix2::new(0.0, 0.0, 0.0, 0.1), ..system };
    let motion = LinearMotion::new(&system).expect("a regular system");
    let still = [Force::constant(0.0), Force::constant(0.0)];
    let rows = motion.run(&[1.0, 0.0], &[0.0, 1.0], &still, &[0.0, 3.0]).expect("a motion");
    assert_near(rows[1].positions[0], 3_f64.cos(), 1e-14);
    assert!((rows[1].positions[1] - 1e-5).abs() < 1e-19, "{}", rows[1].positions[1]);
    assert!(rows[1].rates[1].abs() < 1e-20, "{}", rows[1].rates[1]);
}

/// A filter `2 q' + 3 q = f` and a rate that dies away, `4 r' + 2 r = 0`.
#[test]
fn coordinates_of_one_state_move_as_their_equations_say() {
    let system = System {
        states: [States::Position, States::Rate],
        ..System::new(
            Matrix2::new(0.0, 0.0, 0.0, 4.0),
            Matrix2::new(2.0, 0.0, 0.0, 2.0),
            Matrix2::new(3.0, 0.0, 0.0, 0.0),
        )
    };
    let motion = LinearMotion::new(&system).expect("a regular system");
    let forces = [Force::constant(6.0), Force::constant(0.0)];
    // The rate of the first is not a state: what is given for it is not looked at.
    for row in motion.run(&[1.0, 0.0], &[100.0, 8.0], &forces, &[0.0, 0.5, 4.0]).expect("a motion") {
        let (first, second) = ((-1.5 * row.time).exp(), (-0.5 * row.time).exp());
        assert_near(row.positions[0], 2.0 - first, 1e-14);
        assert_near(row.rates[0], 1.5 * first, 1e-14);
        assert_near(row.accelerations[0], -2.25 * first, 1e-14);
        assert_near(row.positions[1], 16.0 * (1.0 - second), 1e-14);
        assert_near(row.rates[1], 8.0 * second, 1e-14);
        assert_near(row.accelerations[1], -4.0 * second, 1e-14);
    }
}

/// The benchmark bicycle at 4.6 m/s from the printed matrices, under a lean torque of 3 N m - 0.5 N m/s t and a steer torque
/// that rises to 2 N m in 1 s and ends at 2 s, with its yaw and the place of its rear contact. Integrated with mpmath, by
/// its Taylor method (`odefun`) to a tolerance of 1e-32, piece by piece.
const BICYCLE: [(f64, [f64; 6]); 5] = [
    (
        0.5,
        [
            0.2919471004474218,
            0.2804238533068437,
            -0.144966184604195,
            0.3599017643567721,
            0.268920080212341,
            0.15815035730611737,
        ],
    ),
    (
        1.0,
        [
            -0.13233668315942057,
            0.056533023937806695,
            -1.2922573902701875,
            -1.0437365805081769,
            0.7460740389366363,
            1.432543148292381,
        ],
    ),
    (
        1.5,
        [
            -0.6473775395056496,
            -0.40368559064562787,
            -0.5229034480577007,
            -0.45453806010928416,
            0.28416792394926804,
            2.809440248842137,
        ],
    ),
    (
        2.0,
        [
            -0.6982019672221735,
            -0.35664588296823035,
            0.05679474014546152,
            0.3724378771521042,
            -0.6051741519444829,
            2.409009383875911,
        ],
    ),
    (
        5.0,
        [
            -0.06250096235304411,
            -0.005085232504437577,
            -0.008747195825712555,
            -0.019153525501087478,
            -2.718574424970091,
            -25.89082898303636,
        ],
    ),
];

fn bicycle() -> LinearMotion {
    let (m, c1) = (
        Matrix2::new(80.81722, 2.31941332208709, 2.31941332208709, 0.29784188199686),
        Matrix2::new(0.0, 33.86641391492494, -0.85035641456978, 1.68540397397560),
    );
    let (k0, k2) = (
        Matrix2::new(-80.95, -2.59951685249872, -2.59951685249872, -0.80329488458618),
        Matrix2::new(0.0, 76.59734589573222, 0.0, 2.65431523794604),
    );
    let kinematics = WhippleMechanism::BENCHMARK.kinematics();
    LinearMotion::new(&System::new(m, c1 * 4.6, k0 * 9.81 + k2 * (4.6 * 4.6))).expect("a regular system").followed_by(
        4.6,
        &kinematics.yaw,
        &[kinematics.lateral, kinematics.wheel_R],
    )
}

fn torques() -> [Force; 2] {
    let lean = Force::through(&[(0.0, 3.0), (10.0, -2.0)]).expect("a force");
    let steer = Force::through(&[(0.0, 0.0), (1.0, 2.0), (2.0, 2.0), (2.0, 0.0)]).expect("a force");
    [lean, steer]
}

fn ride(times: &[f64]) -> Vec<Snapshot> {
    bicycle().run(&[0.1, -0.05, 0.0, 0.0, 0.0], &[0.5, 0.2], &torques(), times).expect("a motion")
}

#[test]
fn a_bicycle_moves_as_at_forty_digits() {
    let rows = ride(&[0.0, 0.5, 1.0, 1.5, 2.0, 5.0]);
    for (row, (time, expected)) in rows[1..].iter().zip(BICYCLE) {
        assert_eq!(row.time, time);
        let found = [&row.positions[..2], &row.rates[..2], &row.positions[2..4]].concat();
        found.iter().zip(expected).for_each(|(found, expected)| assert_near(*found, expected, 2e-13));
        // v t / rR backwards.
        assert_near(row.positions[4], -4.6 * time / 0.3, 1e-13);
    }
}

/// However many rows are asked for, and however unevenly.
#[test]
fn rows_between_change_nothing() {
    let dense: Vec<f64> = (0..=5000).map(|row| f64::from(row) / 1e3).collect();
    let uneven: Vec<f64> = (0..=5000).map(|row| 5.0 * (f64::from(row) / 5000.0).powi(3)).collect();
    for rows in [ride(&dense), ride(&uneven)] {
        let last = rows.last().expect("a row");
        let found = [&last.positions[..2], &last.rates[..2], &last.positions[2..4]].concat();
        found.iter().zip(BICYCLE[4].1).for_each(|(found, expected)| assert_near(*found, expected, 2e-12));
    }
}

/// A motion that begins at another time is the same one.
#[test]
fn a_motion_goes_on_from_any_of_its_rows() {
    let rows = ride(&[0.0, 1.2, 3.0]);
    let on = bicycle().run(&rows[1].positions, &rows[1].rates[..2], &torques(), &[1.2, 3.0]).expect("a motion");
    for (found, expected) in on[1].positions.iter().zip(&rows[2].positions) {
        assert_near(*found, *expected, 1e-13);
    }
}

#[test]
fn what_cannot_be_is_refused() {
    let (motion, still) = (one(1.0, 0.0, -1.0), [Force::constant(0.0)]);
    let refused = |positions: &[f64], times: &[f64]| motion.run(positions, &[0.0], &still, times).unwrap_err();
    assert_eq!(
        refused(&[1.0, 2.0], &[0.0]),
        SimulationError::Length { quantity: "initial positions", expected: 1, found: 2 }
    );
    assert_eq!(refused(&[1.0], &[0.0, 2.0, 1.0]), SimulationError::Unsorted { time: 2.0, next: 1.0 });
    assert!(matches!(refused(&[f64::NAN], &[0.0]), SimulationError::NotFinite { quantity: "initial positions", .. }));
    // e^1000 is beyond f64, in one step and in many.
    assert_eq!(refused(&[1.0], &[0.0, 1000.0]), SimulationError::OutOfRange { time: 1000.0 });
    let many: Vec<f64> = (0..=1000).map(f64::from).collect();
    assert!(matches!(refused(&[1.0], &many), SimulationError::OutOfRange { time } if (709.0..712.0).contains(&time)));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// At every row the equations of motion hold: M q'' + C q' + K q = f.
    #[test]
    fn rows_satisfy_the_equations_of_motion(
        entries in proptest::collection::vec(-1.0..1.0_f64, 48),
        times in proptest::collection::vec(0.0..3.0_f64, 6),
        torque in -5.0..5.0_f64,
    ) {
        let matrix = |from: usize| SMatrix::<f64, 4, 4>::from_fn(|i, j| entries[from + 4 * i + j]);
        let m = matrix(0);
        let system = System::new(m * m.transpose() + SMatrix::identity(), matrix(16), matrix(32));
        let motion = LinearMotion::new(&system).expect("a regular system");
        let mut times = times;
        times.push(0.0);
        times.sort_by(f64::total_cmp);
        let forces = [0.0, torque, 0.0, 1.0].map(|value| {
            Force::through(&[(0.0, value), (1.5, -value), (1.5, 2.0)]).expect("a force")
        });
        for row in motion.run(&[0.1, -0.2, 0.3, 0.0], &[1.0, 0.0, 0.0, -0.5], &forces, &times).expect("a motion") {
            let vector = |values: &[f64]| SMatrix::<f64, 4, 1>::from_column_slice(values);
            let f = SMatrix::<f64, 4, 1>::from_fn(|i, _| forces[i].at(row.time));
            let (q, rate) = (vector(&row.positions), vector(&row.rates));
            let left = system.m * vector(&row.accelerations) + system.c * rate + system.k * q - f;
            prop_assert!(left.amax() < 1e-12 * (1.0 + q.amax() + rate.amax()), "{left}");
        }
    }
}

/// The shipped bicycles, self-stable or not, satisfy their equations after 5 s as well.
#[test]
fn every_bicycle_keeps_to_its_equations() {
    for (name, design) in bicycles::all() {
        let system = design.coefficients().at(5.0, design.g).expect("finite numbers");
        let motion = LinearMotion::new(&system).expect("a regular system");
        let still = [Force::constant(0.0), Force::constant(0.0)];
        let rows = motion.run(&[0.1, 0.0], &[0.0, 0.0], &still, &[0.0, 2.5, 5.0]).expect("a motion");
        let column = |values: &[f64]| nalgebra::Vector2::new(values[0], values[1]);
        for row in rows {
            let (q, rate, acceleration) = (column(&row.positions), column(&row.rates), column(&row.accelerations));
            let left = system.m * acceleration + system.c * rate + system.k * q;
            let size = (system.m * acceleration).amax() + (system.k * q).amax();
            assert!(left.amax() < 1e-12 * size.max(1.0), "{name}: {left}");
        }
    }
}
