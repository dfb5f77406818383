//! What is said twice, in whatever convention: whether both are the same, to the digits that they are written with.

use super::dual::Dual;
use super::name::{Name, Values};
use super::read::list;
use crate::design::Given;
use crate::input::without_owner;
use crate::number::with_unit;

/// However few digits there are, what differs by more, relatively, is not the same.
const MOST: f64 = 0.005;

/// What rounding may leave, relatively.
const ROUNDING: f64 = 1e-9;

/// Lengths in m that manufacturers print are of tyres that may differ, so that what follows from them may be off by this.
pub const PRINTED: f64 = 5e-3;

/// What follows from values that are given.
pub struct Told {
    pub value: f64,
    /// How far it may be off by the digits of those that it follows from, or by how well they were measured.
    tolerance: f64,
    /// Their names.
    by: Vec<String>,
}

/// Whether something is what follows from others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Agreement {
    /// To the digits of both.
    Same,
    /// Beyond them, but a length as they are printed may be so.
    Near,
    Other,
}

impl Told {
    /// What something is called that has another name, too.
    pub fn by_name(called: &str, given: &Given) -> Self {
        Self { value: given.value, tolerance: doubt(given), by: vec![called.to_owned()] }
    }

    /// By a formula, which has exact derivatives; `None` if it tells nothing.
    pub fn new(given: &[(&'static str, Given)], formula: &dyn Fn(&Values) -> Option<Dual>) -> Option<Self> {
        let mut values = Values::default();
        given.iter().for_each(|(name, given)| values.push(name, given.value.into()));
        let Dual { value, .. } = formula(&values).filter(|found| found.value.is_finite())?;
        let mut told = Self { value, tolerance: 0.0, by: Vec::new() };
        for (position, (name, given)) in given.iter().enumerate() {
            let slope = formula(&values.varied(position))?.slope;
            if slope != 0.0 {
                told.tolerance += slope.abs() * doubt(given);
                told.by.push((*name).to_owned());
            }
        }
        Some(told)
    }

    /// The same, with what it follows from as that is called where it is written.
    pub fn called(mut self, written: &dyn Fn(&str) -> Option<String>) -> Self {
        for name in &mut self.by {
            if let Some(written) = written(name) {
                *name = written;
            }
        }
        self
    }

    fn names(&self) -> String {
        list(&self.by.iter().map(String::as_str).collect::<Vec<_>>())
    }

    /// Whether a value is the same, of a name of a convention or of the paper.
    pub fn agreement(&self, given: &Given, name: Option<&Name>) -> Agreement {
        let size = self.value.abs().max(given.value.abs());
        let tolerance = self.tolerance + doubt(given);
        let slack = if name.is_some_and(|name| name.printed == Some("mm")) { PRINTED } else { 0.0 };
        match (given.value - self.value).abs() {
            off if off <= tolerance.clamp(ROUNDING * size, MOST * size) => Agreement::Same,
            off if off <= slack => Agreement::Near,
            _ => Agreement::Other,
        }
    }

    /// That what is called so is the same.
    pub fn is_same(&self, called: &str) -> String {
        let say = if self.by.len() == 1 { "says" } else { "say" };
        format!("`{called}` says what {} {say}, too", self.names())
    }

    /// That a value which is called so is another one, and cannot be.
    pub fn contradicts(&self, called: &str, given: &Given, unit: &str) -> String {
        format!("{}; leave one of them out", self.differs(called, given, unit))
    }

    /// That it is another one, as the beginning of a sentence.
    pub fn differs(&self, called: &str, given: &Given, unit: &str) -> String {
        let [given, found] = [given.value, rounded(self.value)].map(|value| with_unit(value, unit));
        format!("`{called}` is {given}, but {found} follows from {}", self.names())
    }

    /// The same of a length that is near, with what is not used for it.
    pub fn is_near(&self, called: &str, given: &Given, unused: &[&str]) -> String {
        let are = if unused.len() == 1 { "is" } else { "are" };
        format!("{}; {} {are} not used", self.is_off(called, given), list(unused))
    }

    /// By how much a length is another one, as the beginning of a sentence.
    pub fn is_off(&self, called: &str, given: &Given) -> String {
        let off = 1e3 * (given.value - self.value).abs();
        format!("{}, {off:.1} mm off", self.differs(called, given, "m"))
    }
}

/// Whether two names of a parameter are written as different ones, and are not halves of a symmetric tensor.
pub fn is_alias(first: &str, other: &str) -> bool {
    without_owner(first) != without_owner(other) && ![first, other].iter().any(|name| spelled(name).ends_with("zx"))
}

/// A name without what does not count in it.
pub fn spelled(name: &str) -> String {
    without_owner(name).replace('_', "")
}

/// Without digits that nobody reads.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// Half a unit of the last digit, or the standard deviation if that is more.
fn doubt(given: &Given) -> f64 {
    let deviation = given.deviation.as_ref().map_or(0.0, |deviation| deviation.value);
    deviation.max(half_unit(&given.written, given.value))
}

/// Half a unit of the last digit of a plain number with or without a unit; zero of an expression, which is what it says.
fn half_unit(written: &str, value: f64) -> f64 {
    let is_digit = |sign: char| sign.is_ascii_digit() || matches!(sign, '.' | '-' | '+');
    let (digits, rest) = written.split_at(written.find(|sign| !is_digit(sign)).unwrap_or(written.len()));
    let (Ok(number), false) = (digits.parse::<f64>(), rest.contains(|sign: char| "0123456789*/^(+-".contains(sign)))
    else {
        return 0.0;
    };
    let decimals = digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let scale = if number == 0.0 { 1.0 } else { (value / number).abs() };
    0.5 * 10_f64.powi(-(decimals as i32)) * scale
}

#[cfg(test)]
mod tests {
    use super::half_unit;

    /// Half of the place of the last digit, in the unit of the value.
    #[test]
    fn the_last_digit_counts() {
        for (written, value, expected) in [
            ("1.02", 1.02, 0.005),
            ("1.020", 1.02, 0.0005),
            ("1020 mm", 1.02, 0.0005),
            ("72 deg", 72_f64.to_radians(), 0.5_f64.to_radians()),
            ("-3", -3.0, 0.5),
            ("pi/10", 0.3, 0.0),
            ("2*0.3", 0.6, 0.0),
        ] {
            assert!((half_unit(written, value) - expected).abs() < 1e-15, "{written}");
        }
    }
}
