//! Values as people write them: `9.81`, `pi/10`, `atan(1/3)`, `18 deg`.

use std::f64::consts::PI;

/// Deeper nesting than this is refused, so that no input can exhaust the stack.
const MAX_DEPTH: usize = 64;

/// The value of an expression: numbers, `pi`, `+ - * / ^`, parentheses, functions, and `deg` after an angle in degrees.
///
/// # Errors
/// What is wrong, as the end of a sentence, if it is not an expression or its value is not finite.
pub fn evaluate(text: &str) -> Result<f64, String> {
    let mut parser = Parser { rest: text, depth: 0 };
    let value = parser.sum()?;
    parser.skip_space();
    if let Some(found) = parser.rest.chars().next() {
        return Err(format!("unexpected `{found}`"));
    }
    if value.is_finite() { Ok(value) } else { Err("the value is not finite".to_owned()) }
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
                value *= self.signed()?;
            } else if self.take('/') {
                value /= self.signed()?;
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
            base.powf(if negative { -exponent } else { exponent })
        } else {
            base
        };
        if self.degrees() { Ok(value * PI / 180.0) } else { Ok(value) }
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
        let digits = |text: &str| text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let mut end = digits(self.rest);
        if self.rest[end..].starts_with('.') {
            end += 1 + digits(&self.rest[end + 1..]);
        }
        // An `e` belongs to the number only if digits follow.
        if let Some(tail) = self.rest[end..].strip_prefix(['e', 'E']) {
            let sign = usize::from(tail.starts_with(['+', '-']));
            let exponent = digits(&tail[sign..]);
            if exponent > 0 {
                end += 1 + sign + exponent;
            }
        }
        let (number, rest) = self.rest.split_at(end);
        self.rest = rest;
        number.parse().map_err(|_| format!("`{number}` is not a number"))
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
mod tests {
    use super::evaluate;

    #[track_caller]
    fn check(text: &str, expected: f64) {
        assert_eq!(evaluate(text).map(f64::to_bits), Ok(expected.to_bits()), "{text}");
    }

    /// Expected values are the doubles nearest to the exact values, from mpmath at 50 digits.
    #[test]
    fn angles_are_the_nearest_doubles() {
        check("pi/10", 0.314_159_265_358_979_3);
        check("18 deg", 0.314_159_265_358_979_3);
        check("18°", 0.314_159_265_358_979_3);
        check("atan(1/3)", 0.321_750_554_396_642_2);
    }

    #[test]
    fn arithmetic_binds_as_in_formulas() {
        check(" 1 + 2*3 ", 7.0);
        check("2-3-4", -5.0);
        check("8/2/2", 2.0);
        check("-2^2", -4.0);
        check("2^-1", 0.5);
        check("--1", 1.0);
        check("2*(1 + sqrt(4))", 6.0);
        check("1e-3", 0.001);
        check(".5", 0.5);
    }

    #[test]
    fn mistakes_are_named() {
        for (text, message) in [
            ("", "a value is missing at the end"),
            ("pi/", "a value is missing at the end"),
            ("1 2", "unexpected `2`"),
            ("1,02", "unexpected `,`"),
            ("(1", "a closing parenthesis is missing"),
            ("nan", "`nan` is not known"),
            ("sin 1", "`sin` needs its argument in parentheses"),
            ("1/0", "the value is not finite"),
            ("1e999", "the value is not finite"),
            ("sqrt(-1)", "the value is not finite"),
            (".", "`.` is not a number"),
        ] {
            assert_eq!(evaluate(text), Err(message.to_owned()), "{text}");
        }
        assert_eq!(evaluate(&"(".repeat(100_000)), Err("nested too deeply".to_owned()));
        assert!(evaluate(&"-".repeat(100_000)).is_err());
    }
}
