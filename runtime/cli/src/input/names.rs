//! Names that were probably meant, and names that are known but not needed.

use carvallo::ModelInfo;

/// The name nearest to `wanted`, if one is near enough to be a slip of the pen.
pub fn nearest<'a>(wanted: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let wanted = wanted.to_lowercase();
    let near = known.into_iter().map(|name| (strsim::jaro_winkler(&wanted, &name.to_lowercase()), name));
    // Of equals the first: `IBx` is more likely `IBxx` than `IBxz`.
    near.filter(|&(likeness, _)| likeness > 0.7).min_by(|a, b| b.0.total_cmp(&a.0)).map(|(_, name)| name)
}

/// Why a name that files of the field carry is not needed here, as the end of a sentence.
///
/// Parameters of bicycles are told by those that the model has instead, or beside them.
pub fn ignored(name: &str, info: &ModelInfo) -> Option<&'static str> {
    let (beside, reason) = match name {
        "v" => return Some("the speeds come from --speeds"),
        "IRzz" => ("IRxx", "wheels are axisymmetric, so it equals IRxx"),
        "IFzz" => ("IFxx", "wheels are axisymmetric, so it equals IFxx"),
        "yB" => ("xB", "the bicycle is laterally symmetric"),
        "yH" => ("xH", "the bicycle is laterally symmetric"),
        _ => return None,
    };
    info.position(beside).map(|_| reason)
}
