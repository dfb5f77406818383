//! Several numbers that belong together: the ends and the step of a range, and lists.

use super::context::Context;
use super::literal;
use super::value::evaluate;

/// # Errors
/// If some of the numbers are in a unit of their own and others have none: `20:220:5 km/h` could mean both.
pub fn check_units(texts: &[&str], context: Context) -> Result<(), String> {
    let values = || texts.iter().filter_map(|text| Some((text, evaluate(text.trim(), context).ok()?)));
    let bare = values().find(|(text, value)| !value.is_converted && value.value != 0.0 && is_plain(text));
    match (bare, values().any(|(_, value)| value.is_converted)) {
        (Some((text, _)), true) => Err(format!("`{}` has no unit, but others have: write it behind each", text.trim())),
        _ => Ok(()),
    }
}

/// # Errors
/// If what stands behind a comma are decimals rather than the next number of a list: `1,02`.
pub fn check_commas(texts: &[&str]) -> Result<(), String> {
    let are_decimals =
        |text: &&&str| text.len() > 1 && text.starts_with('0') && text.bytes().all(|found| found.is_ascii_digit());
    match texts.iter().skip(1).find(are_decimals) {
        Some(text) => {
            Err(format!("`{text}` stands behind a comma; decimals are written with a point, and a list as 1, 2"))
        }
        None => Ok(()),
    }
}

/// Whether it is a number and nothing else.
pub fn is_plain(text: &str) -> bool {
    literal::take(text.trim().trim_start_matches(['+', '-'])).is_ok_and(|(_, rest)| rest.trim().is_empty())
}

/// A range between plain decimal numbers in one unit, of which the values are those that one would write: 0.3 rather than
/// 0.30000000000000004, and `18 deg` rather than eighteen times a degree.
pub struct Steps<'a> {
    low: f64,
    step: f64,
    decimals: usize,
    unit: &'a str,
}

impl<'a> Steps<'a> {
    /// `None` if one of them is no plain decimal number, or their units differ.
    pub fn new(low: &'a str, step: &'a str) -> Option<Self> {
        let (low, step) = (Decimal::parse(low)?, Decimal::parse(step)?);
        let decimals = low.decimals.max(step.decimals);
        (low.unit == step.unit).then_some(Self { low: low.value, step: step.value, decimals, unit: low.unit })
    }

    /// The text of the value after so many steps.
    pub fn text(&self, index: u32) -> Option<String> {
        let value = self.low + f64::from(index) * self.step;
        let decimals = self.decimals;
        // Beyond this a double has not so many decimals.
        (value.abs() < 1e9).then(|| format!("{value:.decimals$} {}", self.unit))
    }
}

struct Decimal<'a> {
    value: f64,
    decimals: usize,
    unit: &'a str,
}

impl<'a> Decimal<'a> {
    fn parse(text: &'a str) -> Option<Self> {
        let text = text.trim();
        let end = text.find(|c: char| !c.is_ascii_digit() && !"+-.".contains(c)).unwrap_or(text.len());
        let (number, unit) = text.split_at(end);
        let (_, decimals) = number.split_once('.').unwrap_or((number, ""));
        let is_unit =
            unit.is_empty() || !unit.starts_with(['e', 'E', 'D', 'd', '*', '/', '^', '(']) || unit.starts_with("deg");
        let value = number.trim().parse().ok().filter(|_| is_unit && decimals.len() <= 15)?;
        Some(Self { value, decimals: decimals.len(), unit: unit.trim() })
    }
}
