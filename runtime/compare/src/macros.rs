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
    ($($model:ident)::+, $hand:path) => {
        $crate::compare!($($model)::+, $hand: f64).single($hand).counted($hand)
    };
    ($($model:ident)::+, $hand:path: f64) => {
        $crate::Comparison::<$($model)::+, _>::of($($model)::+::matrices)
            .single($($model)::+::matrices)
            .counted($($model)::+::matrices)
            .against(::core::stringify!($hand), $hand)
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
/// The test is `by_hand::gives_the_generated_matrices`: its module bears the name of the function. Where there is such a module
/// already, or for a path, it has a name before it: `test!(coin_by_hand: Coin, hand::by_hand)`. That is what the statement
/// `compare hand::by_hand;` of a declaration makes. Model and function must be in scope where it stands.
#[macro_export]
macro_rules! test {
    ($name:ident: $model:ident, $hand:path: f64 $(, $limits:expr)?) => {
        $crate::__test!($name, $model, ($hand: f64), $crate::__test!(@limits $($limits)?));
    };
    ($name:ident: $model:ident, $hand:path $(, $limits:expr)?) => {
        $crate::__test!($name, $model, ($hand), $crate::__test!(@limits $($limits)?));
    };
    ($model:ident, $hand:ident: f64 $(, $limits:expr)?) => {
        $crate::__test!($hand, $model, ($hand: f64), $crate::__test!(@limits $($limits)?));
    };
    ($model:ident, $hand:ident $(, $limits:expr)?) => {
        $crate::__test!($hand, $model, ($hand), $crate::__test!(@limits $($limits)?));
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! __test {
    (@limits) => { $crate::Limits::default() };
    (@limits $limits:expr) => { $limits };
    ($name:ident, $model:ident, ($($hand:tt)+), $limits:expr) => {
        #[cfg(test)]
        mod $name {
            #[allow(unused_imports)]
            use super::*;

            #[test]
            fn gives_the_generated_matrices() {
                match $crate::compare!($model, $($hand)+).report() {
                    Ok(report) => report.assert($limits),
                    Err(error) => ::core::panic!("{error}"),
                }
            }
        }
    };
}
