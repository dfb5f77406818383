//! Motions in time, and from what they are computed.

mod contacts;
mod force;
mod initial;
mod linear;
mod motion;
mod nonlinear;
mod solver;
mod watch;

pub use self::contacts::paths;
pub use self::force::Channel;
pub use self::initial::{Givable, Initial, doubt, value};
pub use self::linear::Linear;
pub use self::motion::{Motion, Quantity, Row};
pub use self::nonlinear::Nonlinear;
pub use self::solver::{Given, Solver, read};
pub use self::watch::{Happened, Watch};
