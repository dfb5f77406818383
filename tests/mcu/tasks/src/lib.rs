//! What is computed on the microcontroller and on the host, which have to come to the same bits.

#![no_std]

#[path = "../../../../generated/examples/controller/mod.rs"]
mod controller;

use carvallo::{CertainStability, Coefficients, Complex, Model, Motion, Rows, Scalar, StateSpace, System, SystemError};
use carvallo_models::{Whipple, WhippleMechanism};
use controller::Ride;

/// A forward speed in m/s, and a gravitational field strength in N/kg.
pub const SPEED: f64 = 5.0;
pub const GRAVITY: f64 = 9.81;

/// Something to compute.
pub trait Task {
    /// What it is called in `costs.tsv`, and its program.
    const NAME: &'static str;
    /// How often it runs while the clock is read once.
    const TIMES: u32 = 1000;
    /// What it starts from, and what it comes to.
    type Input;
    type Output;

    fn input() -> Self::Input;
    fn run(input: &Self::Input) -> Self::Output;
    /// Tells the bits of every number that it came to.
    fn bits(output: &Self::Output, tell: &mut dyn FnMut(u64));
}

macro_rules! task {
    ($(#[$doc:meta])* $Task:ident, $name:literal $(times $times:literal)?, $Input:ty => $Output:ty, $input:expr, $run:expr, $bits:expr) => {
        $(#[$doc])*
        pub struct $Task;
        impl Task for $Task {
            const NAME: &'static str = $name;
            $(const TIMES: u32 = $times;)?
            type Input = $Input;
            type Output = $Output;
            fn input() -> $Input {
                $input
            }
            fn run(input: &$Input) -> $Output {
                let run: fn(&$Input) -> $Output = $run;
                run(input)
            }
            fn bits(output: &$Output, tell: &mut dyn FnMut(u64)) {
                let bits: fn(&$Output, &mut dyn FnMut(u64)) = $bits;
                bits(output, tell)
            }
        }
    };
}

task!(
    /// Nothing.
    Empty, "empty", () => (), (), |()| (), |(), _| ()
);
task!(
    /// The four matrices, from the parameters.
    MatricesF32, "matrices_f32", Whipple<f32> => [Rows<f32, 2>; 4], Whipple::BENCHMARK.to_f32(), |bicycle| {
        let found = bicycle.matrices();
        [found.m, found.c1, found.k0, found.k2]
    },
    |found, tell| of_matrices(found, |x| tell(x.to_bits().into()))
);
task!(
    /// The same in double precision.
    MatricesF64, "matrices_f64", Whipple<f64> => [Rows<f64, 2>; 4], Whipple::BENCHMARK, |bicycle| {
        let found = bicycle.matrices();
        [found.m, found.c1, found.k0, found.k2]
    },
    |found, tell| of_matrices(found, |x| tell(x.to_bits()))
);
task!(
    /// The state-space form at a speed, from the matrices.
    StateSpaceF32, "state_space_f32", Coefficients<f32, 2> => Result<StateSpace<2, f32>, SystemError>,
    Whipple::BENCHMARK.to_f32().coefficients(), state_space,
    |found, tell| of_state_space(found, |x| tell(x.to_bits().into()))
);
task!(
    /// The same in double precision.
    StateSpaceF64, "state_space_f64", Coefficients<f64, 2> => Result<StateSpace<2, f64>, SystemError>,
    Whipple::BENCHMARK.coefficients(), state_space, |found, tell| of_state_space(found, |x| tell(x.to_bits()))
);
task!(
    /// The four eigenvalues, from M, C and K.
    Eigenvalues, "eigenvalues", Option<System<2>> => Option<[Complex<f64>; 4]>,
    Whipple::BENCHMARK.coefficients().at(SPEED, GRAVITY).ok(), |system| system.as_ref()?.quartic_eigenvalues().ok(), eigenvalues
);
task!(
    /// The same in single precision.
    EigenvaluesF32, "eigenvalues_f32", Option<System<2, f32>> => Option<[Complex<f32>; 4]>,
    Whipple::BENCHMARK.to_f32().coefficients().at(SPEED as f32, GRAVITY as f32).ok(),
    |system| system.as_ref()?.quartic_eigenvalues_f32().ok(),
    |found, tell| found.iter().flatten().for_each(|value| [value.re, value.im].iter().for_each(|x| tell(x.to_bits().into())))
);
task!(
    /// The four eigenvalues, from the parameters.
    ParametersToEigenvalues, "parameters_to_eigenvalues", Whipple<f64> => Option<[Complex<f64>; 4]>,
    Whipple::BENCHMARK, |bicycle| bicycle.coefficients().at(SPEED, bicycle.g).ok()?.quartic_eigenvalues().ok(), eigenvalues
);
task!(
    /// The critical speeds and the stable ranges, from the matrices.
    CriticalSpeeds, "critical_speeds" times 100, Coefficients<f64, 2> => Result<CertainStability, SystemError>,
    Whipple::BENCHMARK.coefficients(), |matrices| CertainStability::new(matrices, GRAVITY), along_speed
);
task!(
    /// The nonlinear accelerations of a leaned and steered bicycle.
    AccelerationsF32, "accelerations_f32", (WhippleMechanism<f32>, [f32; 8], [f32; 3], [f32; 2]) => Option<[f32; 8]>,
    (WhippleMechanism::BENCHMARK.to_f32(), [0.0, 0.0, 0.0, 0.1, 0.2, 0.0, 0.0, 0.0], [0.5, -0.3, 4.0], [0.0, 1.0]),
    |(bicycle, positions, speeds, forces)| {
        bicycle.motion().accelerations(positions, speeds, forces).ok()
    },
    |found, tell| found.iter().flatten().for_each(|x| tell(x.to_bits().into()))
);
task!(
    /// A sample of a ride that is controlled with scheduled gains: state-space form, torque, and a step of the simulation.
    ControlF32, "control_f32", Ride => [f32; 5], Ride::new(&Whipple::BENCHMARK.to_f32(), 2.0, 0.05), |ride| after(ride, 1), states
);

task!(
    /// Six seconds of that ride.
    RideF32, "ride_f32" times 10, Ride => [f32; 5], ControlF32::input(), |ride| after(ride, 600), states
);

/// The state and the speed of a ride after so many samples; zeros, if it does not get there.
fn after(ride: &Ride, samples: usize) -> [f32; 5] {
    let mut ride = ride.clone();
    for _ in 0..samples {
        if ride.step(0.01).is_err() {
            return [0.0; 5];
        }
    }
    let [lean, steer, lean_rate, steer_rate] = ride.state;
    [lean, steer, lean_rate, steer_rate, ride.speed]
}

fn states(found: &[f32; 5], tell: &mut dyn FnMut(u64)) {
    found.iter().for_each(|x| tell(x.to_bits().into()));
}

fn of_matrices<T: Scalar>(found: &[Rows<T, 2>; 4], mut tell: impl FnMut(T)) {
    for rows in found {
        rows.iter().flatten().for_each(|entry| tell(*entry));
    }
}

fn state_space<T: Scalar>(matrices: &Coefficients<T, 2>) -> Result<StateSpace<2, T>, SystemError> {
    matrices.at(T::from_f64(SPEED), T::from_f64(GRAVITY))?.state_space()
}

fn of_state_space<T: Scalar>(found: &Result<StateSpace<2, T>, SystemError>, mut tell: impl FnMut(T)) {
    if let Ok(found) = found {
        for block in [&found.stiffness, &found.damping, &found.input] {
            block.iter().for_each(|entry| tell(*entry));
        }
    }
}

fn along_speed(found: &Result<CertainStability, SystemError>, tell: &mut dyn FnMut(u64)) {
    let Ok(found) = found else { return };
    for critical in found.critical_speeds() {
        [critical.speed, critical.error, critical.eigenvalue.re, critical.eigenvalue.im]
            .iter()
            .for_each(|x| tell(x.to_bits()));
    }
    for range in found.stable_ranges() {
        tell(range.from.to_bits());
        tell(range.to.map_or(0, f64::to_bits));
    }
}

fn eigenvalues(found: &Option<[Complex<f64>; 4]>, tell: &mut dyn FnMut(u64)) {
    for value in found.iter().flatten() {
        tell(value.re.to_bits());
        tell(value.im.to_bits());
    }
}
