//! The command line of Carvallo: stability of bicycles, and of every other model that ships.

mod commands;
mod delivery;
mod destination;
mod endings;
mod frequencies;
mod limits;
mod options;
mod output;
mod picture;
mod ports;
mod simulate;
mod sweep;
mod terminal;

pub use self::commands::main;
