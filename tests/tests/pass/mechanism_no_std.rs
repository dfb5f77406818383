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
}
