//! Numbers for people to read and for programs to read back.

/// The fewest digits that read back to the same double, with an exponent only where there would be many zeros.
pub fn shortest(value: f64) -> String {
    let text = format!("{value:?}");
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}

/// Six decimals, or six digits of a number too large for them.
pub fn six_decimals(value: f64) -> String {
    if value.abs() < 1e7 { format!("{value:.6}") } else { format!("{value:.5e}") }
}

#[cfg(test)]
mod tests {
    use super::shortest;

    #[test]
    fn zeros_do_not_pile_up() {
        assert_eq!([1.0, 0.1, -2.5, 1e300, 1e-9].map(shortest), ["1", "0.1", "-2.5", "1e300", "1e-9"]);
    }
}
