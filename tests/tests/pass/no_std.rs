//! A model in a crate without the standard library.

#![no_std]
#![forbid(unsafe_code)]
#![deny(warnings)]

use carvallo::{Model, StateSpace, System};

// For the program's start alone.
extern crate std;

carvallo::model! {
    pub model Pendulum {
        parameters { l: m, > 0; m: kg, > 0; }
        coordinates { theta: rad; }
        M = [[m*l^2]];
        K0 = [[m*l]];
    }
}

fn main() {
    let pendulum = Pendulum { l: 2.0, m: 3.0_f32 };
    assert_eq!(pendulum.matrices().m, [[12.0]]);

    let hanging: System<1, f32> = pendulum.coefficients().at(0.0, 10.0).unwrap();
    let motion: StateSpace<1, f32> = hanging.state_space().unwrap();
    assert_eq!(motion.stiffness[0], -5.0);
}
