//! Arithmetic that the analysis stands on: scaling by powers of two, twice the precision, real roots of polynomials.

#[cfg(feature = "std")]
mod complex_double_double;
mod double_double;
mod scale;

#[cfg(feature = "std")]
pub(crate) use complex_double_double::ComplexDoubleDouble;
pub(crate) use double_double::{DoubleDouble, Part};
pub(crate) use scale::{Scaled, exponent, ldexp};

pub(crate) mod fixed;
pub(crate) mod isolation;
#[cfg(feature = "std")]
mod polynomial;
mod refinement;
#[cfg(feature = "std")]
mod roots;
pub(crate) mod rounded;
#[cfg(feature = "std")]
mod sort;
#[cfg(feature = "std")]
mod square;
mod taylor;
mod tracked;

#[cfg(feature = "std")]
pub(crate) use polynomial::Polynomial;
#[cfg(feature = "std")]
pub(crate) use roots::{Root, candidates, positive_roots};
#[cfg(feature = "std")]
pub use sort::sort_by;
#[cfg(feature = "std")]
pub(crate) use square::Square;
pub(crate) use taylor::expand_taylor;
#[cfg(feature = "std")]
pub(crate) use tracked::NOISE;
pub(crate) use tracked::{Exact, Tracked};
