//! The macros.

/// The [`Comparison`](crate::Comparison) of a model with a function by hand.
///
/// ```
/// use carvallo::{Number, Rows};
/// use carvallo_compare::{Limits, compare};
/// use carvallo_models::{Pendulum, PendulumMatrices};
///
/// /// Over any number, so that it is counted and computed in `f32` as well.
/// fn by_hand<T: Number>(p: &Pendulum<T>) -> PendulumMatrices<T> {
///     let Pendulum { m, l, c, .. } = *p;
///     PendulumMatrices { m: Rows([[m * l * l]]), c0: Rows([[c]]), k0: Rows([[m * l]]) }
/// }
///
/// let report = compare!(Pendulum, by_hand).report()?;
/// report.assert(Limits { ulps: 2.0, operations_by_hand: Some(1.0), ..Limits::default() });
/// # Ok::<(), carvallo::ParameterError>(())
/// ```
///
/// A function in `f64` alone is `compare!(Pendulum, by_hand: f64)`; its operations are not counted then. It may give anything
/// that makes `Coefficients`: the matrices of the model, or those themselves.
#[macro_export]
macro_rules! compare {
    ($($model:ident)::+, $($hand:ident)::+) => {
        $crate::compare!($($model)::+, $($hand)::+: f64)
            .single($($hand)::+)
            .counted($($hand)::+)
    };
    ($($model:ident)::+, $($hand:ident)::+: f64) => {
        $crate::Comparison::<$($model)::+, _>::of($($model)::+::matrices)
            .single($($model)::+::matrices)
            .counted($($model)::+::matrices)
            .against(::core::stringify!($($hand)::+), $($hand)::+)
    };
}

/// A test that a function by hand gives the matrices of a model: fewer than 16 units in the last place from exact arithmetic,
/// both it and the generated code, or within [`Limits`](crate::Limits) of your own.
///
/// ```
/// # use carvallo::{Coefficients, Number, Rows};
/// # use carvallo_models::{Pendulum, PendulumMatrices};
/// # fn by_hand<T: Number>(p: &Pendulum<T>) -> PendulumMatrices<T> {
/// #     p.matrices()
/// # }
/// # fn in_double(p: &Pendulum) -> Coefficients<f64, 1> {
/// #     carvallo::Model::coefficients(p)
/// # }
/// carvallo_compare::test!(Pendulum, by_hand);
/// carvallo_compare::test!(Pendulum, in_double: f64, carvallo_compare::Limits { ulps: 2.0, ..Default::default() });
/// ```
///
/// The test is `by_hand::gives_the_generated_matrices`: the module bears the name of the function, which must be in scope.
#[macro_export]
macro_rules! test {
    ($model:ident, $hand:ident $(: $scalar:ident)?) => {
        $crate::test!($model, $hand $(: $scalar)?, $crate::Limits::default());
    };
    ($model:ident, $hand:ident $(: $scalar:ident)?, $limits:expr) => {
        #[cfg(test)]
        mod $hand {
            #[allow(unused_imports)]
            use super::*;

            #[test]
            fn gives_the_generated_matrices() {
                match $crate::compare!($model, $hand $(: $scalar)?).report() {
                    Ok(report) => report.assert($limits),
                    Err(error) => ::core::panic!("{error}"),
                }
            }
        }
    };
}
