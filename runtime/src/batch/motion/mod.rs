//! The nonlinear equations of motion in lanes: in many states, and in time.

mod accelerations;
mod ensemble;
mod limits;
mod run;
mod start;
mod states;
mod steps;

pub use ensemble::{Arrival, Ensemble, Outcome};
pub use limits::Limit;
