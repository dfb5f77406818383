//! Motion in time, from an initial state and under forces.
//!
//! The linear equations at one speed have an exact solution, [`LinearMotion`]: nothing is integrated, steps are as long as
//! those who ask want them, and no eigenvalue is too fast. Forces are piecewise linear in time ([`Force`]), as measured
//! ones are.
//!
//! With feature `simulation`, the nonlinear equations of a mechanism ([`Motion`](crate::Motion)) are integrated:
//! [`Simulation`], with controllers and events.
//!
//! ```
//! use carvallo::simulation::{Force, LinearMotion};
//! use carvallo::{Matrix, System};
//!
//! // A mass of 1 kg on a spring of 4 N/m, pushed from rest by 8 N: q = 2 (1 - cos 2t).
//! let system = System::new(Matrix::<f64, 1>::new(1.0), Matrix::<f64, 1>::new(0.0), Matrix::<f64, 1>::new(4.0));
//! let rows = LinearMotion::new(&system)?.run(&[0.0], &[0.0], &[Force::constant(8.0)], &[0.0, 0.5, 1.0])?;
//! assert!((rows[2].positions[0] - 2.0 * (1.0 - 2_f64.cos())).abs() < 1e-14);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(feature = "simulation")]
mod chart;
#[cfg(feature = "simulation")]
mod crossing;
#[cfg(feature = "simulation")]
mod drive;
mod error;
#[cfg(feature = "simulation")]
mod events;
mod exponential;
mod force;
#[cfg(feature = "simulation")]
mod integration;
mod linear;
#[cfg(feature = "simulation")]
mod machine;
#[cfg(feature = "simulation")]
mod nonlinear;
#[cfg(feature = "simulation")]
mod state;

#[cfg(feature = "simulation")]
pub use crossing::{Crossing, change_of_sign};
#[cfg(feature = "simulation")]
pub use drive::Drive;
pub use error::SimulationError;
pub use exponential::{Propagator, PropagatorError};
pub use force::{Force, ForceError};
pub use linear::{LinearMotion, Snapshot};
#[cfg(feature = "simulation")]
pub use machine::{Machine, MachineLinearization, Moving};
#[cfg(feature = "simulation")]
pub use nonlinear::{End, Happening, Moment, Ride, RideRow, Simulation};
#[cfg(feature = "simulation")]
pub use state::State;
