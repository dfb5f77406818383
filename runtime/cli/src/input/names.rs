//! Names that were probably meant, and names that are known but not needed.

use crate::number::shortest;

/// The name nearest to `wanted`, if one is near enough to be a slip of the pen.
pub fn nearest<'a>(wanted: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let wanted = wanted.to_lowercase();
    let near = known.into_iter().map(|name| (strsim::jaro_winkler(&wanted, &name.to_lowercase()), name));
    // Of equals the first: `IBx` is more likely `IBxx` than `IBxz`.
    near.filter(|&(likeness, _)| likeness > 0.7).min_by(|a, b| b.0.total_cmp(&a.0)).map(|(_, name)| name)
}

/// Why a name that files of the field carry is not needed here, as the end of a sentence.
pub fn ignored(name: &str) -> Option<&'static str> {
    Some(match name {
        "v" => "the speeds come from --speeds",
        "IRzz" => "wheels are axisymmetric, so it equals IRxx",
        "IFzz" => "wheels are axisymmetric, so it equals IFxx",
        "yB" | "yH" => "the bicycle is laterally symmetric",
        _ => return None,
    })
}

/// A unit for people: `kg m²` for `kg*m^2`, and nothing for pure numbers.
pub fn unit(declared: &str) -> String {
    match declared {
        "1" => String::new(),
        declared => declared.replace('*', " ").replace("^2", "²").replace("^3", "³"),
    }
}

/// `value` followed by its unit, where it has one.
pub fn with_unit(value: f64, declared: &str) -> String {
    match unit(declared) {
        unit if unit.is_empty() => shortest(value),
        unit => format!("{} {unit}", shortest(value)),
    }
}
