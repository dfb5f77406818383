//! The one place where numbers are read, whichever way they come: from files of every format, from `--set`, `--speeds`,
//! `--vary` and `--random`, and from the cells of a table of designs.
//!
//! | written | read as | |
//! | --- | --- | --- |
//! | `9.81`, `.5`, `+1`, `5e-1`, `5D-1` | numbers | `D` is Fortran's `e` |
//! | `−0.9` | -0.9 | the minus sign U+2212, as in typeset tables |
//! | `pi/10`, `2*(1 + 3)`, `2^-1`, `2**-1` | expressions | `^` and `**` bind as in formulas: `-2^2` is -4 |
//! | `atan(1/3)`, `math.sqrt(2)`, `np.deg2rad(27)` | functions | with or without `math.`, `np.`, `numpy.`; see [`function`] |
//! | `18 deg`, `18°` | 18 π/180 | within expressions too: `90 deg - atan(3)` |
//! | `1.02 m`, `1.02 [m]`, `102 cm`, `9.81 m/s/s` | in the unit of the parameter | see [`units`]; another quantity is refused |
//! | `2*I_Rxx` | the value of another parameter, or of any name of the file | see `input/scope.rs` |
//! | `0.08+/-0.001`, `0.08 ± 0.001`, `0.08+-0.001`, `0.08 + - 0.001` | a value and its standard deviation | |
//! | `(8.0+/-0.1)e-02`, `(85 +/- 5) kg` | the factor or unit belongs to both | as the Python package uncertainties prints |
//! | `1.020(3)`, `1.020(3)e-2`, `1.02(0.05)` | 1.020 ± 0.003, … | the deviation in units of the last digit |
//! | `1.02+/-0.01, 1.03+/-0.01` | their mean, 1.025 ± 0.00707 | as BicycleParameters does: sqrt(Σσ²)/n |
//!
//! What would be read in two ways is refused: `1,02` (a comma for decimals, or two values), `0.3-+0.1`, `2*(3+-1)` (a
//! sign after a sign), `27 +/- 1 deg` (degrees or radians).

mod expression;
mod function;
mod literal;
mod measured;
mod mistake;
mod range;
mod units;

pub use self::literal::TOO_SMALL;
pub use self::measured::{Measured, Part, measured};
pub use self::mistake::{Mistake, Reason};
pub use self::range::{Steps, check_units};

use self::expression::Parsed;

/// What the text of a value may refer to.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// The unit that the value has, as declared, such as `kg*m^2`; `1` for pure numbers.
    pub unit: &'a str,
    /// The values of names; `None` for one that is not known.
    pub names: &'a Lookup<'a>,
}

/// The value of a name, or what is wrong with it; `None` if it is not known.
pub type Lookup<'a> = dyn Fn(&str) -> Option<Result<f64, String>> + 'a;

/// For values that refer to nothing.
pub fn no_names(_: &str) -> Option<Result<f64, String>> {
    None
}

/// A value, and what else is known of its text.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Value {
    value: f64,
    /// Whether a unit other than the declared one makes it.
    is_converted: bool,
    /// Whether it depends on what a name stands for.
    refers: bool,
}

/// The value of a number or an expression without a standard deviation, in the declared unit.
///
/// # Errors
/// What is wrong, if it is none or is not finite.
pub fn number(text: &str, context: Context) -> Result<f64, Mistake> {
    match measured(text, context)? {
        Measured { mean, deviation: None } => Ok(mean.value),
        _ => Err(Mistake::of_value(text, Reason::Other("a standard deviation has no place here".to_owned()))),
    }
}

fn evaluate(text: &str, Context { unit, names }: Context) -> Result<Value, Reason> {
    let Parsed { value, in_degrees, refers, rest } = expression::parse(text, names)?;
    if in_degrees && unit != "rad" {
        return Err(Reason::Unit("deg".to_owned()));
    }
    let (value, is_converted) = if rest.is_empty() {
        (value, in_degrees)
    } else if starts_a_unit(rest) {
        let scale = units::scale(rest, unit).filter(|_| !in_degrees).ok_or_else(|| Reason::Unit(rest.to_owned()))?;
        (literal::kept(scale.apply(value), value != 0.0)?, !scale.is_one())
    } else {
        let found = rest.chars().next().unwrap_or_default();
        return Err(Reason::Other(format!("unexpected `{found}`")));
    };
    if value.is_finite() {
        Ok(Value { value, is_converted, refers })
    } else {
        Err(Reason::Other("the value is not finite".to_owned()))
    }
}

fn starts_a_unit(rest: &str) -> bool {
    rest.starts_with(|c: char| c.is_alphabetic() || c == '[' || c == '°') && {
        let word: String = rest.chars().take_while(|c| c.is_alphanumeric()).collect();
        word == "degrees" || (!["pi", "π"].contains(&word.as_str()) && function::of_one(&word).is_none())
    }
}

#[cfg(test)]
mod tests;
