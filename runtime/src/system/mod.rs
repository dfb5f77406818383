//! The linearized equations of motion: their coefficients, and what they are at one speed and one gravity.

#[cfg(feature = "approx")]
mod approximate;
mod at_speed;
mod coefficients;
mod elimination;
mod error;
mod rows;
mod state_space;
mod states;
#[cfg(all(feature = "serde", feature = "std"))]
mod written;

pub use at_speed::System;
#[cfg(feature = "std")]
pub(crate) use at_speed::require_finite;
pub(crate) use at_speed::require_speed;
pub use coefficients::{Coefficients, Matrix, MatrixName, rows};
#[cfg(feature = "std")]
pub(crate) use elimination::solve_in_place;
pub use error::SystemError;
pub use rows::Rows;
pub use state_space::StateSpace;
pub use states::States;
