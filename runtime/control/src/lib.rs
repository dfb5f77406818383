#![doc = include_str!("../README.md")]

pub mod files;
mod ports;
mod signal;
mod state_space;

pub use self::ports::{Output, Ports};
pub use self::signal::{Order, Quantity, Signal};
pub use self::state_space::StateSpace;

#[cfg(test)]
mod tests;
