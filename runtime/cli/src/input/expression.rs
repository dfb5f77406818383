//! Values as people write them: `9.81`, `pi/10`, `atan(1/3)`, `18 deg`.

use std::f64::consts::PI;

use super::literal::{self, kept};

/// Deeper nesting than this is refused, so that no input can exhaust the stack.
const MAX_DEPTH: usize = 64;

/// Why a text has no value, as the end of a sentence.
#[derive(Debug, PartialEq, Eq)]
pub enum Mistake {
    /// A word follows the value, as a unit would.
    Unit,
    Other(String),
}

impl From<String> for Mistake {
    fn from(reason: String) -> Self {
        Self::Other(reason)
    }
}

/// The value of an expression: numbers, `pi`, `+ - * / ^`, parentheses, functions, and `deg` after an angle in degrees.
///
/// # Errors
/// What is wrong, if it is not an expression or its value is not finite.
pub fn evaluate(text: &str) -> Result<f64, Mistake> {
    let mut parser = Parser { rest: text, depth: 0 };
    let value = parser.sum()?;
    parser.skip_space();
    if let Some(found) = parser.rest.chars().next() {
        let word = parser.word();
        let is_unit = found.is_alphabetic() && word != "pi" && word != "π" && function(word).is_none();
        return Err(if is_unit { Mistake::Unit } else { Mistake::Other(format!("unexpected `{found}`")) });
    }
    if value.is_finite() { Ok(value) } else { Err(Mistake::Other("the value is not finite".to_owned())) }
}

struct Parser<'a> {
    rest: &'a str,
    depth: usize,
}

impl<'a> Parser<'a> {
    fn sum(&mut self) -> Result<f64, String> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err("nested too deeply".to_owned());
        }
        let mut value = self.product()?;
        loop {
            if self.take('+') {
                value += self.product()?;
            } else if self.take('-') {
                value -= self.product()?;
            } else {
                self.depth -= 1;
                return Ok(value);
            }
        }
    }

    fn product(&mut self) -> Result<f64, String> {
        let mut value = self.signed()?;
        loop {
            if self.take('*') {
                let factor = self.signed()?;
                value = kept(value * factor, value != 0.0 && factor != 0.0)?;
            } else if self.take('/') {
                let divisor = self.signed()?;
                value = kept(value / divisor, value != 0.0 && divisor.is_finite())?;
            } else {
                return Ok(value);
            }
        }
    }

    /// Binds weaker than `^`, so that `-2^2` is -4 as in formulas.
    fn signed(&mut self) -> Result<f64, String> {
        let mut negative = false;
        loop {
            if self.take('-') {
                negative = !negative;
            } else if !self.take('+') {
                let value = self.power()?;
                return Ok(if negative { -value } else { value });
            }
        }
    }

    fn power(&mut self) -> Result<f64, String> {
        let base = self.operand()?;
        let value = if self.take('^') {
            // One sign is enough for an exponent; a tower of powers goes in parentheses.
            let negative = self.take('-');
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
        if self.take('°') || self.word() == "deg" {
            return true;
        }
        self.rest = before;
        false
    }

    fn operand(&mut self) -> Result<f64, String> {
        if self.take('(') {
            return self.closed();
        }
        if self.rest.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            return self.number();
        }
        match self.word() {
            "pi" | "π" => Ok(PI),
            "" => match self.rest.chars().next() {
                Some(found) => Err(format!("unexpected `{found}`")),
                None => Err("a value is missing at the end".to_owned()),
            },
            name => {
                let function = function(name).ok_or_else(|| format!("`{name}` is not known"))?;
                if !self.take('(') {
                    return Err(format!("`{name}` needs its argument in parentheses"));
                }
                self.closed().map(function)
            }
        }
    }

    /// The rest of what stands in parentheses, and the closing one.
    fn closed(&mut self) -> Result<f64, String> {
        let value = self.sum()?;
        if self.take(')') { Ok(value) } else { Err("a closing parenthesis is missing".to_owned()) }
    }

    fn number(&mut self) -> Result<f64, String> {
        let (value, rest) = literal::take(self.rest)?;
        self.rest = rest;
        Ok(value)
    }

    fn word(&mut self) -> &'a str {
        self.skip_space();
        let end = self.rest.find(|c: char| !c.is_alphanumeric()).unwrap_or(self.rest.len());
        let (word, rest) = self.rest.split_at(end);
        self.rest = rest;
        word
    }

    fn take(&mut self, wanted: char) -> bool {
        self.skip_space();
        match self.rest.strip_prefix(wanted) {
            Some(rest) => {
                self.rest = rest;
                self.skip_space();
                true
            }
            None => false,
        }
    }

    fn skip_space(&mut self) {
        self.rest = self.rest.trim_start();
    }
}

fn function(name: &str) -> Option<fn(f64) -> f64> {
    Some(match name {
        "sin" => f64::sin,
        "cos" => f64::cos,
        "tan" => f64::tan,
        "asin" => f64::asin,
        "acos" => f64::acos,
        "atan" => f64::atan,
        "sqrt" => f64::sqrt,
        _ => return None,
    })
}

#[cfg(test)]
mod tests;
