//! A model in a crate without the standard library.

#![no_std]
#![forbid(unsafe_code)]
#![deny(warnings)]

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
    assert_eq!(Pendulum { l: 2.0, m: 3.0_f32 }.matrices().m, [[12.0]]);
}
