//! Arithmetic that the analysis stands on: scaling by powers of two, twice the precision, real roots of polynomials.

mod double_double;
mod real;
mod scale;

pub(crate) use double_double::DoubleDouble;
pub(crate) use real::Real;
pub(crate) use scale::{equilibrate, exponent, ldexp};

#[cfg(feature = "std")]
pub(crate) mod fixed;
#[cfg(feature = "std")]
pub(crate) mod isolation;
#[cfg(feature = "std")]
mod polynomial;
#[cfg(feature = "std")]
mod refinement;
#[cfg(feature = "std")]
mod roots;
#[cfg(feature = "std")]
pub(crate) mod rounded;
#[cfg(feature = "std")]
mod sum;

#[cfg(feature = "std")]
pub(crate) use polynomial::Polynomial;
#[cfg(feature = "std")]
pub(crate) use roots::{Root, candidates, positive_roots};
#[cfg(feature = "std")]
pub(crate) use sum::{NOISE, Sum};
