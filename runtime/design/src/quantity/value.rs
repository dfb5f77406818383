//! A single value: an expression, and the unit that it is in.

use super::arithmetic::Arithmetic;
use super::context::{Context, Lookup};
use super::expression::{self, Parsed};
use super::mistake::Reason;
use super::{function, literal, units};

/// A value, and what else is known of its text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value<T = f64> {
    pub value: T,
    /// Whether a unit other than the declared one makes it.
    pub is_converted: bool,
    /// Whether it depends on what a name stands for.
    pub refers: bool,
}

/// The value of an expression and of the unit behind it, in the declared unit.
///
/// # Errors
/// What is wrong.
pub fn evaluate(text: &str, Context { unit, names }: Context) -> Result<Value, Reason> {
    evaluate_in(text, unit, names)
}

/// The same of numbers of any kind.
///
/// # Errors
/// What is wrong.
pub fn evaluate_in<T: Arithmetic>(text: &str, unit: &str, names: &Lookup<T>) -> Result<Value<T>, Reason> {
    if let Some((number, written)) = per_degree(text).filter(|_| unit != "rad") {
        let scale = units::scale(written, unit).ok_or_else(|| Reason::Unit(written.to_owned()))?;
        let Value { value, refers, .. } = evaluate_in(number, "1", names)?;
        return Ok(Value { value: scale.of(value), is_converted: true, refers });
    }
    let Parsed { value, in_degrees, refers, rest } = expression::parse(text, names)?;
    if in_degrees && unit != "rad" {
        return Err(Reason::Unit("deg".to_owned()));
    }
    let (value, is_converted) = if rest.is_empty() {
        (value, in_degrees)
    } else if starts_a_unit(rest) {
        let scale = units::scale(rest, unit).filter(|_| !in_degrees).ok_or_else(|| Reason::Unit(rest.to_owned()))?;
        let scaled = scale.of(value);
        literal::kept(scaled.value(), value.value() != 0.0)?;
        (scaled, !scale.is_one())
    } else {
        let found = rest.chars().next().unwrap_or_default();
        return Err(Reason::Other(format!("unexpected `{found}`")));
    };
    if value.value().is_finite() {
        Ok(Value { value, is_converted, refers })
    } else {
        Err(Reason::Other("the value is not finite".to_owned()))
    }
}

/// A number and its unit where that begins with degrees and goes on, as `30 deg/s`: within expressions degrees stand alone.
fn per_degree(text: &str) -> Option<(&str, &str)> {
    let (number, rest) = text.split_at(text.find("deg").or_else(|| text.find('°'))?);
    let is_unit = rest.contains('/') && units::in_si(rest, false).is_some();
    is_unit.then_some((number.trim_end().trim_end_matches('*'), rest))
}

/// Whether what follows a number and its standard deviation is a unit and nothing else, as far as degrees are concerned:
/// `deg` may stand within an expression.
pub fn is_unit_alone(rest: &str) -> bool {
    let behind = rest.strip_prefix('°').or_else(|| rest.strip_prefix("deg").filter(|rest| !rest.starts_with("ree")));
    starts_a_unit(rest) && behind.is_none_or(|behind| behind.trim().is_empty())
}

/// Whether what follows a number is meant for a unit.
pub fn starts_a_unit(rest: &str) -> bool {
    rest.starts_with(|c: char| c.is_alphabetic() || c == '[' || c == '°') && {
        let word: String = rest.chars().take_while(|c| c.is_alphanumeric()).collect();
        word == "degrees" || (!["pi", "π"].contains(&word.as_str()) && function::of_one(&word).is_none())
    }
}
