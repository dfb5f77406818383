//! The nonlinear equations of a bicycle in a simulator of one's own, as a microcontroller may carry it along: a bicycle is
//! pushed, and rides on by itself.
//!
//! ```sh
//! cargo run -p carvallo-models --example riding
//! ```
//!
//! Nothing but `main` needs the standard library; nothing allocates. All numbers are `f32`, which is what the processors of
//! many microcontrollers compute by themselves.

#![no_std]

// For printing alone.
extern crate std;

use carvallo::motion::Unchecked;
use carvallo::{Motion, MotionError};
use carvallo_models::{WhippleMechanism, WhippleMechanismMotion};

/// A mechanism with its state.
struct Ride<M: Motion> {
    motion: M,
    positions: M::Positions,
    speeds: M::Speeds,
}

impl<M: Motion<Scalar = f32>> Ride<M> {
    /// Goes on by a time in s under constant forces, by the classical method of Runge and Kutta.
    fn step(&mut self, time: f32, forces: &M::Forces) -> Result<(), MotionError> {
        // By how much of the step each stage goes on from the derivatives of the one before, and what it counts for.
        const STAGES: [(f32, f32); 4] = [(0.0, 1.0 / 6.0), (0.5, 1.0 / 3.0), (0.5, 1.0 / 3.0), (1.0, 1.0 / 6.0)];
        let (mut positions, mut speeds) = (self.positions, self.speeds);
        let mut derivatives = None;
        for (ahead, share) in STAGES {
            let (mut stage_positions, mut stage_speeds) = (self.positions, self.speeds);
            if let Some((rates, accelerations)) = &derivatives {
                add(&mut stage_positions, ahead * time, rates);
                add(&mut stage_speeds, ahead * time, accelerations);
            }
            let (rates, accelerations) = self.motion.derivatives(&stage_positions, &stage_speeds, forces)?;
            add(&mut positions, share * time, &rates);
            add(&mut speeds, share * time, &accelerations);
            derivatives = Some((rates, accelerations));
        }
        // The pitch is what keeps both wheels on the ground, whatever the method errs.
        (self.positions, self.speeds) = (self.motion.close(&positions)?, speeds);
        Ok(())
    }
}

/// Adds so much of other numbers.
fn add<V: AsMut<[f32]> + AsRef<[f32]>>(to: &mut V, factor: f32, other: &V) {
    to.as_mut().iter_mut().zip(other.as_ref()).for_each(|(value, other)| *value += factor * other);
}

fn main() -> Result<(), std::boxed::Box<dyn core::error::Error>> {
    let bicycle = WhippleMechanism::BENCHMARK.cast::<f32>();
    let motion = bicycle.motion();
    let info = WhippleMechanismMotion::<f32>::INFO;
    let place = |name: &str| info.position(name).ok_or("a position of that name");
    let [x, y, yaw, lean, steer, wheel] = ["x", "y", "psi", "phi", "delta", "thetaR"].map(place);
    let (x, y, yaw, lean, steer, wheel) = (x?, y?, yaw?, lean?, steer?, wheel?);

    // Upright and straight, at 4.6 m/s.
    let positions = motion.close(&<WhippleMechanismMotion<f32> as Unchecked>::Positions::default())?;
    let mut speeds = <WhippleMechanismMotion<f32> as Unchecked>::Speeds::default();
    speeds[info.speed_of(wheel).ok_or("the rate of the rear wheel is a speed")?] = -4.6 / bicycle.rR;
    let mut ride = Ride { motion, positions, speeds };
    std::println!("the benchmark bicycle at 4.6 m/s, its frame pushed by 100 N m for a tenth of a second");
    std::println!("time      speed     lean    steer      yaw    forward   to the right");
    for millisecond in 0..=4000 {
        if millisecond % 250 == 0 {
            let q = &ride.positions;
            let speed = -bicycle.rR * ride.motion.rates(&ride.positions, &ride.speeds)?[wheel];
            let [lean, steer, yaw] = [q[lean], q[steer], q[yaw]].map(f32::to_degrees);
            let time = f64::from(millisecond) / 1000.0;
            std::println!(
                "{time:4.2} s {speed:6.3} m/s {lean:6.2} ° {steer:6.2} ° {yaw:6.2} ° {:8.3} m {:8.3} m",
                q[x],
                q[y]
            );
        }
        // Lean torque and steer torque, in the order of `MotionInfo::forces`.
        let push = if millisecond < 100 { 100.0 } else { 0.0 };
        ride.step(0.001, &[push, 0.0])?;
    }
    Ok(())
}
