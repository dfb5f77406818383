//! Names that are known but not needed.

use carvallo::ModelInfo;

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
