//! Motions in time.

mod linear;
mod nonlinear;
mod pendulums;
