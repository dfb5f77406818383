//! A model in a crate that has the runtime only through another crate, and a module of the runtime's name.

#![forbid(unsafe_code)]
#![deny(warnings, missing_docs, clippy::all, clippy::pedantic)]

/// Not the runtime.
pub mod carvallo {}

/// Nor the standard library.
pub mod core {}

pub use carvallo_tests_renamed::dynamics::model;

model! {
    pub(crate) model Pendulum {
        parameters { l: m, > 0; m: kg, > 0; g: N/kg, gravity; }
        coordinates { theta: rad; }
        M = [[m*l^2]];
        K0 = [[m*l]];
    }
}

#[test]
fn it_is_a_model() {
    use carvallo_tests_renamed::dynamics::Model;
    let pendulum = Pendulum { l: 2.0, m: 3.0_f32, g: 10.0 };
    assert_eq!(pendulum.matrices().m, [[12.0]]);
    assert_eq!(pendulum.gravity(), Some(10.0));
}
