//! What the tests and benchmarks of Carvallo hold its results against.
//!
//! Four ways to the matrices that share no code with the compiler: [`hand_written`] floating point after Appendix A of
//! Meijaard, Papadopoulos, Ruina & Schwab (2007), [`exact`] arithmetic at 320 bits, differences of nonlinear [`multibody`]
//! dynamics, and the digits that were [`published`]. Designs to compare them on come from [`bicycles`] and, at random,
//! from [`designs`]. Eigenvalues are held against [`roots`] of the characteristic [`quartic`], critical speeds against
//! recomputed [`facts`], and derivatives of all of them against [`differences`] at 320 bits. What the compiler's own checks are
//! worth is measured on `mutants`, declarations with one slip each, and how many of these slips are [`explained`] by their
//! numbers. Other mechanisms than the bicycle have their matrices by hand in [`textbook`].

pub mod backward;
pub mod bicycles;
pub mod chain;
/// The bicycle by formulas that asks for a few of its derivatives.
#[rustfmt::skip]
#[allow(clippy::pedantic)]
pub mod chosen;
pub mod designs;
pub mod differences;
pub mod exact;
pub mod explained;
pub mod facts;
#[cfg(feature = "compiler")]
pub mod fractions;
pub mod hand_written;
pub mod multibody;
#[cfg(feature = "compiler")]
pub mod mutants;
pub mod operations;
pub mod peers;
pub mod published;
pub mod quartic;
pub mod roots;
pub mod rounding;
pub mod textbook;

/// The example of the README, which must compile and run as it stands there.
#[cfg(all(doctest, feature = "compiler"))]
#[doc = include_str!("../../README.md")]
struct Readme;
