//! One parameter: whether what was written is a value that it can have.

use carvallo::ParameterInfo;

use super::document::{Entry, Written};
use crate::design::{Deviation, Given};
use crate::failure::Problem;
use crate::number::{self, shortest, with_unit};
use crate::parameter::in_degrees;
use crate::quantity::{self, Context, Lookup, Measured, Mistake, Part, Reason, check_parts, no_names};

const EXPECTED: &str = "expected a number, or an expression such as `pi/10`";

/// # Errors
/// Everything that is wrong with the value and its standard deviation.
pub fn validate(entry: &Entry, info: &ParameterInfo, names: &Lookup) -> Result<Given, Vec<Problem>> {
    let mut problems = Vec::new();
    let mut problem = |message: String| problems.push(Problem { place: entry.place.clone(), message });
    let name = info.name;
    let of_deviation = format!("the standard deviation of `{name}` is");
    let mut given = Part { value: 0.0, written: String::new() };
    let mut spread = None;
    match read(&entry.value, info, names) {
        Ok(Measured { mean, deviation }) => {
            if !info.domain.contains(mean.value) {
                let hint = in_degrees(&mean.written, mean.value, info);
                problem(format!("`{name}` is {}; it must be {}{hint}", with_unit(mean.value, info.unit), info.domain));
            }
            (given, spread) = (mean, deviation);
        }
        Err((false, found)) => problem(format!("`{name}` is {found}")),
        Err((true, found)) => problem(format!("{of_deviation} {found}")),
    }
    if let Some(deviation) = &entry.deviation {
        match read(deviation, info, names) {
            Ok(Measured { mean, deviation: None }) if spread.is_none() => {
                if let (Written::Text(value), Written::Text(deviation)) = (&entry.value, deviation)
                    && let Err(reason) = check_parts(value, deviation, Context { unit: info.unit, names })
                {
                    problem(format!("`{name}` is `{value}` with the standard deviation `{deviation}`; {reason}"));
                }
                spread = Some(mean);
            }
            Ok(_) => problem(format!("{of_deviation} given twice")),
            Err((_, found)) => problem(format!("{of_deviation} {found}")),
        }
    }
    if let Some(Part { value, .. }) = spread
        && value < 0.0
    {
        problem(format!("{of_deviation} {}; it must be >= 0", shortest(value)));
    }
    let deviation = spread.filter(|part| part.value > 0.0);
    let deviation = deviation.map(|Part { value, written }| Deviation { written, value });
    if problems.is_empty() {
        Ok(Given { written: given.written, value: given.value, deviation })
    } else {
        Err(problems)
    }
}

/// The value of an entry alone, whether or not it lies in the domain of the parameter.
///
/// # Errors
/// What is wrong with it.
pub fn number(entry: &Entry, info: &ParameterInfo, names: &Lookup) -> Result<f64, Problem> {
    let problem = |(_, found)| Problem { place: entry.place.clone(), message: format!("`{}` is {found}", entry.name) };
    read(&entry.value, info, names).map(|measured| measured.mean.value).map_err(problem)
}

/// The value of a number or an expression for a parameter, whether or not it lies in its domain.
///
/// # Errors
/// What was found and what was expected, as the end of a sentence.
pub fn evaluated(text: &str, info: &ParameterInfo) -> Result<f64, String> {
    let context = Context { unit: info.unit, names: &no_names };
    quantity::number(text, context).map_err(|mistake| found(mistake, info).1)
}

/// The value of a parameter and its standard deviation, if it has one, whether or not they lie in its domain.
///
/// # Errors
/// What was found and what was expected, as the end of a sentence.
pub fn measured(text: &str, info: &ParameterInfo) -> Result<(f64, Option<f64>), String> {
    let context = Context { unit: info.unit, names: &no_names };
    let found = |mistake| found(mistake, info).1;
    let Measured { mean, deviation } = quantity::measured(text, context).map_err(found)?;
    Ok((mean.value, deviation.map(|part| part.value)))
}

/// The value with its text; otherwise whether it is the standard deviation that is wrong, and what was found.
fn read(written: &Written, info: &ParameterInfo, names: &Lookup) -> Result<Measured, (bool, String)> {
    match written {
        Written::Other(found) => Err((false, format!("{found}; {EXPECTED}"))),
        Written::Text(text) => {
            quantity::measured(text, Context { unit: info.unit, names }).map_err(|mistake| found(mistake, info))
        }
    }
}

/// Whether it is the standard deviation that is wrong; and what was found and what was expected.
fn found(Mistake { text, is_deviation, reason }: Mistake, info: &ParameterInfo) -> (bool, String) {
    let found = match text.trim_start_matches(['+', '-', '.']).to_ascii_lowercase().as_str() {
        "" if text.is_empty() => format!("empty; {EXPECTED}"),
        "nan" | "inf" | "infinity" => format!("`{text}`; expected a finite number"),
        _ => match reason {
            Reason::Unit(unit) => format!("`{text}`; {}", without_unit(&unit, info)),
            Reason::Other(reason) => format!("`{text}`; {EXPECTED}: {reason}"),
        },
    };
    (is_deviation, found)
}

fn without_unit(found: &str, info: &ParameterInfo) -> String {
    let meaning = match number::unit(info.unit) {
        unit if unit.is_empty() => "a pure number".to_owned(),
        unit if info.unit == "rad" => format!("in {unit}, or in degrees with `deg` as in `18 deg`"),
        unit => format!("in {unit}"),
    };
    format!("`{found}` is no unit for it: `{}` is {meaning}", info.name)
}
