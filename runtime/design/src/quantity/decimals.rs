//! The sign before decimals, a point or a comma, in tables that may have either.

/// Which signs stand between digits in a text: a point, a comma.
pub fn signs(text: &str) -> [bool; 2] {
    ['.', ','].map(|sign| {
        text.match_indices(sign).any(|(at, _)| {
            text[..at].ends_with(|c: char| c.is_ascii_digit())
                && text[at + 1..].starts_with(|c: char| c.is_ascii_digit())
        })
    })
}

/// The first number of a text that could be a thousand or one as well: `1.000`, `12,500`. No number of thousands begins
/// with zero, or has an exponent.
pub fn ambiguous(text: &str) -> Option<&str> {
    let is_part = |c: char| c.is_ascii_digit() || c == '.' || c == ',';
    let mut rest = text;
    loop {
        rest = &rest[rest.find(is_part)?..];
        let (number, behind) = rest.split_at(rest.find(|c| !is_part(c)).unwrap_or(rest.len()));
        let groups: Vec<&str> = number.split(['.', ',']).collect();
        let is_thousands = match &groups[..] {
            [first, others @ ..] => {
                !first.starts_with('0')
                    && (1..=3).contains(&first.len())
                    && !others.is_empty()
                    && others.iter().all(|group| group.len() == 3)
            }
            [] => false,
        };
        if is_thousands && super::literal::exponent(behind) == 0 {
            return Some(number);
        }
        rest = behind;
    }
}

#[cfg(test)]
mod tests {
    use super::{ambiguous, signs};

    #[test]
    fn thousands_are_told_from_decimals() {
        for (text, expected) in [
            ("1.000", Some("1.000")),
            ("-12,500", Some("12,500")),
            ("1.234.567", Some("1.234.567")),
            ("1.020 m", Some("1.020")),
            ("2*1.020", Some("1.020")),
            ("0.336", None),
            ("1.02", None),
            ("1.0200", None),
            ("1234.567", None),
            ("1.234e-3", None),
            ("pi/10", None),
            ("", None),
        ] {
            assert_eq!(ambiguous(text), expected, "{text}");
        }
    }

    #[test]
    fn signs_stand_between_digits() {
        assert_eq!(
            ["1.02", "1,02", "1.", "atan2(1, 2)", "1,0+/-0.1"].map(signs),
            [[true, false], [false, true], [false, false], [false, false], [true, true]]
        );
    }
}
