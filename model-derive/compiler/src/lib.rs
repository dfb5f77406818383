//! The model compiler of Carvallo: from a declaration to Rust.
//!
//! Data flows one way, and each stage has its own type; their order stands in `pipeline.rs`, and `model-derive/README.md`
//! draws it and says what to touch for what. [`expand`] runs all of it for the ahead-of-time binary, and [`declare`] for the
//! macro. What is public beside these serves the tests.

mod check;
mod constant;
mod derivation;
mod derivatives;
mod domain;
mod emit;
mod equations;
mod evidence;
#[cfg(feature = "files")]
pub mod files;
pub mod formula;
mod free_name;
mod kinematics;
mod matrix_name;
mod mechanics;
pub mod model;
pub mod motion;
mod nearest;
mod neighbours;
pub mod nonlinear;
mod pipeline;
pub mod program;
mod random;
mod report;
mod spread;
mod states;
pub mod symbolic;
mod syntax;
mod written;

use proc_macro2::{Span, TokenStream, TokenTree};

pub use crate::emit::Driver;
pub use crate::equations::Equations;
use crate::model::Model;
use crate::pipeline::Refusal;
pub use crate::pipeline::{Compiled, Programs};
pub use crate::states::States;
pub use crate::symbolic::{Kept, with_answers};

/// Checks a declaration, and makes no programs of it.
///
/// # Errors
/// All mistakes of the declaration, each at its span.
pub fn check(declaration: TokenStream) -> syn::Result<Model> {
    pipeline::read(declaration).map_err(|refusal| refusal.error)
}

/// Compiles a declaration.
///
/// # Errors
/// As [`check`]; or the failure of the symbolic engine, at the formula without a value or at the model's name.
pub fn compile(declaration: TokenStream) -> syn::Result<Compiled> {
    pipeline::compile(declaration).map_err(|refusal| refusal.error)
}

/// Compiles a declaration to Rust.
///
/// # Errors
/// As [`compile`].
pub fn expand(declaration: TokenStream, driver: &Driver) -> syn::Result<TokenStream> {
    Ok(emit::emit(&compile(declaration)?, driver))
}

/// What the macro leaves in the place of a declaration, before which stands in parentheses the path of the runtime:
/// its Rust, or its mistakes, and beside them the types that the rest of the file uses. What the engine finds is kept for
/// the next build.
pub fn declare(input: TokenStream) -> TokenStream {
    let mut tokens = input.into_iter();
    let Some(TokenTree::Group(runtime)) = tokens.next() else {
        return report::error(Span::call_site(), "expected a call by `carvallo::model!`").into_compile_error();
    };
    let driver = Driver::Macro { runtime: runtime.stream() };
    let compiled = with_answers(Kept::of_this_build(), || pipeline::compile(tokens.collect()));
    let model = match &compiled {
        Ok(compiled) => Some(&compiled.model),
        Err(refusal) => refusal.model.as_deref(),
    };
    // Of what is defined twice every implementation would be an error of its own.
    if let Some((model, clash)) = model.and_then(|model| Some((model, neighbours::find_clash(model)?))) {
        let mut error = report::error(&model.name, clash);
        compiled.err().into_iter().for_each(|refusal| error.combine(refusal.error));
        return error.into_compile_error();
    }
    match compiled {
        Ok(compiled) => emit::emit(&compiled, &driver),
        Err(Refusal { error, model }) => {
            let outline = model.map(|model| emit::outline(*model, &driver));
            // Editors take the first of what stands at a place, and mistakes stand where names are completed.
            outline.into_iter().flatten().chain(error.into_compile_error()).collect()
        }
    }
}
