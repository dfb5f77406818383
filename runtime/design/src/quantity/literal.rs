//! Plain numbers, and that none becomes zero unseen.

/// What is said of a number that becomes zero, as the end of a sentence.
pub const TOO_SMALL: &str = "too small to tell from zero";

/// The number that the text begins with, and what follows it.
///
/// # Errors
/// What is wrong with the number.
pub fn take(text: &str) -> Result<(f64, &str), String> {
    let digits = |text: &str| text.len() - text.trim_start_matches(|c: char| c.is_ascii_digit()).len();
    let mut end = digits(text);
    if text[end..].starts_with('.') {
        end += 1 + digits(&text[end + 1..]);
    }
    let mantissa = &text[..end];
    end += exponent(&text[end..]);
    let (number, rest) = text.split_at(end);
    // Fortran writes exponents of doubles with a `D`.
    let value = number.replace(['d', 'D'], "e").parse().map_err(|_| format!("`{number}` is not a number"))?;
    Ok((kept(value, mantissa.contains(|c: char| ('1'..='9').contains(&c)))?, rest))
}

/// The length of the exponent that the text begins with, which is 0 where there is none: its letter belongs to it only if
/// digits follow.
pub fn exponent(text: &str) -> usize {
    let Some(tail) = text.strip_prefix(['e', 'E', 'd', 'D']) else { return 0 };
    let sign = usize::from(tail.starts_with(['+', '-']));
    let digits = tail[sign..].len() - tail[sign..].trim_start_matches(|c: char| c.is_ascii_digit()).len();
    if digits > 0 { 1 + sign + digits } else { 0 }
}

/// The value, unless it is zero and should not be.
///
/// # Errors
/// That the value is too small for a double.
pub fn kept(value: f64, nonzero: bool) -> Result<f64, String> {
    if nonzero && value == 0.0 { Err(format!("the value is {TOO_SMALL}")) } else { Ok(value) }
}
