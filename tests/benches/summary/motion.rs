//! Nonlinear motion of the benchmark bicycle, against dynamics of the same mechanism in floating point.

use std::hint::black_box;

use carvallo::{Motion, Scalar};
use carvallo_compare::Task;
use carvallo_models::WhippleMechanism;
use carvallo_tests::bicycles;
use carvallo_tests::multibody::bicycle::{Bicycle, Extras};
use carvallo_tests::multibody::dynamics::Drive;
use nalgebra::{SMatrix, SVector};

use crate::Summary;

const REPETITIONS: usize = 100;

/// Lean, steer and the angle of the rear wheel, and their rates, in a turn.
const STATE: [[f64; 3]; 2] = [[0.4, -0.2, 0.0], [-0.6, -0.5, -9.0]];

pub fn add(summary: &mut Summary) {
    let bicycle = Bicycle::new(&bicycles::named("benchmark"), &Extras::default());
    let independent = [bicycle.root.lean, bicycle.steer, bicycle.rear_wheel];
    let drive = Drive { gravity: 9.81, ..Drive::new(independent, None) };
    // Forces are linear in accelerations: three motions tell the masses, and one the rest.
    let accelerations = |[q, u]: &[[f64; 3]; 2]| {
        let taken =
            |rates| SVector::<f64, 3>::from_column_slice(bicycle.mechanism.forces(&drive, [*q, *u, rates]).as_slice());
        let still = taken([0.0; 3]);
        let column = |speed: usize| taken(std::array::from_fn(|other| f64::from(u8::from(other == speed)))) - still;
        let mass = SMatrix::<f64, 3, 3>::from_columns(&[column(0), column(1), column(2)]);
        mass.try_inverse().map(|inverse| inverse * -still)
    };
    let task = Task::new("Accelerations of the benchmark bicycle in a turn, one state", REPETITIONS)
        .contender("multibody dynamics in floating point", repeated(STATE, accelerations));
    let task = of_scalar::<f64>(task, ["ours, all accelerations, f64", "ours, speeds and rates, f64"]);
    let task = of_scalar::<f32>(task, ["ours, all accelerations, f32", "ours, speeds and rates, f32"]);
    let task = task.contender("ours, contact forces, f64", {
        let (motion, positions, speeds) = turning::<f64>();
        repeated((positions, speeds), move |(positions, speeds)| motion.contact_forces(positions, speeds, &[0.0; 2]))
    });
    let task = task.contender("ours, closure from upright, f64", {
        let (motion, mut positions, _) = turning::<f64>();
        positions[4] = 0.0;
        repeated(positions, move |positions| motion.close(positions))
    });
    summary.run(task);
}

fn of_scalar<'a, T: Scalar>(task: Task<'a>, [all, speeds_alone]: [&'static str; 2]) -> Task<'a> {
    let (motion, positions, speeds) = turning::<T>();
    let none = [T::from_f64(0.0); 2];
    task.contender(
        all,
        repeated((positions, speeds), move |(positions, speeds)| motion.accelerations(positions, speeds, &none)),
    )
    .contender(
        speeds_alone,
        repeated((positions, speeds), move |(positions, speeds)| motion.derivatives(positions, speeds, &none)),
    )
}

/// The bicycle, positions in which it stands, and speeds.
fn turning<T: Scalar>() -> (carvallo_models::WhippleMechanismMotion<T>, [T; 8], [T; 3]) {
    let motion = WhippleMechanism::BENCHMARK.cast::<T>().motion();
    let [[lean, steer, _], speeds] = STATE.map(|values| values.map(T::from_f64));
    let zero = T::from_f64(0.0);
    let positions = [zero, zero, zero, lean, zero, steer, zero, zero];
    (motion, motion.close(&positions).expect("it stands on both wheels"), speeds)
}

fn repeated<S, R>(state: S, compute: impl Fn(&S) -> R) -> impl FnMut() {
    move || {
        for _ in 0..REPETITIONS {
            let result = compute(black_box(&state));
            black_box(&result);
        }
    }
}
