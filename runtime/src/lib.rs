//! Models of linearized mechanics, and what is done with them: matrices, eigenvalues, and the speeds at which a machine is
//! stable.
//!
//! A model gives the coefficient matrices of the linearized equations of motion about straight running,
//!
//! ```text
//! M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f
//! ```
//!
//! with the forward speed v in m/s and the gravitational field strength g in N/kg taken out (Meijaard, Papadopoulos,
//! Ruina & Schwab 2007, eq. 5.3).
//!
//! # Where to begin
//!
//! - The [guide] explains page by page, with examples that run: models [from formulas](guide::formulas) and
//!   [from bodies, joints and wheels](guide::mechanisms), how the compiler [looks for mistakes](guide::safeguards),
//!   [stability](guide::stability), [code for any model](guide::any_model), [batches](guide::batches),
//!   [sensitivities](guide::sensitivities), and the [generated code](guide::generated_code) without a compiler.
//! - [`model!`] documents the syntax of a declaration.
//! - The crate `carvallo-models` has finished models with their code, the Whipple-Carvallo bicycle and others, and the
//!   parameters of measured bicycles; `carvallo-cli` is the command line.
//!
//! # What is in this crate
//!
//! The trait that every model implements ([`Model`]), the matrices ([`Coefficients`]), and the names, units and domains that
//! a model carries with it ([`ModelInfo`]). A model that was compiled with its derivatives gives those as well
//! ([`Differentiable`]).
//!
//! A mechanism that was compiled with its nonlinear equations moves by them: accelerations, contact forces, energy
//! ([`Motion`]).
//!
//! At one speed and gravity the matrices make a [`System`], with its [state-space form](StateSpace), its eigenvalues and their
//! [eigenvectors](Eigenvectors).
//! Many designs at once run in the lanes of the processor ([`batch`]).
//!
//! Along speed, models have their critical speeds and stable ranges ([`Stability`]), and eigenvalues that are followed one by
//! one ([`Branches`]); bicycles with two coordinates have the names of all their modes ([`Modes`]).
//!
//! How all of them change with the parameters, for models that were compiled with their derivatives or with derivatives of
//! your own, and what measured standard deviations make of them, tells [`Sensitivity`].
//!
//! Without feature `std` there is all of this that does not allocate: the matrices, the state-space form, the
//! [four eigenvalues](System::quartic_eigenvalues) of two coordinates, and their critical speeds where these are
//! [certain](CertainStability). The guide, and this page with all its links, are documented with the features `derive`, `std`
//! and `batch`.

#![cfg_attr(not(feature = "std"), no_std)]
// docs.rs says of each item which feature it is for.
#![cfg_attr(docsrs, feature(doc_cfg))]
// What a feature adds can be linked only where it is there.
#![cfg_attr(
    not(all(feature = "derive", feature = "std", feature = "batch", feature = "turns")),
    allow(rustdoc::broken_intra_doc_links)
)]

#[cfg(feature = "batch")]
pub mod batch;
mod characteristic;
mod eigenvalues;
#[cfg(all(any(doc, doctest), feature = "derive", feature = "std", feature = "batch"))]
pub mod guide;
mod model;
pub mod motion;
#[cfg(feature = "std")]
mod notation;
mod number;
mod numeric;
#[cfg(feature = "std")]
mod pencil;
#[cfg(feature = "std")]
mod sensitivity;
#[cfg(feature = "std")]
pub mod simulation;
mod stability;
mod system;
#[cfg(feature = "turns")]
pub mod turns;

#[cfg(feature = "std")]
pub use eigenvalues::{Eigenvectors, matrix_eigenvalues};
pub use model::{
    Bound, CoordinateInfo, Differentiable, Domain, EntryInfo, Evaluator, EvaluatorWithDerivatives, FormulaInfo,
    FormulaSubject, LengthError, Model, ModelInfo, MotionFormulas, Nonlinear, ParameterError, ParameterInfo, Partial,
    Rate, RequirementInfo, SetInfo, WithDerivatives, write_now,
};
pub use motion::{Linearizable, Motion, MotionError};
/// The library of matrices, in the version that has the types of this crate.
pub use nalgebra;
pub use nalgebra::Complex;
#[cfg(feature = "std")]
pub use notation::{Expression, Formula, FormulaNumber, Function, Notation};
pub use number::{Number, Scalar, to_f32};
#[cfg(feature = "std")]
pub use numeric::sort_by;
#[cfg(feature = "std")]
pub use sensitivity::{
    Covariance, CriticalDerivative, EigenvalueDerivative, EigenvalueSensitivity, Gradient, NotDifferentiable,
    Sensitivity, SensitivityError, Sources, Uncertain, standard_deviation, variance_shares,
};
#[cfg(feature = "std")]
pub use stability::{
    Branches, CriticalValue, MarginalRange, Meeting, ModeValue, Modes, ParameterRange, ParameterStability,
    ParameterStabilityError, Stability, UndecidedRange,
};
pub use stability::{CertainStability, Change, CriticalKind, CriticalSpeed, Mode, StableRange, Verdict};
pub use system::{Coefficients, Matrix, MatrixName, Rows, StateSpace, States, System, SystemError, rows};

/// The other half of [`model!`].
#[cfg(feature = "derive")]
#[doc(hidden)]
pub use carvallo_derive::model as __model;
