//! Random mechanisms, compiled and as nonlinear dynamics: the derivation knows no bicycle.

pub mod links;
pub mod pair;
mod rolling;
mod slipping;

/// What the differences of the nonlinear dynamics may be off.
const DIFFERENCES: f64 = 1e-6;
