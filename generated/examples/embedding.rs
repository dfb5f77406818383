//! The checked-in code of a model where there is no operating system: a bicycle is pushed, and rides on by itself.
//!
//! ```sh
//! cargo run -p carvallo-models --example embedding
//! ```
//!
//! Nothing but `main` needs the standard library; nothing allocates. All numbers are `f32`, which is what the processors of
//! many microcontrollers compute by themselves.

#![no_std]

// For printing alone.
extern crate std;

use carvallo::{Model, Rate, StateSpace, SystemError};
use carvallo_models::WhippleMechanism;

/// A bicycle that rides at a constant speed, as a microcontroller may carry it along: lean and steer and what follows.
struct Ride {
    /// Forward speed in m/s.
    speed: f32,
    motion: StateSpace<2, f32>,
    yaw_rate: Rate<f32, 2>,
    lateral_velocity: Rate<f32, 2>,
    /// Lean and steer in rad, their rates in rad/s, the yaw in rad, and the place to the right in m.
    state: [f32; 6],
}

impl Ride {
    /// Upright and straight.
    fn new(bicycle: &WhippleMechanism<f32>, speed: f32) -> Result<Self, SystemError> {
        let motion = bicycle.coefficients().at(speed, bicycle.g)?.state_space()?;
        let kinematics = bicycle.kinematics();
        let (yaw_rate, lateral_velocity) = (kinematics.yaw, kinematics.lateral);
        Ok(Self { speed, motion, yaw_rate, lateral_velocity, state: [0.0; 6] })
    }

    /// The rates of the state, under a lean and a steer torque in N m.
    fn rates(&self, state: &[f32; 6], torques: [f32; 2]) -> [f32; 6] {
        let [lean, steer, lean_rate, steer_rate, yaw, _] = *state;
        let StateSpace { stiffness, damping, input, .. } = &self.motion;
        let acceleration = |row: usize| {
            stiffness[(row, 0)] * lean
                + stiffness[(row, 1)] * steer
                + damping[(row, 0)] * lean_rate
                + damping[(row, 1)] * steer_rate
                + input[(row, 0)] * torques[0]
                + input[(row, 1)] * torques[1]
        };
        let follows = |rate: &Rate<f32, 2>| rate.at(self.speed, &[lean, steer], &[lean_rate, steer_rate], yaw);
        let (yaw_rate, lateral) = (follows(&self.yaw_rate), follows(&self.lateral_velocity));
        [lean_rate, steer_rate, acceleration(0), acceleration(1), yaw_rate, lateral]
    }

    /// Goes on by a time in s, by the classical method of Runge and Kutta.
    fn step(&mut self, time: f32, torques: [f32; 2]) {
        let from = self.state;
        let after = |time: f32, rates: &[f32; 6]| core::array::from_fn(|i| from[i] + time * rates[i]);
        let a = self.rates(&from, torques);
        let b = self.rates(&after(0.5 * time, &a), torques);
        let c = self.rates(&after(0.5 * time, &b), torques);
        let d = self.rates(&after(time, &c), torques);
        self.state = core::array::from_fn(|i| from[i] + time / 6.0 * (a[i] + 2.0 * (b[i] + c[i]) + d[i]));
    }
}

fn main() -> Result<(), std::boxed::Box<dyn core::error::Error>> {
    let bicycle = WhippleMechanism::BENCHMARK.cast::<f32>();
    bicycle.validate()?;
    let mut ride = Ride::new(&bicycle, 4.6)?;
    std::println!("the benchmark bicycle at {} m/s, pushed by 100 N m for a tenth of a second", ride.speed);
    std::println!("time      lean    steer      yaw   to the right");
    for millisecond in 0..=4000 {
        if millisecond % 250 == 0 {
            let [lean, steer, _, _, yaw, right] = ride.state;
            let [lean, steer, yaw] = [lean, steer, yaw].map(f32::to_degrees);
            let time = f64::from(millisecond) / 1000.0;
            std::println!("{time:4.2} s {lean:6.2} ° {steer:6.2} ° {yaw:6.2} ° {right:9.3} m");
        }
        let push = if millisecond < 100 { 100.0 } else { 0.0 };
        ride.step(0.001, [push, 0.0]);
    }
    Ok(())
}
