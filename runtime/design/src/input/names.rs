//! What names of files mean: under which names the field knows parameters, and which it carries along that are none.

use carvallo::ModelInfo;

/// The position of the parameter that is meant: `rR` by `rR`, `r_R` and `self.r_R`; `lam` by `lamda`, `lambda` and `λ`; `g`
/// by `gravity`; `IBxz` by `I_Bzx` too, as inertia tensors are symmetric. `front.c` of a wheel assembly is none of them.
pub fn position(name: &str, info: &ModelInfo) -> Option<usize> {
    if is_of_part(name) {
        return None;
    }
    let short: String = without_owner(name).chars().filter(|&c| c != '_').collect();
    let usual = match short.as_str() {
        "gravity" => "g".to_owned(),
        "lamda" | "lambda" | "λ" | "Lamda" | "Lambda" => "lam".to_owned(),
        short => match short.strip_suffix("zx") {
            Some(body) if body.starts_with('I') => format!("{body}xz"),
            _ => short.to_owned(),
        },
    };
    [name, &short, &usual].into_iter().find_map(|name| info.position(name))
}

/// Whether a name is that of the gravitational field strength.
pub fn is_gravity(name: &str) -> bool {
    matches!(without_owner(name), "g" | "gravity")
}

/// `r_R` of `self.r_R`.
pub fn without_owner(name: &str) -> &str {
    name.rsplit_once('.').map_or(name, |(_, own)| own)
}

/// Whether something is a part of a bicycle that has parameters of its own, as in libbicycle; members of C++ end in an underscore.
pub fn is_part(owner: &str) -> bool {
    matches!(owner.trim_end_matches('_'), "rear" | "front")
}

/// Whether a name is that of a parameter of such a part, as `rear.m`.
pub fn is_of_part(name: &str) -> bool {
    name.rsplit_once('.').is_some_and(|(owner, _)| is_part(without_owner(owner)))
}

/// A name that files of the field carry, but that the model does not need.
pub struct Known {
    /// The name, without underscores.
    pub name: &'static str,
    /// The position of the parameter that it is told by: one that the model has instead, or of the same kind.
    pub beside: usize,
    /// What it must be, so that nothing is lost.
    pub value: Expected,
    /// Why it is not needed, as the end of a sentence.
    pub reason: &'static str,
}

/// What a value that is not needed must be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expected {
    /// Anything.
    Any,
    /// Zero.
    Zero,
    /// The value of the parameter that it stands beside.
    Equal,
}

const KNOWN: [(&str, &str, Expected, &str); 8] = [
    ("IRzz", "IRxx", Expected::Equal, AXISYMMETRIC),
    ("IFzz", "IFxx", Expected::Equal, AXISYMMETRIC),
    ("yB", "xB", Expected::Zero, SYMMETRIC),
    ("yH", "xH", Expected::Zero, SYMMETRIC),
    ("kphi", "mB", Expected::Zero, CONTROL),
    ("kphidot", "mB", Expected::Zero, CONTROL),
    ("kdelta", "mB", Expected::Zero, CONTROL),
    ("kdeltadot", "mB", Expected::Zero, CONTROL),
];
const AXISYMMETRIC: &str = "wheels are axisymmetric";
const SYMMETRIC: &str = "the bicycle is laterally symmetric";
const CONTROL: &str = "the bicycle has no control";

/// What the name stands for in files of the field.
pub fn known(name: &str, info: &ModelInfo) -> Option<Known> {
    let short: String = without_owner(name).chars().filter(|&c| c != '_').collect();
    if short == "v" {
        return Some(Known { name: "v", beside: 0, value: Expected::Any, reason: "the speeds come from --speeds" });
    }
    let (name, beside, value, reason) = KNOWN.into_iter().find(|(name, ..)| *name == short)?;
    Some(Known { name, beside: info.position(beside)?, value, reason })
}
