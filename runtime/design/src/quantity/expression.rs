//! Arithmetic as people write it: `pi/10`, `atan(1/3)`, `90 deg - 72 deg`, `2*I_Rxx`.

use std::f64::consts::PI;

use super::arithmetic::Arithmetic;
use super::context::Lookup;
use super::function;
use super::literal::{self, kept};

/// Deeper nesting than this is refused, so that no input can exhaust the stack.
const MAX_DEPTH: usize = 64;

/// More than this is nothing that somebody wrote, and would take long.
const LONGEST: usize = 100_000;

const MIXED: &str = "degrees and numbers without a unit are mixed; write `deg` behind each angle";
const NOT_LINEAR: &str = "degrees are added, and multiplied or divided by pure numbers, but nothing else";

/// An expression at the beginning of a text.
#[derive(Debug)]
pub struct Parsed<'a, T> {
    pub value: T,
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
/// `deg` belongs to the whole product before it, `1/2 deg`, and at the end of a sum of numbers to all of it, `90-72 deg`, as
/// every other unit does.
///
/// # Errors
/// What is wrong, if it does not begin with one.
pub fn parse<'a, T: Arithmetic>(text: &'a str, names: &Lookup<T>) -> Result<Parsed<'a, T>, String> {
    if cfg!(feature = "full") && text.len() > LONGEST {
        return Err(format!("an expression of {} bytes: at most {LONGEST} are read", text.len()));
    }
    let mut parser = Parser { rest: text, depth: 0, behind_degrees: None, in_degrees: false, refers: false, names };
    let value = parser.sum()?.in_radians()?.value;
    Ok(Parsed { value, in_degrees: parser.in_degrees, refers: parser.refers, rest: parser.rest.trim() })
}

/// A part of an expression.
#[derive(Clone, Copy)]
struct Operand<T> {
    value: T,
    kind: Kind,
}

/// What a part of an expression may be added to.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// Nothing but digits: it has the unit that stands behind it, if any.
    Number,
    /// `pi`, the value of a function or of a name: it may be an angle in radians.
    Other,
    /// An angle of which the value is in degrees.
    Degrees,
    /// An angle of which the value is in radians, and in which degrees stand.
    Angle,
}

impl Kind {
    fn has_degrees(self) -> bool {
        matches!(self, Self::Degrees | Self::Angle)
    }

    /// Of a product.
    fn times(self, other: Self) -> Result<Self, String> {
        match (self, other) {
            (one, other) if one.has_degrees() && other.has_degrees() => Err(NOT_LINEAR.to_owned()),
            (angle, _) | (_, angle) if angle.has_degrees() => Ok(angle),
            (Self::Number, Self::Number) => Ok(Self::Number),
            _ => Ok(Self::Other),
        }
    }
}

impl<T: Arithmetic> Operand<T> {
    fn in_radians(self) -> Result<Self, String> {
        match self.kind {
            Kind::Degrees => {
                let value = kept_of(self.value * PI.into() / 180.0.into(), self.value.value() != 0.0)?;
                Ok(Self { value, kind: Kind::Angle })
            }
            _ => Ok(self),
        }
    }

    /// The value of what degrees have no meaning in.
    fn pure(self) -> Result<T, String> {
        if self.kind.has_degrees() { Err(NOT_LINEAR.to_owned()) } else { Ok(self.value) }
    }

    fn negative(self) -> Self {
        Self { value: -self.value, ..self }
    }

    /// The sum of two, of which none is a number beside degrees.
    fn plus(self, other: Self) -> Result<Self, String> {
        let (first, second, kind) = match (self.kind, other.kind) {
            (one, other) if one.has_degrees() && other == Kind::Number => return Err(MIXED.to_owned()),
            (Kind::Number, other) if other.has_degrees() => return Err(MIXED.to_owned()),
            (one, two) if one == two => (self, other, one),
            (one, two) if one.has_degrees() || two.has_degrees() => {
                (self.in_radians()?, other.in_radians()?, Kind::Angle)
            }
            _ => (self, other, Kind::Other),
        };
        Ok(Self { value: first.value + second.value, kind })
    }
}

struct Parser<'a, 'n, T> {
    rest: &'a str,
    depth: usize,
    /// How long the text was behind the last `deg`.
    behind_degrees: Option<usize>,
    in_degrees: bool,
    refers: bool,
    names: &'n Lookup<'n, T>,
}

impl<'a, T: Arithmetic> Parser<'a, '_, T> {
    fn sum(&mut self) -> Result<Operand<T>, String> {
        self.depth += 1;
        if self.depth > MAX_DEPTH {
            return Err("nested too deeply".to_owned());
        }
        let mut sum = self.product()?;
        // A number is lost in a sum with `pi`, and yet does not go with degrees.
        let mut has_number = sum.kind == Kind::Number;
        loop {
            let term = if self.take("+") {
                self.unsigned()?
            } else if self.take("-") {
                self.unsigned()?.negative()
            } else {
                self.depth -= 1;
                return Ok(sum);
            };
            let is_last = self.behind_degrees == Some(self.rest.len()) && !self.rest.starts_with(['+', '-']);
            if is_last && (sum.kind, term.kind) == (Kind::Number, Kind::Degrees) {
                // `90-72 deg`
                sum.kind = Kind::Degrees;
            } else if has_number && term.kind.has_degrees() {
                return Err(MIXED.to_owned());
            }
            has_number |= term.kind == Kind::Number;
            sum = sum.plus(term)?;
        }
    }

    /// What follows a sign: a second one could be a slip, or mean a standard deviation, and is never computed with.
    fn unsigned(&mut self) -> Result<Operand<T>, String> {
        if self.rest.starts_with(['+', '-', '±']) {
            let hint = "a difference has one sign, and a standard deviation `+/-` behind the whole value";
            return Err(format!("a sign after a sign; {hint}"));
        }
        self.product()
    }

    fn product(&mut self) -> Result<Operand<T>, String> {
        let mut product = self.signed()?;
        loop {
            if self.degrees() {
                let kind = product.kind.times(Kind::Degrees)?;
                product.kind = kind;
            } else if self.take("*") || self.take("×") || self.take("·") {
                let factor = self.signed()?;
                let kind = product.kind.times(factor.kind)?;
                let is_nonzero = product.value.value() != 0.0 && factor.value.value() != 0.0;
                let value = kept_of(product.value * factor.value, is_nonzero)?;
                product = Operand { value, kind };
            } else if self.take("/") {
                let divisor = self.signed()?;
                let kind = product.kind.times(divisor.kind)?;
                let divisor = divisor.pure()?;
                let is_nonzero = product.value.value() != 0.0 && divisor.value().is_finite();
                let value = kept_of(product.value / divisor, is_nonzero)?;
                product = Operand { value, kind };
            } else {
                return Ok(product);
            }
        }
    }

    /// Binds weaker than `^`, so that `-2^2` is -4 as in formulas.
    fn signed(&mut self) -> Result<Operand<T>, String> {
        let is_negative = self.take("-");
        if is_negative || self.take("+") {
            if self.rest.starts_with(['+', '-', '±']) {
                return self.unsigned();
            }
            let power = self.power()?;
            return Ok(if is_negative { power.negative() } else { power });
        }
        self.power()
    }

    fn power(&mut self) -> Result<Operand<T>, String> {
        let base = self.operand()?;
        if !(self.take("^") || self.take("**")) {
            return Ok(base);
        }
        // One sign is enough for an exponent; a tower of powers goes in parentheses.
        let negative = self.take("-");
        let exponent = self.operand()?;
        let kind = base.kind.times(exponent.kind)?;
        let (base, exponent) = (base.pure()?, exponent.pure()?);
        let is_nonzero = base.value() != 0.0 && base.value().is_finite();
        let value = kept_of(base.powf(if negative { -exponent } else { exponent }), is_nonzero)?;
        Ok(Operand { value, kind })
    }

    /// Takes the unit of an angle, if it follows.
    fn degrees(&mut self) -> bool {
        let before = self.rest;
        if self.take("°") || self.word() == "deg" {
            self.skip_space();
            self.behind_degrees = Some(self.rest.len());
            self.in_degrees = true;
            return true;
        }
        self.rest = before;
        false
    }

    fn operand(&mut self) -> Result<Operand<T>, String> {
        if self.take("(") {
            return self.closed();
        }
        if self.rest.starts_with(|c: char| c.is_ascii_digit() || c == '.') {
            let value = self.number()?.into();
            return Ok(Operand { value, kind: Kind::Number });
        }
        let other = |value| Operand { value, kind: Kind::Other };
        let word = self.word();
        let name = function::without_module(word);
        if word.is_empty() {
            return Err(match self.rest.chars().next() {
                Some(found) => format!("unexpected `{found}`"),
                None => "a value is missing at the end".to_owned(),
            });
        }
        if let "pi" | "π" = name {
            return Ok(other(PI.into()));
        }
        // Degrees in the arguments of a function do not make its value an angle.
        let in_degrees = self.in_degrees;
        let (value, is_never_zero) = if let Some(function) = function::of_one(name) {
            self.open(word)?;
            let argument = self.closed()?.in_radians()?.value;
            (argument.one(name, function), name == "exp" && argument.value().is_finite())
        } else if let Some(function) = function::of_two(name) {
            self.open(word)?;
            let first = self.sum()?.in_radians()?.value;
            if !self.take(",") {
                return Err(format!("`{word}` has two arguments"));
            }
            let second = self.closed()?.in_radians()?.value;
            {
                let is_power = name.starts_with("pow") && first.value() != 0.0 && first.value().is_finite();
                (first.two(second, name, function), is_power)
            }
        } else {
            self.refers = true;
            let found = (self.names)(word).unwrap_or_else(|| Err(format!("`{word}` is not known")));
            return found.map(other);
        };
        self.in_degrees = in_degrees;
        kept_of(value, is_never_zero).map(other)
    }

    fn open(&mut self, function: &str) -> Result<(), String> {
        if self.take("(") { Ok(()) } else { Err(format!("`{function}` needs its argument in parentheses")) }
    }

    /// The rest of what stands in parentheses, and the closing one.
    fn closed(&mut self) -> Result<Operand<T>, String> {
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

    fn take(&mut self, wanted: &str) -> bool {
        take(&mut self.rest, wanted)
    }

    fn skip_space(&mut self) {
        self.rest = self.rest.trim_start();
    }
}

/// The value, unless it is zero and should not be.
fn kept_of<T: Arithmetic>(value: T, nonzero: bool) -> Result<T, String> {
    kept(value.value(), nonzero).map(|_| value)
}

/// Takes a sign that comes next, with the space around it. `*` is not the beginning of `**`.
pub fn take(text: &mut &str, wanted: &str) -> bool {
    let rest = match text.trim_start().strip_prefix(wanted) {
        Some(rest) if wanted == "*" && rest.starts_with('*') => None,
        rest => rest,
    };
    *text = rest.unwrap_or(*text).trim_start();
    rest.is_some()
}

#[cfg(test)]
mod tests;
