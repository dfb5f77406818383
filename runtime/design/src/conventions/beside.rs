//! A file in the names of the paper that says something a second time, as manufacturers print it: both must say the same.

use std::collections::HashMap;

use carvallo::ModelInfo;

use super::dual::Dual;
use super::geometry::GEOMETRY;
use super::quantity::Quantity;
use super::read::list;
use crate::design::Given;
use crate::failure::Problem;
use crate::input::{Document, Scope, position, validate};
use crate::number::with_unit;

/// However few digits there are, what differs by more, relatively, is not the same.
const MOST: f64 = 0.01;

/// What rounding may leave, relatively.
const ROUNDING: f64 = 1e-9;

/// Takes out what only repeats the parameters of the paper, with a note, and tells what contradicts them beyond its digits and
/// theirs. What they do not tell stays.
pub fn hold(document: &mut Document, label: &str, info: &'static ModelInfo) {
    let scope = Scope::new(&document.entries, HashMap::new(), info);
    let lookup = |name: &str| scope.value(name);
    let mut own: Vec<Option<Given>> = vec![None; info.parameters.len()];
    for entry in &document.entries {
        if let Some(at) = position(&entry.name, info) {
            own[at] = validate(entry, &info.parameters[at], &lookup).ok();
        }
    }
    let (mut same, mut problems) = (Vec::new(), Vec::new());
    for entry in &document.entries {
        let is_printed = position(&entry.name, info).is_none() && GEOMETRY.parameter(&entry.name).is_some();
        // What the parameters refer to says nothing a second time.
        let is_second = is_printed && !scope.is_used(entry);
        let Some(quantity) = Quantity::called(&entry.name, info, Some(&GEOMETRY)).filter(|_| is_second) else {
            continue;
        };
        let Some(told) = Told::new(&quantity, info, &own) else { continue };
        match validate(entry, &quantity.info, &lookup) {
            Ok(given) if told.agrees(&given) => same.push(entry.name.clone()),
            Ok(given) => {
                let [given, found] = [given.value, told.value].map(|value| with_unit(value, quantity.info.unit));
                let (by, name) = (list(&told.by), &entry.name);
                let follows = format!("`{name}` is {given}, but {found} follows from {by}");
                let message = format!("{follows}; leave one of them out");
                problems.push(Problem { place: entry.place.clone(), message });
            }
            Err(found) => problems.extend(found),
        }
    }
    if !same.is_empty() {
        let names: Vec<&str> = same.iter().map(String::as_str).collect();
        let says = if names.len() == 1 { "says" } else { "say" };
        document.notes.push(format!("{label}: {} {says} what the parameters of {} say, too", list(&names), info.name));
    }
    document.entries.retain(|entry| !same.contains(&entry.name));
    document.problems.extend(problems);
}

/// What parameters make of something.
struct Told {
    value: f64,
    /// How far it may be off by the digits of those that it follows from, or by how well they were measured.
    tolerance: f64,
    /// Their names.
    by: Vec<&'static str>,
}

impl Told {
    fn new(quantity: &Quantity, info: &ModelInfo, own: &[Option<Given>]) -> Option<Self> {
        let values: Vec<f64> = own.iter().map(|given| given.as_ref().map_or(f64::NAN, |given| given.value)).collect();
        let value = quantity.value(info, &|at| Dual::constant(values[at]))?.value;
        let gradient = quantity.gradient(info, &values)?;
        let moved = || gradient.iter().enumerate().filter(|(_, slope)| **slope != 0.0);
        let part = |(at, slope): (usize, &f64)| slope.abs() * own[at].as_ref().map_or(0.0, doubt);
        let tolerance = moved().map(part).sum();
        let by = moved().map(|(at, _)| info.parameters[at].name).collect();
        value.is_finite().then_some(Self { value, tolerance, by })
    }

    fn agrees(&self, given: &Given) -> bool {
        let size = self.value.abs().max(given.value.abs());
        let tolerance = (self.tolerance + doubt(given)).clamp(ROUNDING * size, MOST * size);
        (given.value - self.value).abs() <= tolerance
    }
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
