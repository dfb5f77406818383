//! Arithmetic as people write it: `pi/10`, `atan(1/3)`, `90 deg - 72 deg`, `2*I_Rxx`.

use std::f64::consts::PI;

use super::context::Lookup;
use super::function;
use super::literal::{self, kept};

/// Deeper nesting than this is refused, so that no input can exhaust the stack.
const MAX_DEPTH: usize = 64;

/// An expression at the beginning of a text.
#[derive(Debug)]
pub struct Parsed<'a> {
    pub value: f64,
    /// Whether degrees stand in it, outside of the arguments of functions.
    pub in_degrees: bool,
    /// Whether a name stands in it.
    pub refers: bool,
    /// What follows it: nothing, a unit or a mistake.
    pub rest: &'a str,
}

/// Reads as much of the text as is an expression: numbers, `pi`, names, `+ - * / ^ **`, parentheses, functions, and `deg`
/// after an angle in degrees.
///
/// # Errors
/// What is wrong, if it does not begin with one.
pub fn parse<'a>(text: &'a str, names: &Lookup) -> Result<Parsed<'a>, String> {
    let mut parser = Parser { rest: text, depth: 0, in_degrees: false, refers: false, names };
    let value = parser.sum()?;
    Ok(Parsed { value, in_degrees: parser.in_degrees, refers: parser.refers, rest: parser.rest.trim() })
}

struct Parser<'a, 'n> {
    rest: &'a str,
    depth: usize,
    in_degrees: bool,
    refers: bool,
    names: &'n Lookup<'n>,
}

impl<'a> Parser<'a, '_> {
    fn sum(&mut self) -> Result<f64, String> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err("nested too deeply".to_owned());
        }
        let mut value = self.product()?;
        loop {
            if self.take("+") {
                value += self.unsigned()?;
            } else if self.take("-") {
                value -= self.unsigned()?;
            } else {
                self.depth -= 1;
                return Ok(value);
            }
        }
    }

    /// What follows a sign: a second one could be a slip, or mean a standard deviation, and is never computed with.
    fn unsigned(&mut self) -> Result<f64, String> {
        if self.rest.starts_with(['+', '-', '±']) {
            let hint = "a difference has one sign, and a standard deviation `+/-` behind the whole value";
            return Err(format!("a sign after a sign; {hint}"));
        }
        self.product()
    }

    fn product(&mut self) -> Result<f64, String> {
        let mut value = self.signed()?;
        loop {
            if self.take("*") || self.take("×") || self.take("·") {
                let factor = self.signed()?;
                value = kept(value * factor, value != 0.0 && factor != 0.0)?;
            } else if self.take("/") {
                let divisor = self.signed()?;
                value = kept(value / divisor, value != 0.0 && divisor.is_finite())?;
            } else {
                return Ok(value);
            }
        }
    }

    /// Binds weaker than `^`, so that `-2^2` is -4 as in formulas.
    fn signed(&mut self) -> Result<f64, String> {
        let is_negative = self.take("-");
        if is_negative || self.take("+") {
            if self.rest.starts_with(['+', '-', '±']) {
                return self.unsigned();
            }
            let value = self.power()?;
            return Ok(if is_negative { -value } else { value });
        }
        self.power()
    }

    fn power(&mut self) -> Result<f64, String> {
        let base = self.operand()?;
        let value = if self.take("^") || self.take("**") {
            // One sign is enough for an exponent; a tower of powers goes in parentheses.
            let negative = self.take("-");
            let exponent = self.operand()?;
            kept(base.powf(if negative { -exponent } else { exponent }), base != 0.0 && base.is_finite())?
        } else {
            base
        };
        if self.degrees() { kept(value * PI / 180.0, value != 0.0) } else { Ok(value) }
    }

    /// Takes the unit of an angle, if it follows.
    fn degrees(&mut self) -> bool {
        let before = self.rest;
        if self.take("°") || self.word() == "deg" {
            self.in_degrees = true;
            return true;
        }
        self.rest = before;
        false
    }

    fn operand(&mut self) -> Result<f64, String> {
        if self.take("(") {
            return self.closed();
        }
        if self.rest.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return self.number();
        }
        let word = self.word();
        let name = function::without_module(word);
        if word.is_empty() {
            return Err(match self.rest.chars().next() {
                Some(found) => format!("unexpected `{found}`"),
                None => "a value is missing at the end".to_owned(),
            });
        }
        if let "pi" | "π" = name {
            return Ok(PI);
        }
        // Degrees in the arguments of a function do not make its value an angle.
        let in_degrees = self.in_degrees;
        let (value, is_never_zero) = if let Some(function) = function::of_one(name) {
            self.open(word)?;
            let argument = self.closed()?;
            (function(argument), name == "exp" && argument.is_finite())
        } else if let Some(function) = function::of_two(name) {
            self.open(word)?;
            let first = self.sum()?;
            if !self.take(",") {
                return Err(format!("`{word}` has two arguments"));
            }
            let second = self.closed()?;
            (function(first, second), name.starts_with("pow") && first != 0.0 && first.is_finite())
        } else {
            self.refers = true;
            return (self.names)(word).unwrap_or_else(|| Err(format!("`{word}` is not known")));
        };
        self.in_degrees = in_degrees;
        kept(value, is_never_zero)
    }

    fn open(&mut self, function: &str) -> Result<(), String> {
        if self.take("(") { Ok(()) } else { Err(format!("`{function}` needs its argument in parentheses")) }
    }

    /// The rest of what stands in parentheses, and the closing one.
    fn closed(&mut self) -> Result<f64, String> {
        let value = self.sum()?;
        if self.take(")") { Ok(value) } else { Err("a closing parenthesis is missing".to_owned()) }
    }

    fn number(&mut self) -> Result<f64, String> {
        let (value, rest) = literal::take(self.rest)?;
        self.rest = rest;
        Ok(value)
    }

    /// A name, with underscores, and with dots before letters.
    fn word(&mut self) -> &'a str {
        self.skip_space();
        let mut end = 0;
        for (at, found) in self.rest.char_indices() {
            let follows = self.rest[at + found.len_utf8()..].chars().next();
            let is_dot = found == '.' && end > 0 && follows.is_some_and(|next| next.is_alphabetic() || next == '_');
            if !(found.is_alphanumeric() || found == '_' || is_dot) {
                break;
            }
            end = at + found.len_utf8();
        }
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        word
    }

    /// `*` is not the beginning of `**`.
    fn take(&mut self, wanted: &str) -> bool {
        self.skip_space();
        let rest = match self.rest.strip_prefix(wanted) {
            Some(rest) if wanted == "*" && rest.starts_with('*') => None,
            rest => rest,
        };
        let is_there = rest.is_some();
        self.rest = rest.unwrap_or(self.rest);
        self.skip_space();
        is_there
    }

    fn skip_space(&mut self) {
        self.rest = self.rest.trim_start();
    }
}

#[cfg(test)]
mod tests;
