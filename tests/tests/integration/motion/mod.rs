//! Nonlinear motion of mechanisms, against figures and dynamics from elsewhere.

#[cfg(feature = "compiler")]
mod interpreted;
#[cfg(feature = "compiler")]
mod linear;
mod partials;
mod published;
#[cfg(feature = "compiler")]
mod random;
