//! What the heading of a column says.

use super::units::scale;

/// What stands above a column, and the unit behind it: of `w [mm]`, `w (mm)` and, as ISO 80000 has it, `w / mm`. `[-]` and
/// `[1]` mean that there is none.
pub fn headed(text: &str) -> (&str, Option<&str>) {
    in_brackets(text).or_else(|| behind_slash(text)).unwrap_or((text, None))
}

fn in_brackets(text: &str) -> Option<(&str, Option<&str>)> {
    let inside = |open: char, close: char| {
        let (name, unit) = text.strip_suffix(close)?.rsplit_once(open)?;
        let unit = Some(unit.trim()).filter(|unit| !matches!(*unit, "" | "-" | "1"));
        Some((name.trim(), unit)).filter(|(name, _)| !name.is_empty())
    };
    inside('[', ']').or_else(|| inside('(', ')'))
}

fn behind_slash(text: &str) -> Option<(&str, Option<&str>)> {
    let (name, unit) = text.split_once('/')?;
    let (name, unit) = (name.trim(), unit.trim());
    (is_unit(unit) && !name.is_empty()).then_some((name, Some(unit)))
}

/// Whether that is a unit, of whatever quantity.
pub fn is_unit(text: &str) -> bool {
    !text.is_empty() && scale(text, text).is_some()
}
