//! The command line of Carvallo: stability of bicycles, and of every other model that ships.
//!
//! A library, so that what it says of strangers' files can be tested without a process for each of them.

mod along;
mod analysis;
mod bodies;
mod commands;
pub mod design;
pub mod failure;
pub mod input;
mod limits;
mod matrices;
pub mod model;
pub mod nearest;
pub mod number;
mod options;
mod output;
mod plot;
mod quantity;
mod reach;
mod sensitivity;
mod simulate;
mod speeds;
mod strands;
mod sweep;
mod terminal;
mod turns;

pub use self::commands::main;
