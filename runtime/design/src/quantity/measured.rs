//! Values with the standard deviation of their measurement.

use super::context::Context;
use super::literal;
use super::mistake::{Mistake, Reason};
use super::range::is_plain;
use super::value::{Value, evaluate, is_unit_alone};
use crate::number::shortest;

const UNCLEAR: &str = "one part has a unit and the other has none: write it behind both, or `(27 +/- 1) deg`";

/// A value, and its standard deviation where one is written.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The value.
    pub mean: Part,
    /// Its standard deviation.
    pub deviation: Option<Part>,
}

/// A number in the declared unit, with a text that reads back to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The number.
    pub value: f64,
    /// The text.
    pub written: String,
}

impl Part {
    fn computed(value: f64) -> Self {
        Self { value, written: shortest(value) }
    }

    /// What a name stands for elsewhere is not known where the text is read again.
    fn of(Value { value, refers, .. }: Value, text: &str) -> Self {
        if refers { Self::computed(value) } else { Self { value, written: text.to_owned() } }
    }
}

/// Reads a value with or without a standard deviation, or a list of measurements, of which it is the mean.
///
/// # Errors
/// What is wrong.
pub fn measured(text: &str, context: Context) -> Result<Measured, Mistake> {
    // Typeset tables have a minus sign of their own.
    let text = text.replace('−', "-");
    let text = unquoted(&text);
    match split_outside(text, ',')[..] {
        [_] => single(text, context),
        ref list => average(text, list, context),
    }
}

/// A value without the quotes that somebody put around it, as within `--initial "delta='5 deg'"`.
pub fn unquoted(text: &str) -> &str {
    let text = text.trim();
    let inside = |quote: char| text.strip_prefix(quote)?.strip_suffix(quote);
    ['\'', '"'].into_iter().find_map(inside).map_or(text, str::trim)
}

/// The value of a number or an expression without a standard deviation, in the declared unit.
///
/// # Errors
/// What is wrong, if it is none or is not finite.
pub fn number(text: &str, context: Context) -> Result<f64, Mistake> {
    match measured(text, context)? {
        Measured { mean, deviation: None } => Ok(mean.value),
        _ => Err(Mistake::of_value(text, Reason::Other("a standard deviation has no place here".to_owned()))),
    }
}

/// The mean of measurements that do not depend on each other, and its standard deviation.
fn average(text: &str, list: &[&str], context: Context) -> Result<Measured, Mistake> {
    let refuse = |reason: &str| Mistake::of_value(text, Reason::Other(reason.to_owned()));
    let is_list = |text: &&str| text.contains('.') || sign(text).is_some();
    if !list.iter().all(is_list) {
        return Err(refuse(
            "decimals are written with a point, and a list has measurements such as `1.02+/-0.01, 1.03+/-0.01`",
        ));
    }
    let measurements = list.iter().map(|text| single(text.trim(), context)).collect::<Result<Vec<_>, _>>()?;
    let count = measurements.len() as f64;
    let mean = measurements.iter().map(|measured| measured.mean.value).sum::<f64>() / count;
    let deviations: Vec<f64> =
        measurements.iter().filter_map(|measured| Some(measured.deviation.as_ref()?.value)).collect();
    if !deviations.is_empty() && deviations.len() < measurements.len() {
        return Err(refuse("of a list, each measurement has a standard deviation or none has"));
    }
    if deviations.iter().any(|deviation| *deviation < 0.0) {
        return Err(refuse("a standard deviation must be >= 0"));
    }
    let deviation = deviations.iter().fold(0.0, |sum: f64, deviation| sum.hypot(*deviation)) / count;
    if !mean.is_finite() || !deviation.is_finite() {
        return Err(refuse("the value is not finite"));
    }
    let deviation = (!deviations.is_empty()).then(|| Part::computed(deviation));
    Ok(Measured { mean: Part::computed(mean), deviation })
}

fn single(text: &str, context: Context) -> Result<Measured, Mistake> {
    if let Some((mean, deviation, common)) = with_common(text) {
        return both(&joined(mean, common), &joined(deviation, common), context);
    }
    if let Some((mean, deviation)) = sign(text) {
        return both(mean, deviation, context);
    }
    if let Some((mean, deviation)) = last_digits(text) {
        return both(&mean, &deviation, context);
    }
    let value = evaluate(text, context).map_err(|reason| Mistake::of_value(text, reason))?;
    Ok(Measured { mean: Part::of(value, text), deviation: None })
}

fn both(mean: &str, deviation: &str, context: Context) -> Result<Measured, Mistake> {
    let value = evaluate(mean, context).map_err(|reason| Mistake::of_value(mean, reason));
    let spread = evaluate(deviation, context).map_err(|reason| Mistake::of_deviation(deviation, reason));
    let (value, spread) = (value?, spread?);
    if is_unclear(mean, value, spread) {
        return Err(Mistake::of_value(&format!("{mean} +/- {deviation}"), Reason::Other(UNCLEAR.to_owned())));
    }
    if value.refers || spread.refers {
        // A number without a unit does not go with a part that has one.
        return Ok(Measured { mean: Part::computed(value.value), deviation: Some(Part::computed(spread.value)) });
    }
    Ok(Measured { mean: Part::of(value, mean), deviation: Some(Part::of(spread, deviation)) })
}

/// `27 +/- 1 deg`: in degrees only if both are, which it does not say.
fn is_unclear(mean: &str, value: Value, spread: Value) -> bool {
    let differs = value.is_converted != spread.is_converted && (value.is_converted || is_plain(mean));
    differs && spread.value != 0.0
}

/// Whether a value and a standard deviation that is written apart from it are in one unit.
///
/// # Errors
/// If one of them has a unit and the other has none.
pub fn check_parts(mean: &str, deviation: &str, context: Context) -> Result<(), &'static str> {
    let [mean, deviation] = [mean, deviation].map(|text| text.replace('−', "-").trim().to_owned());
    match (evaluate(&mean, context), evaluate(&deviation, context)) {
        (Ok(value), Ok(spread)) if is_unclear(&mean, value, spread) => Err(UNCLEAR),
        _ => Ok(()),
    }
}

/// Whether a standard deviation stands behind a value, with a sign.
pub fn has_deviation(text: &str) -> bool {
    sign(&text.replace('−', "-")).is_some()
}

/// `(8.0+/-0.1)e-02`: mean and standard deviation, and the factor or unit that they have in common.
fn with_common(text: &str) -> Option<(&str, &str, &str)> {
    let inside = text.strip_prefix('(')?;
    let mut depth = 1;
    let end = inside.char_indices().find_map(|(at, found)| {
        depth += i32::from(found == '(') - i32::from(found == ')');
        (depth == 0).then_some(at)
    })?;
    let (mean, deviation) = sign(&inside[..end])?;
    let common = &inside[end + 1..];
    // With anything else, a deviation is not computed as its mean is.
    let unit = common[literal::exponent(common)..].trim_start();
    (unit.is_empty() || is_unit_alone(unit)).then_some((mean, deviation, common))
}

/// The exponent behind parentheses belongs to the number in them; a unit, to the whole value.
fn joined(text: &str, common: &str) -> String {
    if is_plain(text) { format!("{text}{common}") } else { format!("({text}){common}") }
}

/// What stands before and after `+/-`, `±`, `+-` or `+ -`, outside of parentheses.
fn sign(text: &str) -> Option<(&str, &str)> {
    let mut depth = 0;
    for (at, found) in text.char_indices() {
        depth += i32::from(found == '(') - i32::from(found == ')');
        let rest = text[at..].strip_prefix(found).unwrap_or_default();
        let after = match found {
            '±' => Some(rest),
            '+' => {
                let rest = rest.trim_start();
                rest.strip_prefix('/').unwrap_or(rest).trim_start().strip_prefix('-')
            }
            _ => None,
        };
        if let (0, Some(after)) = (depth, after) {
            return Some((text[..at].trim(), after.trim()));
        }
    }
    None
}

/// `1.020(3)` as `1.020` and `3e-3`, with what follows behind both.
fn last_digits(text: &str) -> Option<(String, String)> {
    let (mantissa, rest) = text.split_once('(')?;
    let (digits, rest) = rest.split_once(')')?;
    let is_decimal = |text: &str| {
        text.contains(|c: char| c.is_ascii_digit())
            && text.matches('.').count() <= 1
            && text.chars().all(|c| c.is_ascii_digit() || c == '.')
    };
    if !is_decimal(mantissa.trim_start_matches(['+', '-'])) || !is_decimal(digits) {
        return None;
    }
    let (exponent, rest) = rest.split_at(literal::exponent(rest));
    // With anything else, a deviation is not computed as its mean is.
    if !(rest.trim().is_empty() || is_unit_alone(rest.trim_start())) {
        return None;
    }
    let power: i32 = if exponent.is_empty() { 0 } else { exponent[1..].parse().ok()? };
    let decimals = mantissa.split_once('.').map_or(0, |(_, decimals)| decimals.len() as i32);
    let power = if digits.contains('.') { power } else { power.checked_sub(decimals)? };
    let scaled = if power == 0 { digits.to_owned() } else { format!("{digits}e{power}") };
    Some((format!("{mantissa}{exponent}{rest}"), format!("{scaled}{rest}")))
}

/// The parts between separators that stand outside of parentheses.
fn split_outside(text: &str, separator: char) -> Vec<&str> {
    let mut depth = 0;
    text.split(|found: char| {
        depth += i32::from(found == '(') - i32::from(found == ')');
        depth == 0 && found == separator
    })
    .collect()
}
