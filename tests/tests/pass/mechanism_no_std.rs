//! A mechanism in a crate without the standard library, among constants that have the names of what is derived.

#![no_std]
#![forbid(unsafe_code)]
#![deny(warnings, missing_docs)]

// For the program's start alone.
extern crate std;

#[allow(dead_code, non_upper_case_globals, missing_docs)]
mod names {
    pub const Jxx_all: u8 = 0;
    pub const m_theta: u8 = 0;
    pub const lateral: u8 = 0;
    pub const yaw: u8 = 0;
    pub const forces: u8 = 0;
    pub struct Rate;
}

use carvallo::{Linearizable as _, Motion as _};
#[allow(unused_imports)]
use names::*;

carvallo::model! {
    /// A push scooter without steering, with a rider who leans and a bag that swings.
    pub model Scooter {
        parameters {
            r: m, > 0;
            m: kg, > 0;
            h: m, > 0;
            k: N*m, >= 0;
            g: N/kg, >= 0, gravity;
        }
        let Ia = m*r^2/2;
        mechanism {
            body frame: massless;
            body rider: mass 3*m, at (0, 0, -r - h), inertia 0;
            body seat: mass 0.1 [kg], at (0, 0, -r), inertia 0;
            wheel W "rear wheel" on frame: mass m, at (0, 0, -r), radius r, axial Ia, radial Ia/2;
            wheel V on frame: mass m, at (h, 0, -r), radius r, tyre r/3, axial Ia, radial Ia/2;
            fix seat to frame;
            free frame: lean phi;
            revolute theta: frame to rider, through (0, 0, -r), along (2, 0, 0), spring k;
            revolute yaw: frame to bag, through (0, 0, 0), along (0, 0, -1), damper 2 [N*m*s];
            body bag: mass 0.5 [kg], at (0.1 [m], 0, -r), inertia [0, 0, 0.01 [kg*m^2]];
            force T "hip torque" on theta;
        }
        derivatives;
        nonlinear;
        coordinates { phi: rad; theta: rad; yaw: rad; }
        set example { r = 0.3; m = 1; h = 0.5; k = 20; g = 9.81; }
    }
}

fn main() {
    let scooter = Scooter::EXAMPLE;
    assert_eq!(scooter.matrices().kc[1][1], 20.0);
    let kinematics: ScooterKinematics = scooter.kinematics();
    assert_eq!(kinematics.forces, [[0.0], [1.0], [0.0]]);
    assert_eq!(kinematics.wheel_W.speed, -1.0 / 0.3);
    // Seen as a pendulum, whatever the length of the axis it is given by.
    assert_eq!(scooter.matrices().m[1][1], 3.0 * 0.5 * 0.5);

    // It stands: the wheels bear its weight, and its height is its energy.
    let weight = 9.81 * (3.0 + 0.1 + 1.0 + 1.0 + 0.5);
    let energy = 9.81 * (3.0 * 0.8 + (0.1 + 1.0 + 1.0 + 0.5) * 0.3);
    let motion = scooter.motion();
    let places = motion.close(&[0.0; 9]).expect("both wheels touch the ground");
    let borne = motion.contact_forces(&places, &[0.0; 4], &[0.0]).expect("it is regular");
    assert!((borne[0][2] + borne[1][2] + weight).abs() < 1e-12 * weight);
    let found = motion.energy(&places, &[0.0; 4]).expect("it is regular");
    assert!(found.kinetic == 0.0 && (found.potential - energy).abs() < 1e-12 * energy);
    // The same in single precision.
    let single: ScooterMotion<f32> = scooter.to_f32().motion();
    let places = single.close(&[0.0, 0.0, 0.0, 0.1, 0.0, -0.1, 0.2, 0.0, 0.0]).expect("both wheels touch the ground");
    let (rates, _) = single.derivatives(&places, &[0.0, 0.0, 0.0, -10.0], &[1.0]).expect("it is regular");
    assert!((rates[0] - 3.0).abs() < 1e-6);
    let energy = single.energy(&places, &[0.0; 4]).expect("it is regular");
    assert!(energy.potential.is_finite() && single.accelerations(&[f32::NAN; 9], &[0.0; 4], &[0.0]).is_err());

    // About standing still: the torque turns the rider against the spring, by the same share of both.
    let places = motion.close(&[0.0; 9]).expect("both wheels touch the ground");
    let about = motion.linearize(&places, &[0.0; 4], &[0.0]).expect("it is regular");
    assert_eq!(about.a[5][10], 1.0);
    let (_, pushed) = motion.derivatives(&places, &[0.0; 4], &[1.0]).expect("it is regular");
    assert!((about.b[10][0] - pushed[1]).abs() < 1e-12 * pushed[1]);
    // The spring k is the fourth parameter, and pulls nothing where it is relaxed.
    let by_parameters = motion.by_parameters(&places, &[0.0; 4], &[0.0]).expect("it is regular");
    assert!(by_parameters.iter().all(|row| row[3] == 0.0));
    let about = single.linearize(&[0.0; 9], &[0.0; 4], &[0.0]).expect("it is regular");
    assert!(about.a.iter().flatten().all(|entry: &f32| entry.is_finite()));
}
