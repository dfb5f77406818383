#![doc = include_str!("../README.md")]

mod bodies;
mod constraint;
mod goal;
mod measures;
mod optimum;
mod problem;
mod range;
mod search;

pub use self::constraint::Constraint;
pub use self::goal::{Goal, Measure};
pub use self::optimum::{End, Optimum, Progress};
pub use self::problem::{Problem, Settings};
pub use self::range::Range;
pub use self::search::optimize;
