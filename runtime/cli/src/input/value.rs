//! One parameter: whether what was written is a value that it can have.

use carvallo::ParameterInfo;

use super::document::{Entry, Written};
use super::expression::{Mistake, evaluate};

use crate::design::{Deviation, Given};
use crate::failure::Problem;
use crate::number::{self, shortest, with_unit};

/// # Errors
/// Everything that is wrong with the value and its standard deviation.
pub fn judge(entry: &Entry, info: &ParameterInfo) -> Result<Given, Vec<Problem>> {
    let mut problems = Vec::new();
    let mut problem = |message: String| problems.push(Problem { place: entry.place.clone(), message });
    let name = info.name;
    let (value, written) = match read(&entry.value, info) {
        Ok((value, written)) if info.domain.contains(value) => (value, written),
        Ok((value, written)) => {
            let hint = degrees(value, &written, info);
            problem(format!("`{name}` is {}; it must be {}{hint}", with_unit(value, info.unit), info.domain));
            (value, String::new())
        }
        Err(found) => {
            problem(format!("`{name}` is {found}"));
            (0.0, String::new())
        }
    };
    let deviation = entry.deviation.as_ref().and_then(|deviation| match read(deviation, info) {
        Ok((value, written)) if value >= 0.0 => (value > 0.0).then_some(Deviation { written, value }),
        Ok((deviation, _)) => {
            problem(format!("the standard deviation of `{name}` is {}; it must be >= 0", shortest(deviation)));
            None
        }
        Err(found) => {
            problem(format!("the standard deviation of `{name}` is {found}"));
            None
        }
    });
    if problems.is_empty() { Ok(Given { written, value, deviation }) } else { Err(problems) }
}

/// The value of a number or an expression for a parameter, whether or not it lies in its domain.
///
/// # Errors
/// What was found and what was expected, as the end of a sentence.
pub fn evaluated(text: &str, info: &ParameterInfo) -> Result<f64, String> {
    read(&Written::Text(text.trim().to_owned()), info).map(|(value, _)| value)
}

/// How to write an angle in degrees, where a plain number would be one that the parameter can have.
fn degrees(value: f64, written: &str, info: &ParameterInfo) -> String {
    if info.unit == "rad" && written.parse::<f64>().is_ok() && info.domain.contains(value.to_radians()) {
        format!(" (for degrees write `{written} deg`)")
    } else {
        String::new()
    }
}

/// The value with its text; otherwise what was found and what was expected.
fn read(written: &Written, info: &ParameterInfo) -> Result<(f64, String), String> {
    const EXPECTED: &str = "expected a number, or an expression such as `pi/10`";
    match written {
        Written::Other(found) => Err(format!("{found}; {EXPECTED}")),
        Written::Text(text) if text.is_empty() => Err(format!("empty; {EXPECTED}")),
        Written::Text(text) => match text.trim_start_matches(['+', '-', '.']).to_lowercase().as_str() {
            "nan" | "inf" | "infinity" => Err(format!("`{text}`; expected a finite number")),
            _ => match evaluate(text) {
                Ok(value) => Ok((value, text.clone())),
                Err(Mistake::Unit) => Err(format!("`{text}`; {}", without_unit(info))),
                Err(Mistake::Other(reason)) => Err(format!("`{text}`; {EXPECTED}: {reason}")),
            },
        },
    }
}

fn without_unit(info: &ParameterInfo) -> String {
    let meaning = match number::unit(info.unit) {
        unit if unit.is_empty() => "a pure number".to_owned(),
        unit if info.unit == "rad" => format!("in {unit}, or in degrees with `deg` as in `18 deg`"),
        unit => format!("in {unit}"),
    };
    format!("no unit is accepted here: `{}` is {meaning}", info.name)
}
