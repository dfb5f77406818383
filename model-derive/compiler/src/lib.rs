//! The model compiler of Carvallo: from a declaration to Rust.
//!
//! ```text
//! tokens ─ syntax ─ check ─▶ Model ─▶ Equations ─ symbolic ─▶ Program ─ passes ─▶ Program ─ emit ─▶ tokens
//!                     │ ▲
//!                 mechanics
//! ```
//!
//! A mechanism becomes definitions and matrices in `check`, by what `mechanics` derives: from there on it is a model like
//! one whose formulas are written, and held against the same evidence.
//!
//! Data flows one way, and each stage has its own type. What a declaration claims of itself is proved in `check`, which
//! asks the symbolic engine and is told what it found. [`expand`] runs all of it for the ahead-of-time binary, and
//! [`declare`] for the macro.

mod check;
pub mod derivatives;
mod emit;
mod equations;
#[cfg(feature = "files")]
pub mod files;
pub mod formula;
pub mod kinematics;
mod matrix_name;
mod mechanics;
pub mod model;
mod nearest;
pub mod program;
mod report;
pub mod symbolic;
mod syntax;

use proc_macro2::{Span, TokenStream, TokenTree};

use crate::derivatives::Derivatives;
pub use crate::emit::Driver;
pub use crate::equations::Equations;
use crate::model::Model;
use crate::program::Program;
use crate::report::{Region, Report};

/// A model and the programs that were compiled for it.
#[derive(Debug)]
pub struct Compiled {
    /// The checked model.
    pub model: Model,
    /// What it computes.
    pub programs: Programs,
}

/// The programs of a model.
#[derive(Debug)]
pub struct Programs {
    /// Computes the entries of the matrices, row by row.
    pub matrices: Program,
    /// Computes the left-hand sides of the requirements.
    pub requirements: Program,
    /// Computes the rates and forces that follow from a mechanism, if the model is one.
    pub kinematics: Option<Program>,
    /// Computes the entries of the matrices together with their derivatives, if the model asks for them.
    pub derivatives: Option<Derivatives>,
}

/// Checks a declaration, and makes no programs of it.
///
/// # Errors
/// All mistakes of the declaration, each at its span.
pub fn check(declaration: TokenStream) -> syn::Result<Model> {
    read(declaration).map_err(|(error, _)| error)
}

/// As [`check`], but beside the error there is what is known of the model.
fn read(declaration: TokenStream) -> Result<Model, (syn::Error, Option<Box<Model>>)> {
    let mut report = Report::default();
    let model = syntax::parse(declaration, &mut report).map(|declaration| check::check(declaration, &mut report));
    match (report.finish(), model) {
        (Ok(()), Some(model)) => Ok(model),
        (Ok(()), None) => unreachable!("a declaration without a model is reported"),
        (Err(error), model) => Err((error, model.map(Box::new))),
    }
}

/// Compiles a declaration.
///
/// # Errors
/// As [`check`]; or the failure of the symbolic engine, at the formula without a value or at the model's name.
pub fn compile(declaration: TokenStream) -> syn::Result<Compiled> {
    compile_or_model(declaration).map_err(|(error, _)| error)
}

/// As [`compile`], but beside the error there is what is known of the model.
fn compile_or_model(declaration: TokenStream) -> Result<Compiled, (syn::Error, Option<Box<Model>>)> {
    let model = read(declaration)?;
    let equations = [Equations::of_matrices(&model), Equations::of_requirements(&model)].into_iter();
    match symbolic::compile(equations.chain(Equations::of_kinematics(&model)).collect()) {
        Ok(programs) => {
            let mut programs = programs.into_iter();
            let mut next = || programs.next().unwrap_or_else(|| unreachable!("a program for each"));
            let (matrices, requirements) = (next(), next());
            let kinematics = programs.next();
            let derivatives = model.derivatives.map(|span| (span, derivatives::compile(&model, &matrices)));
            let derivatives = match derivatives {
                Some((span, Err(failure))) => return Err((report::error(span, failure), Some(Box::new(model)))),
                Some((_, Ok(derivatives))) => Some(derivatives),
                None => None,
            };
            Ok(Compiled { model, programs: Programs { matrices, requirements, kinematics, derivatives } })
        }
        Err(failure) => Err((report::error(region(&model, &failure), failure), Some(Box::new(model)))),
    }
}

/// Where in the declaration a failure belongs.
fn region(model: &Model, failure: &symbolic::Failure) -> Region {
    use symbolic::{Failure, Place};
    match *failure {
        Failure::Undefined { place: Place::Definition(index), .. } => Region::from(&model.definitions[index].0),
        Failure::Undefined { equations: 0, place: Place::Output(index), .. } => model.entries[index],
        Failure::Undefined { equations: 1, place: Place::Output(index), .. } => model.requirements[index].region,
        Failure::Undefined { place: Place::Output(_), .. } => Region::from(&model.name),
        Failure::Engine(_) => Region::from(&model.name),
    }
}

/// Compiles a declaration to Rust.
///
/// # Errors
/// As [`compile`].
pub fn expand(declaration: TokenStream, driver: &Driver) -> syn::Result<TokenStream> {
    Ok(emit::emit(&compile(declaration)?, driver))
}

/// What the macro leaves in the place of a declaration, before which stands in parentheses the path of the runtime:
/// its Rust, or its mistakes, and beside them the types that the rest of the file uses.
pub fn declare(input: TokenStream) -> TokenStream {
    let mut tokens = input.into_iter();
    let Some(TokenTree::Group(runtime)) = tokens.next() else {
        return report::error(Span::call_site(), "expected a call by `carvallo::model!`").into_compile_error();
    };
    let driver = Driver::Macro { runtime: runtime.stream() };
    match compile_or_model(tokens.collect()) {
        Ok(compiled) => emit::emit(&compiled, &driver),
        Err((error, model)) => {
            let outline = model.map(|model| emit::outline(*model, &driver));
            error.into_compile_error().into_iter().chain(outline.into_iter().flatten()).collect()
        }
    }
}
