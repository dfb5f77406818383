//! Plain numbers, and that none becomes zero unseen.

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
    // An `e` belongs to the number only if digits follow.
    if let Some(tail) = text[end..].strip_prefix(['e', 'E']) {
        let sign = usize::from(tail.starts_with(['+', '-']));
        let exponent = digits(&tail[sign..]);
        if exponent > 0 {
            end += 1 + sign + exponent;
        }
    }
    let (number, rest) = text.split_at(end);
    let value = number.parse().map_err(|_| format!("`{number}` is not a number"))?;
    Ok((kept(value, mantissa.contains(|c: char| ('1'..='9').contains(&c)))?, rest))
}

/// The value, unless it is zero and should not be.
///
/// # Errors
/// That the value is too small for a double.
pub fn kept(value: f64, nonzero: bool) -> Result<f64, String> {
    if nonzero && value == 0.0 { Err("the value is too small to tell from zero".to_owned()) } else { Ok(value) }
}
