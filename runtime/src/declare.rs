//! The macro that declares models.

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
///         m: kg, > 0;                       // or `>=`, `<`, `<=`; without a domain any finite value
///         g: N/kg, >= 0, gravity;           // the field strength that K0 is multiplied by
///         I: kg*m^2, >= 0, unused;          // no matrix depends on it
///     }
///
///     let a = m*sin(lam)^2;                 // + - * / ^, parentheses, sin, cos, tan, sqrt, pi
///     require a + m > 0;                    // a condition on several parameters
///
///     coordinates {
///         phi "lean": rad;
///     }
///
///     M = [[a]];                            // and C0, C1, Kc, K0, K2: those left out are zero
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
/// # What it makes
/// - A struct `Name<T = f64>` with the parameters as public fields, for `f32` and `f64`; `Name::EXAMPLE` for each
///   parameter set; `from_array`, `to_array`, `cast`.
/// - A struct `NameMatrices<T>` with the declared matrices as arrays of rows, and `Name::matrices`, which computes them
///   in one straight-line function whose documentation states its operation counts.
/// - [`Model<N>`](crate::Model) for `Name<T>`: names, units, domains, validation, conversion from and to slices, and the
///   matrices as [`Coefficients`](crate::Coefficients).
///
/// The code needs no `std`, allocates nothing and has no `unsafe`.
///
/// # Errors
/// All mistakes of a declaration are reported at once, each where it is, with what was expected.
#[macro_export]
macro_rules! model {
    ($($declaration:tt)*) => {
        $crate::__model! { ($crate) $($declaration)* }
    };
}
