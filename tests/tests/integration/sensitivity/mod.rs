//! Derivatives of eigenvalues and critical speeds against differences at 320 bits, and the standard deviations that follow
//! from them against random designs.

mod critical;
mod deviations;
mod eigenvalues;

use carvallo::{Model, Sensitivity};
use carvallo_models::Whipple;
use carvallo_tests::differences::Exact;

fn sensitivity(design: &Whipple) -> Sensitivity<2> {
    let derivatives = Exact::of(design).coefficient_derivatives();
    Sensitivity::new(&design.coefficients(), &derivatives, design.g, Whipple::<f64>::INFO.gravity).unwrap()
}

fn name(parameter: usize) -> &'static str {
    Whipple::<f64>::INFO.parameters[parameter].name
}
