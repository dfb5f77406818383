//! The model compiler of Carvallo: from a declaration to Rust.
//!
//! ```text
//! tokens ─ syntax ─ check ─▶ Model ─▶ Equations ─ symbolic ─▶ Program ─ passes ─▶ Program ─ emit ─▶ tokens
//! ```
//!
//! Data flows one way, and each stage has its own type. [`expand`] runs all of it; the macro and the ahead-of-time
//! binary call it alike.

mod check;
mod emit;
mod equations;
#[cfg(feature = "files")]
pub mod files;
pub mod model;
pub mod program;
mod report;
pub mod symbolic;
mod syntax;

use proc_macro2::TokenStream;

pub use crate::emit::Driver;
pub use crate::equations::Equations;
use crate::model::Model;
use crate::program::Program;
use crate::report::Report;

/// A model and the programs that were compiled for it.
#[derive(Debug)]
pub struct Compiled {
    /// The checked model.
    pub model: Model,
    /// Computes the entries of the declared matrices, row by row.
    pub matrices: Program,
    /// Computes the left-hand sides of the requirements.
    pub requirements: Program,
}

/// Compiles a declaration.
///
/// # Errors
/// All mistakes of the declaration, each at its span; or the failure of the symbolic engine at the model's name.
pub fn compile(declaration: TokenStream) -> syn::Result<Compiled> {
    let mut report = Report::default();
    let model = syntax::parse(declaration, &mut report).map(|declaration| check::check(declaration, &mut report));
    report.finish()?;
    let Some(model) = model else { unreachable!("a declaration without a model is reported") };

    let equations = vec![Equations::of_matrices(&model), Equations::of_requirements(&model)];
    let programs = symbolic::compile(equations).map_err(|failure| report::error(&model.name, failure))?;
    let [matrices, requirements] = programs.try_into().unwrap_or_else(|_| unreachable!("a program for each"));
    Ok(Compiled { model, matrices, requirements })
}

/// Compiles a declaration to Rust.
///
/// # Errors
/// As [`compile`].
pub fn expand(declaration: TokenStream, driver: Driver) -> syn::Result<TokenStream> {
    let Compiled { model, matrices, requirements } = compile(declaration)?;
    Ok(emit::emit(&model, &matrices, &requirements, driver))
}
