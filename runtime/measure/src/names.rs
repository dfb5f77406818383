//! What is measured on a bicycle, under the names that BicycleParameters has for it.

use carvallo::{Bound, Domain, ParameterInfo};
use carvallo_design::nearest;

/// So many orientations of a part are read; three determine everything.
pub const MOST: usize = 9;

/// Those of the bicycle and its pendulum.
const FIXED: [ParameterInfo; 37] = [
    size("w"),
    angle("gamma"),
    ParameterInfo::new("f", "m", Domain::FINITE),
    length("h1"),
    length("h2"),
    length("h3"),
    length("h4"),
    length("h5"),
    length("d"),
    length("d1"),
    length("d2"),
    length("d3"),
    length("d4"),
    length("h6"),
    length("h7"),
    length("d5"),
    length("d6"),
    length("l"),
    size("dR"),
    size("dF"),
    count("nR"),
    count("nF"),
    mass("mR"),
    mass("mF"),
    mass("mB"),
    mass("mH"),
    mass("mG"),
    mass("mS"),
    mass("mP"),
    size("lP"),
    length("dP"),
    size("lR"),
    size("lF"),
    period("TcR1"),
    period("TcF1"),
    ParameterInfo::new("g", "N/kg", Domain::POSITIVE),
    period("TtP1"),
];

const WHEELS: [ParameterInfo; 2] = [period("TtR1"), period("TtF1")];

/// What files of measurements have besides: of a rider on the bicycle, of the place of a lateral force, and of a flywheel.
pub const OTHERS: [&str; 13] =
    ["lcs", "hbb", "lsp", "lst", "lamst", "whb", "LhbF", "LhbR", "xcl", "zcl", "mD", "TcD1", "TtD1"];

/// Of a part, for each of its orientations: angle, distance and period of the torsional pendulum; and one of the compound one.
macro_rules! part {
    ($part:literal: $($index:literal)*) => {
        [
            $([
                angle(concat!("alpha", $part, $index)),
                ParameterInfo::new(concat!("a", $part, $index), "m", Domain::FINITE),
                period(concat!("Tt", $part, $index)),
            ],)*
        ]
    };
}

static ORIENTATIONS: [[[ParameterInfo; 3]; MOST]; 4] = [
    part!("B": 1 2 3 4 5 6 7 8 9),
    part!("H": 1 2 3 4 5 6 7 8 9),
    part!("G": 1 2 3 4 5 6 7 8 9),
    part!("S": 1 2 3 4 5 6 7 8 9),
];

static COMPOUND: [ParameterInfo; 4] = [period("TcB1"), period("TcH1"), period("TcG1"), period("TcS1")];

/// What is known of a measurement of this name.
pub fn known(name: &str) -> Option<&'static ParameterInfo> {
    all().find(|info| info.name == name)
}

/// What others call measurements, with the names that are known.
const USUAL: [(&[&str], &str); 6] = [
    (&["wheelbase", "wheel_base"], "w"),
    (&["head_angle", "head_tube_angle", "hta"], "gamma"),
    (&["lam", "lambda", "caster_angle"], "gamma"),
    (&["fork_offset", "offset", "rake", "fork_rake"], "f"),
    (&["trail", "c"], "f"),
    (&["gravity"], "g"),
];

/// What is said of a name that is not known: what was probably meant.
pub fn hint(name: &str) -> Option<String> {
    let is_called = |(names, _): &&(&[&str], &str)| names.iter().any(|own| own.eq_ignore_ascii_case(name));
    match USUAL.iter().find(is_called) {
        Some((["lam", ..], _)) => {
            Some("; the tilt of the steer axis follows from the head angle `gamma`, 90 deg minus it".to_owned())
        }
        Some((["trail", ..], _)) => Some("; the trail follows from the fork offset `f`".to_owned()),
        Some((_, own)) => Some(format!("; it is measured as `{own}`")),
        None => nearest(name, all().map(|info| info.name)).map(|name| format!("; did you mean `{name}`?")),
    }
}

/// All that there are.
pub fn all() -> impl Iterator<Item = &'static ParameterInfo> {
    FIXED.iter().chain(&WHEELS).chain(&COMPOUND).chain(ORIENTATIONS.iter().flatten().flatten())
}

/// Those of a part in an orientation, counted from 1: angle, distance and period.
pub fn of_orientation(part: char, index: usize) -> [String; 3] {
    ["alpha", "a", "Tt"].map(|quantity| format!("{quantity}{part}{index}"))
}

const fn size(name: &'static str) -> ParameterInfo {
    ParameterInfo::new(name, "m", Domain::POSITIVE)
}

const fn length(name: &'static str) -> ParameterInfo {
    ParameterInfo::new(name, "m", Domain::NONNEGATIVE)
}

const fn mass(name: &'static str) -> ParameterInfo {
    ParameterInfo::new(name, "kg", Domain::POSITIVE)
}

const fn period(name: &'static str) -> ParameterInfo {
    ParameterInfo::new(name, "s", Domain::POSITIVE)
}

const fn count(name: &'static str) -> ParameterInfo {
    ParameterInfo::new(name, "1", Domain::POSITIVE)
}

/// In degrees, unless a unit says otherwise: up to two turns.
const fn angle(name: &'static str) -> ParameterInfo {
    let most = 4.0 * std::f64::consts::PI;
    ParameterInfo::new(name, "rad", Domain::between(Bound::Closed(-most), Bound::Closed(most)))
}
