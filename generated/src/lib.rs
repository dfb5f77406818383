//! Models compiled ahead of time by Carvallo, and the bicycles that were measured for them.
//!
//! A model is a struct with its parameters as fields and its parameter sets as constants. Its code is checked in: nothing is
//! compiled but plain Rust without the standard library, and no computer algebra.
//!
//! ```
//! use carvallo_models::Whipple;
//!
//! let bicycle = Whipple { mB: 90.0, ..Whipple::BENCHMARK };
//! let matrices = bicycle.matrices();
//! // Appendix A: the height of the centre of mass times the total mass, negative since z points down.
//! let moment = -(0.3 * 2.0 + 0.9 * 90.0 + 0.7 * 4.0 + 0.35 * 3.0);
//! assert!((matrices.k0[0][0] - moment).abs() < 1e-12);
//! ```
//!
//! Each model is held against a source outside its derivation, and the mechanisms [`WhippleMechanism`], [`WhippleSprung`],
//! [`WhippleTyres`] and [`WhippleLeaning`] also against nonlinear multibody dynamics:
//!
//! | model | checked against |
//! | --- | --- |
//! | [`Whipple`], from the formulas of Appendix A | the published digits of Meijaard, Papadopoulos, Ruina & Schwab (2007) and of 2005, two other implementations, and the nonlinear dynamics |
//! | [`WhippleMechanism`]: four bodies | Appendix A, proved entry by entry, and in exact fractions at 100 random designs; the published digits; the published 2.8 m/s of the two-mass skate |
//! | [`WhippleSprung`]: with a steering spring and damper | Appendix A and one term each |
//! | [`WhippleTyres`]: on tyres with a circular cross-section | the extended model in closed form; without a radius Appendix A |
//! | [`WhippleLeaning`]: a rider's upper body on a sprung, damped hip, 3 freedoms | Moore (2012); with a locked hip Appendix A |
//! | [`RearSteered`]: also a bicycle run backwards | Appendix A with the geometry mirrored |
//! | [`Motorcycle`]: on tyres that relax, 6 coordinates, from bodies | the 24 eigenvalues that Sharp (1971) prints; critical speeds of his equations to 25 digits |
//! | [`Car`]: on tyres that slip | its critical speed in closed form |
//! | [`RollingDisc`]: lean and yaw | textbooks: stable from v² = g r/3 (uniform) and g r/4 (hoop) on |
//! | [`Skateboard`]: four wheels on two trucks | the equation of one freedom that Hubbard (1979) and Kremnev & Kuleshov have, derived anew; its critical speed in closed form |
//! | [`DoublePendulum`], and chains of up to 8 links in the tests | textbooks |
//! | [`FlywheelBicycle`]: rotors in both frames | Appendix A with their angular momenta, proved entry by entry; wheels with heavier rims, at one speed each |
//! | [`BalanceAssist`]: a motor steers into the fall | Appendix A with the torque, proved entry by entry; the matrices of [`Whipple`] with it added by hand |
//! | [`CarTrailer`]: on tyres that slip | a second derivation by Lagrange, and its eigenvalues |
//! | [`WheeledPendulum`]: free to speed up and slow down | closed forms of the fall, of the inertia in yaw and of what the motors do |
//! | [`Wheelset`]: linear creep, divided by the speed | the hunting speed in closed form, the wave of Klingel (1883) |
//! | [`TowedWheel`]: a place of first order | the characteristic polynomial and the limits of Schwab & Meijaard (2003) |
//! | [`TypicalSection`]: steady lift | its flutter speed, recomputed to 30 digits, and its divergence in closed form |
//! | [`JeffcottRotor`]: damping that turns with the shaft | the threshold of the textbooks, eigenvalues in closed form |
//! | [`CantileveredPipe`]: four modes | integrals of the modes; recomputed critical speeds for five parts of the fluid, the jump of Gregory & Paidoussis (1966) among them |
//!
//! What is printed, known in closed form or recomputed of their critical speeds stands in one table, which the tests assert. Sets
//! that are called an example, or given by estimate, describe no machine that anyone has measured.
//!
//! [`WhippleMechanism`], [`WhippleTyres`], [`WhippleLeaning`], [`RollingDisc`], [`DoublePendulum`] and [`WheeledPendulum`] have
//! nonlinear equations of motion as well.
//!
//! [`Car`], [`Pendulum`], [`TwoPipes`] and [`ThreePipes`] are written as formulas, from the sources that they name.
//!
//! With feature `serde` the parameters of every model can be written and read as JSON, TOML and all that serde knows. What
//! is read must have all parameters and no others, an error names those that are too few or too many. Values are not
//! looked at then: `validate` tells which is outside its domain.
//!
//! [`BICYCLES`] are parameter sets for [`Whipple`] as text, with their sources and the standard deviations of what was
//! measured, and [`each_model!`] calls a function for every model. The example `embedding` simulates a bicycle without
//! allocating, and `falls` thousands of them, in lanes.

#![no_std]

mod bicycles;
mod models;

pub use bicycles::{BICYCLES, Bicycle};
pub use models::*;
