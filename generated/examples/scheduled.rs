//! A gain-scheduled controller: a bicycle goes from 2 to 8 m/s, at nearly all of which it would fall by itself, and is held
//! upright by torques on its steer.
//!
//! ```sh
//! cargo run -p carvallo-models --example scheduled
//! ```
//!
//! The controller is in `controller/mod.rs`, which the tests of microcontrollers run as well, with the same bits.

mod controller;

use carvallo::SystemError;
use carvallo_models::Whipple;
use controller::{Ride, torque};

fn main() -> Result<(), SystemError> {
    let bicycle: Whipple<f32> = Whipple::BENCHMARK.cast();
    let mut ride = Ride::new(&bicycle, 2.0, 0.05);
    println!("  time   speed      lean     steer    torque");
    for sample in 0..=600 {
        if sample % 50 == 0 {
            let [lean, steer, ..] = ride.state.map(f32::to_degrees);
            let torque = torque(ride.speed, &ride.state);
            println!(
                "{:4.1} s {:4.1} m/s {lean:6.2}\u{b0} {steer:8.2}\u{b0} {torque:6.2} N m",
                0.01 * sample as f32,
                ride.speed
            );
        }
        ride.step(0.01)?;
    }
    assert!(ride.state.iter().all(|x| x.abs() < 1e-3), "{:?}", ride.state);
    Ok(())
}
