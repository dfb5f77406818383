//! Models that a build script compiles: a public one with derivatives, and a private one that is a mechanism.

#![no_std]
#![forbid(unsafe_code)]
#![deny(warnings, missing_docs, clippy::all, clippy::pedantic)]

include!(concat!(env!("OUT_DIR"), "/models.rs"));

#[test]
fn the_public_one_is_a_model() {
    use carvallo::{Differentiable, Model};
    assert_eq!(Spring::SOFT.validate(), Ok(()));
    assert_eq!(Spring::SOFT.matrices().kc, [[1.5]]);
    // k sin(alpha)^2 + k cos(alpha)/2 by m, k and alpha, at alpha = 0.
    let (_, by_parameters) = Spring::SOFT.coefficients_and_derivatives();
    assert_eq!(by_parameters.map(|by| [by.kc[(0, 0)]]), [[0.0], [0.5], [0.0]]);
}

#[test]
fn the_private_one_is_a_model_of_this_module() {
    let coin = Coin { r: 0.5, m: 2.0, g: 6.0 };
    // Forward, it turns about -y, by v/r.
    let turning: f64 = coin.kinematics().wheel_D.at(3.0, &[0.0; 2], &[0.0; 2], 0.0);
    assert!((turning + 6.0).abs() < f64::EPSILON, "{turning}");
}
