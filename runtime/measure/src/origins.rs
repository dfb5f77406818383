//! What parameters follow from, for what is said of those that no bicycle has.

use carvallo_design::number::{shortest, with_unit};
use carvallo_design::{Design, WHIPPLE};

/// What a parameter is that it cannot be, and from which measurements it follows; `None` if it can.
pub fn impossible(name: &str, value: f64) -> Option<String> {
    let info = &WHIPPLE.info.parameters[WHIPPLE.info.position(name)?];
    let said = || format!("`{name}` is {}; it must be {}: {}", shown(value, info.unit), info.domain, origin(name));
    (!info.domain.contains(value)).then(said)
}

/// What is said of a parameter that is too large for a bicycle.
pub fn large(design: &Design) -> impl Fn(&'static str) -> String {
    let parameters = WHIPPLE.info.parameters.iter().zip(design.values());
    let values: Vec<(&str, String)> = parameters.map(|(own, value)| (own.name, shown(value, own.unit))).collect();
    move |name| {
        let value = values.iter().find(|(own, _)| *own == name).map_or("", |(_, value)| value);
        format!("`{name}` is {value}, too large for a bicycle: {}", origin(name))
    }
}

fn shown(value: f64, unit: &str) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    if rounded.is_finite() { with_unit(rounded, unit) } else { shortest(rounded) }
}

/// From which measurements a parameter follows, as a clause.
fn origin(name: &str) -> String {
    let part = name.chars().find(char::is_ascii_uppercase).filter(|letter| *letter != 'I');
    let part = part.or_else(|| name.strip_prefix('I')?.chars().next()).unwrap_or_default();
    let calibration = "the cylinder of `TtP1`, `mP`, `lP` and `dP`";
    // A front frame may have been measured as a fork and a handlebar.
    let apart = if part == 'H' { ", or those of `S` and `G`" } else { "" };
    let from = match (name, part) {
        ("w" | "c" | "lam", _) => "the wheel base, the head angle and the fork offset".to_owned(),
        ("rR" | "rF", _) => format!("`d{part}` and `n{part}`"),
        ("IRyy" | "IFyy", _) => format!("`Tc{part}1`, `l{part}` and `m{part}`"),
        ("IRxx" | "IFxx", _) => format!("`Tt{part}1` and {calibration}"),
        ("IByy" | "IHyy", _) => format!("`Tc{part}1`, `m{part}` and the centre of mass{apart}"),
        (_, 'B' | 'H') if name.starts_with('I') => {
            format!("`Tt{part}1`, `alpha{part}1` and those of the other orientations{apart}, and {calibration}")
        }
        (_, 'B' | 'H') if name.starts_with(['x', 'z']) => {
            format!("`a{part}1`, `alpha{part}1` and those of the other orientations{apart}")
        }
        _ => return format!("it was measured as `{name}`"),
    };
    format!("it follows from {from}")
}
