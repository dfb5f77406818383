//! The parameter that takes the values of an option, and each of them.

use carvallo::{ModelInfo, ParameterInfo};

use crate::input::{Expected, Known, evaluated, known, position};
use crate::nearest::nearest;
use crate::number::{shortest, with_unit};
use crate::quantity::{self, Context, no_names};

/// Where the parameter called `name` is among those of a model.
///
/// # Errors
/// If there is none: that, and the one that was probably meant.
pub fn find(name: &str, info: &ModelInfo) -> Result<usize, String> {
    position(name, info).ok_or_else(|| {
        let is_none = format!("`{name}` is not a parameter of {}", info.name);
        match known(name, info) {
            Some(Known { name: "v", .. }) => return format!("{is_none}; --eigenvalues takes speeds"),
            Some(Known { beside, value: Expected::Equal, reason, .. }) => {
                return format!("{is_none}: {reason}, so it equals `{}`", info.parameters[beside].name);
            }
            Some(Known { reason, .. }) => return format!("{is_none}: {reason}"),
            None => {}
        }
        let hint = nearest(name, info.parameters.iter().map(|parameter| parameter.name));
        let hint = hint.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
        format!("{is_none}{hint}")
    })
}

/// One of the values that a parameter takes.
///
/// # Errors
/// If it is no number: what was expected.
pub fn number(text: &str, info: &ParameterInfo) -> Result<f64, String> {
    evaluated(text, info).map_err(|found| format!("a value of `{}` is {found}", info.name))
}

/// The ends of a range `LOW:HIGH` of a parameter.
///
/// # Errors
/// If they do not ascend, some are no values that the parameter can have, or one has a unit that the other has not.
pub fn ends(texts: [&str; 2], info: &ParameterInfo) -> Result<[f64; 2], String> {
    check_units(&texts, info)?;
    let [low, high] = texts.map(|text| number(text, info));
    let ends = [low?, high?];
    let [low, high] = ends.map(|end| with_unit(end, info.unit));
    if ends[0] >= ends[1] {
        return Err(format!("the range is from {low} to {high}; it must ascend"));
    }
    match texts.into_iter().zip(ends).find(|(_, end)| !info.domain.contains(*end)) {
        None => Ok(ends),
        Some((text, end)) => {
            let (name, domain, hint) = (info.name, &info.domain, in_degrees(text, end, info));
            Err(format!("`{name}` is {}; it must be {domain}{hint}", with_unit(end, info.unit)))
        }
    }
}

/// Of a value that a parameter cannot have, how to write it in degrees, if it was written as a plain number and could be meant so,
/// as the end of a sentence.
pub fn in_degrees(written: &str, value: f64, info: &ParameterInfo) -> String {
    if info.unit == "rad" && written.parse::<f64>().is_ok() && info.domain.contains(value.to_radians()) {
        format!(" (for degrees write `{written} deg`)")
    } else {
        String::new()
    }
}

/// # Errors
/// If some of the numbers have a unit that others have not.
pub fn check_units(texts: &[&str], info: &ParameterInfo) -> Result<(), String> {
    quantity::check_units(texts, Context { unit: info.unit, names: &no_names })
}

/// # Errors
/// If all values lie outside of the domain of the parameter: then a slip is more likely than a sweep without results.
pub fn any_possible(values: &[f64], info: &ParameterInfo) -> Result<(), String> {
    let ParameterInfo { name, unit, domain, .. } = info;
    if values.iter().any(|value| domain.contains(*value)) {
        return Ok(());
    }
    let hint = values.iter().map(|value| in_degrees(&shortest(*value), *value, info)).find(|hint| !hint.is_empty());
    let hint = hint.unwrap_or_default();
    let first = values.first().map(|value| with_unit(*value, unit)).unwrap_or_default();
    Err(format!("no value of `{name}` is possible, such as {first}; it must be {domain}{hint}"))
}

/// Of a range that is longer than the largest double.
pub fn too_wide(low: f64, high: f64, info: &ParameterInfo) -> String {
    let [low, high] = [low, high].map(|value| with_unit(value, info.unit));
    format!("the range from {low} to {high} is too wide for double precision")
}
