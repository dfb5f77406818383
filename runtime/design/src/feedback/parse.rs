//! The right side of a law, as a sum of terms. Numbers, functions and units are those of all values.

use std::f64::consts::PI;

use super::terms::{self, Motion, Sum, Term};
use crate::quantity::{expression, function, literal, units};

/// Deeper nesting than this is refused, so that no input can exhaust the stack.
const MAX_DEPTH: usize = 64;

/// No power beyond this is in any equation.
const MAX_POWER: f64 = 8.0;

/// Nor so many terms, and powers on the way to what is left of them.
const MAX_TERMS: usize = 512;
const MAX_POWERS: i32 = 64;

const OTHER_QUANTITIES: &str = "quantities of different units are added";

/// What a name stands for in a law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Symbol {
    Speed,
    Motion(Motion),
}

/// What a name stands for, or why it stands for nothing.
pub type Names<'a> = dyn Fn(&str) -> Result<Symbol, String> + 'a;

/// Pounds and ounces are of mass, or of force.
///
/// # Errors
/// What is wrong.
pub fn parse(text: &str, of_force: bool, names: &Names) -> Result<Sum, String> {
    // Typeset texts have a minus sign of their own.
    let text = text.replace('−', "-");
    let mut parser = Parser { rest: text.trim_start(), depth: 0, of_force, names };
    let sum = parser.sum()?;
    match parser.rest.chars().next() {
        None => Ok(sum),
        Some(found) if found.is_alphanumeric() || found == '(' => {
            let word = parser.word();
            let found = if word.is_empty() { found.to_string() } else { word.to_owned() };
            Err(format!("expected a sign such as `*` before `{found}`"))
        }
        Some(found) => Err(format!("unexpected `{found}`")),
    }
}

struct Parser<'a, 'n> {
    rest: &'a str,
    depth: usize,
    of_force: bool,
    names: &'n Names<'n>,
}

impl<'a> Parser<'a, '_> {
    fn sum(&mut self) -> Result<Sum, String> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err("nested too deeply".to_owned());
        }
        let mut sum = self.product()?;
        loop {
            let sign = if self.take("+") {
                1.0
            } else if self.take("-") {
                -1.0
            } else {
                self.depth -= 1;
                return Ok(sum);
            };
            for term in self.product()? {
                terms::add(&mut sum, Term { value: sign * term.value, ..term }).map_err(|()| OTHER_QUANTITIES)?;
            }
        }
    }

    fn product(&mut self) -> Result<Sum, String> {
        let mut product = self.signed()?;
        loop {
            let factor = if ["*", "·", "⋅", "×"].iter().any(|sign| self.take(sign)) {
                self.signed()?
            } else if self.take("/") {
                let is_number = self.rest.starts_with(|c: char| c.is_ascii_digit() || c == '.');
                let divisor = self.signed()?;
                if is_number && matches!(divisor[..], [term] if term.has_unit) {
                    return Err(
                        "a unit behind a divisor could belong to the whole quotient: expected parentheses".to_owned()
                    );
                }
                let divides = "expected a number or a power of `v` behind `/`, such as `phi_rate/v`";
                terms::inverse(&divisor).ok_or(divides)?
            } else {
                return Ok(product);
            };
            let multiplied = terms::times(&product, &factor)
                .ok_or("it is not linear: expected a sum of positions and rates, each times numbers and powers of `v`")?
                .map_err(|()| OTHER_QUANTITIES)?;
            product = bounded(multiplied)?;
        }
    }

    /// Binds weaker than `^`, so that `-2^2` is -4 as in formulas.
    fn signed(&mut self) -> Result<Sum, String> {
        let sign = if self.take("-") {
            -1.0
        } else {
            self.take("+");
            1.0
        };
        if self.rest.starts_with(['+', '-']) {
            return Err("a sign after a sign".to_owned());
        }
        let power = self.power()?;
        Ok(power.into_iter().map(|term| Term { value: sign * term.value, ..term }).collect())
    }

    fn power(&mut self) -> Result<Sum, String> {
        let base = self.operand()?;
        let exponent = if let Some(found) = ["²", "³"].iter().position(|sign| self.take(sign)) {
            [2.0, 3.0][found]
        } else if self.take("^") || self.take("**") {
            let sign = if self.take("-") { -1.0 } else { 1.0 };
            sign * number(&self.operand()?).ok_or("an exponent is not a number")?
        } else {
            return Ok(base);
        };
        if let Some(base) = number(&base) {
            return Ok(vec![Term::number(base.powf(exponent))]);
        }
        if exponent.fract() != 0.0 || exponent.abs() > MAX_POWER {
            return Err(format!("a power of {exponent} is in no equation: expected a whole number such as `v^2`"));
        }
        let power = terms::power(&base, exponent as i32);
        bounded(
            power
                .ok_or("it is not linear: no power of a position or rate, and no negative one of a sum, is fed back")?,
        )
    }

    fn operand(&mut self) -> Result<Sum, String> {
        if self.take("(") {
            return self.closed();
        }
        if self.rest.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            let (value, rest) = literal::take(self.rest)?;
            self.rest = rest;
            return self.with_unit(value);
        }
        let word = self.word();
        let name = function::without_module(word);
        if word.is_empty() {
            return Err(match self.rest.chars().next() {
                Some(found) => format!("unexpected `{found}`"),
                None => "a term is missing at the end".to_owned(),
            });
        }
        if matches!(name, "pi" | "π") {
            return Ok(vec![Term::number(PI)]);
        }
        if let Some(function) = function::of_one(name) {
            let argument = self.argument(word)?;
            return Ok(vec![Term::number(function(argument))]);
        }
        // As declarations of models write it.
        if word == "rate" && self.take("(") {
            let of = self.word();
            if !self.take(")") {
                return Err("`rate` is of one coordinate, as in `rate(phi)`".to_owned());
            }
            return (self.names)(&format!("{of}_rate")).map(|symbol| vec![Term::symbol(symbol)]);
        }
        (self.names)(word).map(|symbol| vec![Term::symbol(symbol)])
    }

    fn argument(&mut self, function: &str) -> Result<f64, String> {
        if !self.take("(") {
            return Err(format!("`{function}` needs its argument in parentheses"));
        }
        let argument = self.closed()?;
        number(&argument).ok_or_else(|| match argument.iter().any(|term| term.motion.is_some()) {
            true => format!("it is not linear: the argument of `{function}` is not a number"),
            false => format!(
                "`{function}` is of the speed, of which the equations of motion have whole powers alone: expected such as `v^2`"
            ),
        })
    }

    /// The rest of what stands in parentheses, and the closing one.
    fn closed(&mut self) -> Result<Sum, String> {
        let sum = self.sum()?;
        if self.take(")") { Ok(sum) } else { Err("a closing parenthesis is missing".to_owned()) }
    }

    /// A number with as much behind it as is a unit: `10 N*m*s*phi_rate` is `10 N*m*s` times `phi_rate`.
    fn with_unit(&mut self, value: f64) -> Result<Sum, String> {
        self.skip_space();
        if let Some((inner, rest)) = self.rest.strip_prefix('[').and_then(|rest| rest.split_once(']')) {
            let (unit, scale) = units::in_si(inner, self.of_force).ok_or_else(|| format!("`{inner}` is no unit"))?;
            self.rest = rest.trim_start();
            return Ok(vec![Term::quantity(scale.apply(value), unit)]);
        }
        let mut found = None;
        let mut end = 0;
        while self.rest[end..].starts_with(|c: char| c.is_alphabetic() || c == '°') {
            let start = end;
            end += length(&self.rest[end..], |c| is_of_name(c) || c == '°' || c == '\'');
            // What stands behind an operator may be the motion, even if it is called like a unit.
            let word = &self.rest[start..end];
            if start > 0 && (self.names)(word).is_ok() {
                break;
            }
            end += exponent(&self.rest[end..]);
            let Some(unit) = units::in_si(&self.rest[..end], self.of_force) else { break };
            found = Some((unit, end));
            end += length(&self.rest[end..], |c| c == ' ');
            let sign = self.rest[end..].chars().next().filter(|sign| "*/·⋅".contains(*sign));
            end += sign.map_or(0, char::len_utf8);
            end += length(&self.rest[end..], |c| c == ' ');
        }
        let Some(((unit, scale), end)) = found else { return Ok(vec![Term::number(value)]) };
        self.rest = self.rest[end..].trim_start();
        let quantity = (scale.apply(value), unit);
        #[cfg(feature = "full")]
        let quantity = self.by_unit(quantity);
        Ok(vec![Term::quantity(quantity.0, quantity.1)])
    }

    /// A quantity by a unit behind it in parentheses: `7 N*m/(rad/s)`.
    #[cfg(feature = "full")]
    fn by_unit(&mut self, (value, powers): (f64, [i32; 3])) -> (f64, [i32; 3]) {
        let divisor = self.rest.strip_prefix('/').and_then(|rest| rest.trim_start().strip_prefix('('));
        let Some((inner, rest)) = divisor.and_then(|rest| rest.split_once(')')) else { return (value, powers) };
        let is_motion = inner.split(|c| !is_of_name(c)).any(|word| (self.names)(word).is_ok());
        let is_unit = !inner.trim().is_empty() && !is_motion;
        let Some((by, scale)) = units::in_si(inner, self.of_force).filter(|_| is_unit) else { return (value, powers) };
        self.rest = rest.trim_start();
        (scale.inverse().apply(value), std::array::from_fn(|at| powers[at] - by[at]))
    }

    /// A name, with underscores, and at its end a prime for a rate.
    fn word(&mut self) -> &'a str {
        self.skip_space();
        let mut end = length(self.rest, |c| is_of_name(c) || c == '.');
        end += length(&self.rest[end..], |c| c == '\'');
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        self.skip_space();
        word
    }

    fn take(&mut self, wanted: &str) -> bool {
        expression::take(&mut self.rest, wanted)
    }

    fn skip_space(&mut self) {
        self.rest = self.rest.trim_start();
    }
}

/// Digits that are raised, as in `v²`, are of no name.
fn is_of_name(c: char) -> bool {
    c.is_alphabetic() || c.is_ascii_digit() || c == '_'
}

/// How many bytes at the beginning of a text are of a kind.
fn length(text: &str, is_own: impl Fn(char) -> bool) -> usize {
    text.len() - text.trim_start_matches(is_own).len()
}

/// The length of a power that is written behind a unit.
fn exponent(text: &str) -> usize {
    let sign = if text.starts_with("**") { 2 } else { usize::from(text.starts_with('^')) };
    if sign == 0 {
        return length(text, |c| c == '²' || c == '³');
    }
    let minus = usize::from(text[sign..].starts_with('-'));
    sign + minus + length(&text[sign + minus..], |c| c.is_ascii_digit())
}

/// A sum that is no longer than it may be.
fn bounded(sum: Sum) -> Result<Sum, String> {
    if sum.len() > MAX_TERMS || sum.iter().any(|term| term.power.abs() > MAX_POWERS) {
        return Err("the powers of `v` are too high".to_owned());
    }
    Ok(sum)
}

/// The value of a sum that is a number alone.
fn number(sum: &Sum) -> Option<f64> {
    match sum[..] {
        [term] if term.is_number() => Some(term.value),
        _ => None,
    }
}
