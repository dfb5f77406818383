//! The eigenvalues of the equations of motion.

mod factors;
#[cfg(feature = "batch")]
mod four;
#[cfg(feature = "std")]
mod francis;
#[cfg(feature = "std")]
mod general;
#[cfg(feature = "std")]
mod hessenberg;
#[cfg(feature = "std")]
mod hidden;
#[cfg(feature = "std")]
mod matrix;
mod quadratic;
mod quartic;
#[cfg(feature = "std")]
pub(crate) mod quick;
#[cfg(feature = "std")]
mod refined;
mod resolvent;
#[cfg(feature = "std")]
mod shifts;
#[cfg(feature = "std")]
mod state_matrix;
mod two_coordinates;
#[cfg(feature = "std")]
mod vectors;

#[cfg(feature = "batch")]
pub(crate) use four::Four;
#[cfg(feature = "std")]
pub(crate) use general::Spectrum;
#[cfg(feature = "std")]
pub use matrix::matrix_eigenvalues;
#[cfg(feature = "std")]
pub(crate) use quartic::Quartic;
#[cfg(feature = "std")]
pub(crate) use state_matrix::{Layout, solve};
#[cfg(feature = "batch")]
pub(crate) use two_coordinates::quick_eigenvalues;
#[cfg(feature = "std")]
pub use vectors::Eigenvectors;
