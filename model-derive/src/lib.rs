//! The macro `model!` of Carvallo: a model, declared once, becomes a struct and its evaluators.
//!
//! Users reach it as `carvallo::model!`, through the feature `derive` of the crate `carvallo`. The compiler itself is
//! the crate `carvallo-compiler`, since a crate with macros can export nothing else.

use proc_macro::TokenStream;

/// Declares a model by its parameters and formulas, and compiles it.
///
/// ```text
/// /// Documentation of the model.
/// pub model Name {
///     source "where the formulas come from";
///
///     parameters {
///         /// Documentation, then: name, symbol, unit, domain.
///         lam "λ": rad, in (-pi/2, pi/2);   // an open interval; `in [a, b]` includes its ends
///         m: kg, > 0;                       // or `>=`, `<`, `<=`, `!= 0`; without a domain any finite value
///         g: N/kg, >= 0, gravity;           // the field strength that K0 is multiplied by
///         I: kg*m^2, >= 0, unused;          // no matrix depends on it
///     }
///
///     let a = m*sin(lam)^2;                 // + - * / ^, parentheses, sin, cos, tan, sqrt, pi
///     require a + m > 0;                    // a condition on several parameters; `!= 0` is one too
///     assert a == m*(1 - cos(2*lam))/2;     // a claim, to be proved
///
///     coordinates {
///         phi "lean": rad;
///     }
///
///     symmetric M = [[a]];                  // and C0, C1, Kc, K0, K2: those left out are zero
///
///     set example "where the values come from" {
///         lam = pi/10; m = 2; g = 9.81; I = 0;
///     }
/// }
/// ```
///
/// The matrices are those of `M q'' + (C0 + v C1) q' + (Kc + g K0 + v^2 K2) q = f`, with a row and a column for each
/// coordinate. Numbers are decimal and taken exactly: `0.5` is one half.
///
/// # What it proves
/// `symmetric` before a matrix claims that each entry equals its mirror image; `assert` claims that two formulas of
/// parameters and definitions are equal. Claims are proved exactly, for all parameters, under the rules of fractions,
/// roots, sin² + cos² = 1 and the addition theorems. One that is wrong is an error with values for which it is, inside
/// the domains and requirements; so is one that can be neither proved nor refuted. Claims make no code, and what only
/// they mention is not used.
///
/// Everything that a formula divides by, the cosine in a tangent, and everything under a root is bounded over the
/// declared domains. What they and the requirements do not keep from zero, or a root's argument from being negative,
/// becomes a requirement of its own: `validate` refuses it and names it, and so does the documentation of
/// `Name::matrices`. A `require` on the expression, or on a multiple of it, says it in your words.
///
/// # What it makes
/// - A struct `Name<T = f64>` with the parameters as public fields, for `f32` and `f64`; `Name::EXAMPLE` for each
///   parameter set; `from_array`, `to_array`, `cast`.
/// - A struct `NameMatrices<T>` with the declared matrices as arrays of rows, and `Name::matrices`, which computes them
///   in one straight-line function whose documentation states its operation counts.
/// - `carvallo::Model<N>` for `Name<T>`: names, units, domains, validation, conversion from and to slices, and the
///   matrices as `carvallo::Coefficients`.
///
/// The code needs no `std`, allocates nothing and has no `unsafe`.
///
/// # Errors
/// All mistakes of a declaration are reported at once, each where it is, with what was expected.
#[proc_macro]
pub fn model(declaration: TokenStream) -> TokenStream {
    carvallo_compiler::expand(declaration.into(), carvallo_compiler::Driver::Macro)
        .unwrap_or_else(syn::Error::into_compile_error)
        .into()
}
