//! Gains that keep a machine upright: the linear quadratic regulator, at a speed and scheduled along speeds.

mod code;
mod modes;
mod regulator;
mod riccati;
mod schedule;
mod sensitivities;
mod weights;

pub use self::code::Code;
pub use self::regulator::Regulator;
pub use self::riccati::{Riccati, RiccatiError};
pub use self::schedule::Schedule;
pub use self::weights::Weights;
