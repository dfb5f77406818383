//! The macro `model!` of Carvallo: a model, declared once, becomes a struct and its evaluators.
//!
//! Users reach it through `carvallo::model!`, which the crate `carvallo` has with its feature `derive`, and which
//! documents the syntax. The compiler itself is the crate `carvallo-compiler`, since a crate with macros can export
//! nothing else.

use proc_macro::TokenStream;

/// What `carvallo::model!` hands its declaration to, behind the path of its crate in parentheses.
#[proc_macro]
pub fn model(input: TokenStream) -> TokenStream {
    carvallo_compiler::declare(input.into()).into()
}
