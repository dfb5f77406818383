//! Decimal literals, kept exactly.

use nanoserde::{DeBin, SerBin};
use proc_macro2::Literal;

/// An unsigned decimal number `digits * 10^exponent`.
///
/// `digits` has no leading or trailing zeros, and is `0` for zero.
#[derive(Clone, Debug, DeBin, PartialEq, Eq, Hash, SerBin)]
pub struct Decimal {
    /// Decimal digits of the integer mantissa.
    pub digits: String,
    /// Power of ten.
    pub exponent: i32,
}

/// Powers of ten beyond this leave the range of f64 with room to spare.
const EXPONENT_LIMIT: i32 = 400;

/// More digits than this are a mistake rather than a measurement.
const DIGIT_LIMIT: usize = 400;

impl Decimal {
    /// The shortest decimal that rounds to a number that is finite and not negative.
    pub fn nearest(value: f64) -> Self {
        let decimal = Self::from_literal(&Literal::f64_unsuffixed(value));
        decimal.unwrap_or_else(|_| unreachable!("the shortest decimal has at most 17 digits"))
    }

    /// The number that a literal writes.
    ///
    /// # Errors
    /// A sentence that says what is wrong with it, such as a suffix or another base.
    pub fn from_literal(literal: &Literal) -> Result<Self, String> {
        let text = literal.to_string();
        let decimal = "expected a decimal number such as `0.5` or `2e-3`";
        if !text.starts_with(|c: char| c.is_ascii_digit()) {
            return Err(format!("found {text}: {decimal}"));
        }
        if text.len() > 1 && text.starts_with('0') && text[1..].starts_with(['x', 'o', 'b']) {
            return Err(format!("`{text}` is not decimal: {decimal}"));
        }
        let text = text.replace('_', "");
        let (mantissa, power) = match text.split_once(['e', 'E']) {
            Some((mantissa, power)) => {
                let sign = usize::from(power.starts_with(['+', '-']));
                if let Some(suffix) = power[sign..].find(|c: char| !c.is_ascii_digit()) {
                    let at = &power[sign + suffix..];
                    return Err(format!("unexpected suffix `{at}` on a number: {decimal}"));
                }
                (mantissa, power.parse::<i32>().ok())
            }
            None => (text.as_str(), Some(0)),
        };
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        if let Some(suffix) = [whole, fraction].iter().find_map(|part| part.find(|c: char| !c.is_ascii_digit())) {
            let at = if whole.len() > suffix && fraction.is_empty() { &whole[suffix..] } else { &fraction[suffix..] };
            return Err(format!("unexpected suffix `{at}` on a number: {decimal}"));
        }
        let all = format!("{whole}{fraction}");
        let trimmed = all.trim_start_matches('0');
        let digits = trimmed.trim_end_matches('0');
        if digits.is_empty() {
            return Ok(Self { digits: "0".into(), exponent: 0 });
        }
        let shift = (trimmed.len() - digits.len()) as i32 - fraction.len().min(i32::MAX as usize) as i32;
        let exponent = power.and_then(|power| power.checked_add(shift));
        match exponent {
            Some(exponent) if digits.len() <= DIGIT_LIMIT && exponent.abs() <= EXPONENT_LIMIT => {
                Ok(Self { digits: digits.into(), exponent })
            }
            Some(_) if digits.len() > DIGIT_LIMIT => {
                Err(format!("{} digits: a number may have at most {DIGIT_LIMIT}", digits.len()))
            }
            _ => Err("a number beyond the range of f64: expected an exponent between -300 and 300".into()),
        }
    }

    /// Whether it is zero.
    pub fn is_zero(&self) -> bool {
        self.digits == "0"
    }

    /// The nearest `f64`.
    pub fn to_f64(&self) -> f64 {
        // Digits and a power of ten are always read.
        self.to_string().parse().unwrap_or(f64::NAN)
    }

    /// The whole number, if it is one and fits.
    pub fn to_integer(&self) -> Option<i32> {
        let zeros = usize::try_from(self.exponent).ok()?;
        format!("{}{}", self.digits, "0".repeat(zeros)).parse().ok()
    }
}

/// As people write it, and as every decimal parser reads it: a power of ten stands only for many zeros.
impl std::fmt::Display for Decimal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        const MANY: usize = 6;
        let Self { digits, exponent } = self;
        let shift = exponent.unsigned_abs() as usize;
        if *exponent >= 0 && shift <= MANY {
            write!(f, "{digits}{}", "0".repeat(shift))
        } else if *exponent < 0 && shift <= digits.len() + MANY {
            let padded = format!("{digits:0>width$}", width = shift + 1);
            let (whole, fraction) = padded.split_at(padded.len() - shift);
            write!(f, "{whole}.{fraction}")
        } else {
            write!(f, "{digits}e{exponent}")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<String, String> {
        let literal: Literal = text.parse().map_err(|_| format!("{text} is no literal"))?;
        Decimal::from_literal(&literal).map(|decimal| decimal.to_string())
    }

    #[test]
    fn decimals_are_exact() {
        let cases = [
            ("0.5", "0.5"),
            ("1_000", "1000"),
            ("2.50e-3", "0.0025"),
            ("12.5", "12.5"),
            ("1e-30", "1e-30"),
            ("0.0", "0"),
            ("007", "7"),
            ("1.", "1"),
            ("3E2", "300"),
        ];
        for (text, expected) in cases {
            assert_eq!(read(text).as_deref(), Ok(expected), "{text}");
        }
    }

    #[test]
    fn people_read_a_point() {
        for text in ["0.5", "1000", "0.0025", "12.75", "0", "7", "3e12", "1e-9", "0.000001"] {
            let literal: Literal = text.parse().expect("a literal");
            assert_eq!(Decimal::from_literal(&literal).map(|decimal| decimal.to_string()).as_deref(), Ok(text));
        }
    }

    #[test]
    fn a_suffix_behind_an_exponent_is_no_exponent() {
        for text in ["1e7f64", "1e7_f64", "1e-7f64"] {
            let message = read(text).expect_err(text);
            assert!(message.starts_with("unexpected suffix `f64` on a number"), "{text}: {message}");
        }
    }

    #[test]
    fn what_is_no_decimal_is_refused() {
        for text in ["0x10", "0b1", "1u8", "1.5f64", "\"1\"", "'1'", "1e999", "1e99999999999"] {
            assert!(read(text).is_err(), "{text}");
        }
    }
}
