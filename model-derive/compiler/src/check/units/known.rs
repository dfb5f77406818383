//! The units that declarations may name.

use super::dimension::Dimension;
use crate::nearest::find_nearest;

/// A unit with a name.
#[derive(Debug)]
pub struct Known {
    pub name: &'static str,
    pub dimension: Dimension,
    /// Its size in kg, m, s and rad, as a formula; none for those of the SI, which formulas calculate in.
    pub size: Option<&'static str>,
}

const fn si(name: &'static str, exponents: [i32; 3]) -> Known {
    Known { name, dimension: Dimension::new(exponents), size: None }
}

const fn sized(name: &'static str, exponents: [i32; 3], size: &'static str) -> Known {
    Known { name, dimension: Dimension::new(exponents), size: Some(size) }
}

static KNOWN: [Known; 20] = [
    si("rad", [0, 0, 0]),
    si("kg", [1, 0, 0]),
    si("m", [0, 1, 0]),
    si("s", [0, 0, 1]),
    si("Hz", [0, 0, -1]),
    si("N", [1, 1, -2]),
    si("J", [1, 2, -2]),
    si("W", [1, 2, -3]),
    si("Pa", [1, -1, -2]),
    sized("deg", [0, 0, 0], "pi/180"),
    sized("g", [1, 0, 0], "0.001"),
    sized("t", [1, 0, 0], "1000"),
    sized("mm", [0, 1, 0], "0.001"),
    sized("cm", [0, 1, 0], "0.01"),
    sized("km", [0, 1, 0], "1000"),
    sized("ms", [0, 0, 1], "0.001"),
    sized("min", [0, 0, 1], "60"),
    sized("h", [0, 0, 1], "3600"),
    sized("kN", [1, 1, -2], "1000"),
    sized("kPa", [1, -1, -2], "1000"),
];

/// Whole words that people write for a unit.
const WORDS: [(&str, &str); 20] = [
    ("kgs", "kg"),
    ("rads", "rad"),
    ("degs", "deg"),
    ("kilogram", "kg"),
    ("kilograms", "kg"),
    ("gram", "g"),
    ("metre", "m"),
    ("meter", "m"),
    ("metres", "m"),
    ("meters", "m"),
    ("second", "s"),
    ("seconds", "s"),
    ("sec", "s"),
    ("newton", "N"),
    ("radian", "rad"),
    ("radians", "rad"),
    ("degree", "deg"),
    ("degrees", "deg"),
    ("unitless", "1"),
    ("dimensionless", "1"),
];

/// The unit called `name`.
pub fn find(name: &str) -> Option<&'static Known> {
    KNOWN.iter().find(|known| known.name == name)
}

/// What to write instead of a unit that is not known, if that can be told.
pub fn find_meant(name: &str) -> Option<String> {
    let word = WORDS.iter().find(|(word, _)| word.eq_ignore_ascii_case(name)).map(|(_, unit)| (*unit).to_string());
    word.or_else(|| product(name))
        .or_else(|| find_nearest(name, KNOWN.iter().map(|known| known.name)).map(str::to_string))
}

/// `kgm2` and `Nm`, taken apart.
fn product(name: &str) -> Option<String> {
    let mut rest = name;
    let mut factors = Vec::new();
    while !rest.is_empty() {
        let longest = KNOWN.iter().filter(|known| rest.starts_with(known.name)).max_by_key(|known| known.name.len())?;
        rest = &rest[longest.name.len()..];
        let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let (exponent, after) = rest.split_at(digits);
        let mark = if exponent.is_empty() { "" } else { "^" };
        factors.push(format!("{}{mark}{exponent}", longest.name));
        rest = after;
    }
    Some(factors.join("*"))
}

/// The names of all units, for messages.
pub fn names() -> String {
    KNOWN.iter().map(|known| known.name).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_meant_is_found() {
        let cases =
            [("Nm", "N*m"), ("kgm2", "kg*m^2"), ("Kg", "kg"), ("metre", "m"), ("Degrees", "deg"), ("radd", "rad")];
        for (written, expected) in cases {
            assert_eq!(find_meant(written).as_deref(), Some(expected), "{written}");
        }
        assert_eq!(find_meant("furlong"), None);
    }
}
