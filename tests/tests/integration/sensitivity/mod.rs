//! Derivatives of eigenvalues and critical speeds against differences at 320 bits, and the standard deviations that follow
//! from them against random designs.

mod critical;
mod deviations;
mod eigenvalues;
mod implicit;

use carvallo::Sensitivity;
use carvallo_models::Whipple;

fn sensitivity(design: &Whipple) -> Sensitivity<2> {
    Sensitivity::of(design).unwrap()
}

fn name(parameter: usize) -> &'static str {
    Whipple::INFO.parameters[parameter].name
}
