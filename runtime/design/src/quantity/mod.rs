//! The one place where numbers are read, whichever way they come: from files of every format, from `--set`, `--speeds`,
//! `--vary` and `--random`, and from the cells of a table of designs.
//!
//! | written | read as | |
//! | --- | --- | --- |
//! | `9.81`, `.5`, `+1`, `5e-1`, `5D-1` | numbers | `D` is Fortran's `e` |
//! | `−0.9` | -0.9 | the minus sign U+2212, as in typeset tables |
//! | `pi/10`, `2*(1 + 3)`, `2^-1`, `2**-1` | expressions | `^` and `**` bind as in formulas: `-2^2` is -4 |
//! | `atan(1/3)`, `math.sqrt(2)`, `np.deg2rad(27)` | functions | with or without `math.`, `np.`, `numpy.`; see `function.rs` |
//! | `18 deg`, `18°` | 18 π/180 | within expressions too: `90 deg - atan(3)` |
//! | `1/2 deg`, `90-72 deg` | 0.5°, 18° | a unit belongs to the whole of what stands before it |
//! | `1.02 m`, `1.02 [m]`, `102 cm`, `9.81 m/s/s` | in the unit of the parameter | see `units.rs`; another quantity is refused |
//! | `2*I_Rxx` | the value of another parameter, or of any name of the file | see `input/scope.rs` |
//! | `0.08+/-0.001`, `0.08 ± 0.001`, `0.08+-0.001`, `0.08 + - 0.001` | a value and its standard deviation | |
//! | `(8.0+/-0.1)e-02`, `(85 +/- 5) kg` | the factor or unit belongs to both | as the Python package uncertainties prints |
//! | `1.020(3)`, `1.020(3)e-2`, `1.02(0.05)` | 1.020 ± 0.003, … | the deviation in units of the last digit |
//! | `1.02+/-0.01, 1.03+/-0.01` | their mean, 1.025 ± 0.00707 | as BicycleParameters does: sqrt(Σσ²)/n |
//!
//! What would be read in two ways is refused: `1,02` (a comma for decimals, or two values), `0.3-+0.1`, `2*(3+-1)` (a
//! sign after a sign), `27 +/- 1 deg` and `18.5 deg - 0.5` (degrees or radians); and in a table in which decimals stand
//! behind points and behind commas, `1.000` and `1,000` (one or a thousand).

mod arithmetic;
mod context;
mod decimals;
pub(crate) mod expression;
pub(crate) mod function;
#[cfg(feature = "full")]
mod heading;
pub(crate) mod literal;
mod measured;
mod mistake;
mod range;
pub(crate) mod units;
mod value;

pub use self::context::{Context, Lookup, no_names};
pub use self::decimals::{ambiguous, signs};
#[cfg(feature = "full")]
pub use self::heading::{headed, is_unit};
pub use self::literal::TOO_SMALL;
pub use self::measured::{Measured, Part, check_parts, has_deviation, measured, number, unquoted};
pub use self::mistake::{Mistake, Reason};
pub use self::range::{Steps, check_commas, check_units};
#[cfg(feature = "full")]
pub use self::units::{Scale, scale};
pub use self::value::is_unit_alone;

use crate::dual::Dual;

/// The value of an expression in the declared unit, with its derivative, by those of the names.
///
/// # Errors
/// What is wrong.
pub fn differentiated(text: &str, unit: &str, names: &Lookup<Dual>) -> Result<Dual, Reason> {
    // Typeset tables have a minus sign of their own.
    value::evaluate_in(text.replace('−', "-").trim(), unit, names).map(|found| found.value)
}

#[cfg(test)]
mod tests;
