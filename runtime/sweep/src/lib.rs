#![doc = include_str!("../README.md")]

mod destination;
mod evaluate;
mod generate;
mod map;
mod pipeline;
mod plan;
mod read;
mod request;
mod source;
mod sweep;
mod table;
mod write;

pub use self::plan::Plan;
pub use self::request::Request;
pub use self::sweep::{Outcome, Sweep};
