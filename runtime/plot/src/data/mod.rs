//! Analyses as JSON and as comma-separated values. What is in them is documented beside the command line, which writes
//! the same, and stays.

pub mod along;
pub mod analysis;
mod cells;
#[cfg(feature = "units")]
pub mod compare;
#[cfg(feature = "control")]
pub mod controllability;
mod head;
mod layout;
mod matrices;
pub mod motion;
#[cfg(feature = "optimize")]
pub mod optimum;
pub mod parameters;
#[cfg(feature = "control")]
pub mod response;
#[cfg(feature = "control")]
pub mod schedule;
pub mod sensitivity;
#[cfg(feature = "control")]
mod signals;
#[cfg(feature = "control")]
pub mod state_space;
#[cfg(feature = "control")]
pub mod transfer;
#[cfg(feature = "turns")]
pub mod turns;

pub use self::matrices::{Matrix, matrices};
