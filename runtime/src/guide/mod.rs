//! The guide: what Carvallo can do, page by page, with examples that run.
//!
//! What equations a machine can have stands in [`form`]. Who declares models begins with [`formulas`] or [`mechanisms`], whose syntax [`model!`](crate::model)
//! documents to the last word, and reads in [`safeguards`] how the compiler looks for mistakes. [`stability`], [`batches`]
//! and [`sensitivities`] are about what is done with a model, and [`any_model`] about functions of your own that take every
//! model. [`motions`] lead from a mechanism to a simulation, with a controller in it. Who wants the evaluators of a finished model, in a simulation
//! or on a microcontroller, needs [`generated_code`] alone, with [`microcontroller`] for what it takes there, or [`c`] for C and C++, and who has code by hand, or of another generator, finds in
//! [`comparing`] how to hold one against the other. What [`symbolica`] asks of those who compile models has a page, too.
//!
//! The folder `examples` of this crate has small programs that print their results with units:
//!
//! | example | what it shows |
//! | --- | --- |
//! | `pendulum` | a model from formulas, its eigenvalues, and what is refused |
//! | `coin` | a mechanism of one wheel, its critical speed, and the rates that follow |
//! | `speeds` | a sweep along speed of one's own, for three coordinates |
//! | `batch` | ten thousand bicycles in the lanes of the processor |
//! | `sensitivity` | what each parameter does to the speed from which a bicycle is stable |
//! | `comparing` | generated code beside code by hand |
//!
//! They declare models, so they need the feature `derive`: `cargo run -p carvallo --features derive --example coin`. The
//! examples of the crate `carvallo-models` need none: `cargo run -p carvallo-models --example embedding`, `riding`, a simulator
//! of nonlinear equations that allocates nothing, and `falls`, a Monte Carlo study in lanes.
//!
//! # Features of this crate
//!
//! | feature | what it adds |
//! | --- | --- |
//! | `std` (default) | everything that allocates: stability along speed, modes, sensitivities, eigenvalues of any number of coordinates |
//! | `batch` (default) | many designs in the lanes of the processor |
//! | `approx` | coefficients, systems and state spaces in `assert_relative_eq!` and the like of the crate `approx` |
//! | `rayon` | batches by all cores |
//! | `serde` | coefficient matrices, systems, critical speeds, ranges, verdicts and modes to and from JSON and the like, as the command line writes them |
//! | `simulation` | nonlinear motions in time |
//! | `derive` | the macro `model!`, which builds Symbolica |

// The pages name items of the crate.
#[allow(unused_imports)]
use crate::{batch::*, *};

#[doc = include_str!("form.md")]
pub mod form {}
#[doc = include_str!("formulas.md")]
pub mod formulas {}
#[doc = include_str!("mechanisms.md")]
pub mod mechanisms {}
#[doc = include_str!("safeguards.md")]
pub mod safeguards {}
#[doc = include_str!("stability.md")]
pub mod stability {}
#[doc = include_str!("any_model.md")]
pub mod any_model {}
#[doc = include_str!("batches.md")]
pub mod batches {}
#[doc = include_str!("sensitivities.md")]
pub mod sensitivities {}
#[cfg(feature = "simulation")]
#[doc = include_str!("motions.md")]
pub mod motions {}
#[doc = include_str!("generated_code.md")]
pub mod generated_code {}
#[doc = include_str!("c.md")]
pub mod c {}
#[doc = include_str!("microcontroller.md")]
pub mod microcontroller {}
#[doc = include_str!("comparing.md")]
pub mod comparing {}
#[doc = include_str!("symbolica.md")]
pub mod symbolica {}
