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
        set long { l = 2; m = 3; }
    }
}

// As on a microcontroller.
const LONG: Pendulum<f32> = Pendulum::LONG.to_f32();

fn main() {
    let pendulum = Pendulum { l: 2.0, m: 3.0_f32 };
    assert_eq!(pendulum.matrices().m, [[12.0]]);

    let hanging: System<1, f32> = pendulum.coefficients().at(0.0, 10.0).unwrap();
    let motion: StateSpace<1, f32> = hanging.state_space().unwrap();
    assert_eq!(motion.stiffness[0], -5.0);

    assert_eq!(LONG.matrices().m, [[12.0]]);
    assert_eq!(Pendulum::set("LONG").map(|pendulum| pendulum.l), Some(2.0));
    assert_eq!(<Pendulum<f32> as carvallo::Model<1>>::set("long"), Some(LONG));
    assert_eq!(Pendulum::INFO.name, "Pendulum");
    assert_eq!(std::format!("{LONG}"), "l = 2.0 m\nm = 3.0 kg");
}
