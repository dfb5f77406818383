//! A model in a crate of edition 2021 that calls the runtime by another name, and hands it on under that name.

#![no_std]
#![forbid(unsafe_code)]
#![deny(warnings, missing_docs, clippy::all, clippy::pedantic)]

pub use dynamics;

dynamics::model! {
    /// A mass on a spring.
    pub model Spring {
        parameters {
            /// The mass.
            m: kg, > 0;
            k: N/m, >= 0;
            alpha: rad;
        }
        let stiffness = k*sin(alpha)^2 + k*cos(alpha)/2;
        require k + m*1 [Hz^2] > 0;
        coordinates { x: m; }
        M = [[m]];
        Kc = [[stiffness]];
        set soft { m = 2; k = 3; alpha = 0; }
    }
}

#[test]
fn it_is_a_model() {
    use dynamics::Model;
    assert_eq!(Spring::SOFT.validate(), Ok(()));
    assert_eq!(Spring::SOFT.matrices().kc, [[1.5]]);
}
