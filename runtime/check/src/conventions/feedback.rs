//! What may be mistaken about feedback: its sign, whether there is any, the unit of angles in it, and single gains.

use std::f64::consts::PI;

use carvallo::{MatrixName, ModelInfo};
use carvallo_design::feedback::{Gain, Law};
use carvallo_design::number::shortest;

use super::{Convention, Effect};

/// Those of all laws, or of one of several.
pub fn feedback(info: &ModelInfo, laws: &[Law]) -> Vec<Convention> {
    let is_angle = |gain: &Gain| info.coordinates[gain.column].unit == "rad";
    let mut found = Vec::new();
    if laws.is_empty() {
        return found;
    }
    let all = |what: &str, factor: &dyn Fn(&Gain) -> f64| {
        let factors = laws.iter().flat_map(|law| &law.gains).map(factor).collect();
        Convention { what: what.to_owned(), effect: Effect::Gains(factors), rank: 0 }
    };
    found.push(all("the feedback has the other sign", &|_| -1.0));
    found.push(all("there is no feedback: the loop is open", &|_| 0.0));
    if laws.iter().flat_map(|law| &law.gains).any(is_angle) {
        let degrees = |factor: f64| move |gain: &Gain| if is_angle(gain) { factor } else { 1.0 };
        found.push(all("the gains were taken for those per degree", &degrees(180.0 / PI)));
        found.push(all("the gains were divided by the degrees of a radian", &degrees(PI / 180.0)));
    }
    if laws.len() > 1 {
        for (at, law) in laws.iter().enumerate() {
            let force = law.force(info).0;
            let of_law = |factor: f64| {
                let own = laws.iter().enumerate();
                own.flat_map(|(own, law)| vec![if own == at { factor } else { 1.0 }; law.gains.len()]).collect()
            };
            for (what, factor) in [("has the other sign", -1.0), ("is not fed back", 0.0)] {
                found.push(Convention {
                    what: format!("{force} {what}"),
                    effect: Effect::Gains(of_law(factor)),
                    rank: 0,
                });
            }
        }
    }
    found
}

/// Those of one gain of several.
pub fn gains(info: &ModelInfo, laws: &[Law]) -> Vec<Convention> {
    let all: Vec<(&Law, &Gain)> = laws.iter().flat_map(|law| law.gains.iter().map(move |gain| (law, gain))).collect();
    let mut found = Vec::new();
    for (at, (law, gain)) in all.iter().enumerate().filter(|_| all.len() > 1) {
        let term = format!("\"{}\" in {}", term(gain, info), law.force(info).0);
        for (what, factor) in
            [("has the other sign", -1.0), ("is lost", 0.0), ("is ten times as large", 10.0), ("is a tenth of it", 0.1)]
        {
            let factors = (0..all.len()).map(|own| if own == at { factor } else { 1.0 }).collect();
            found.push(Convention { what: format!("{term} {what}"), effect: Effect::Gains(factors), rank: 1 });
        }
    }
    found
}

/// As a law has it: `-10*v*phi_rate`.
pub fn term(gain: &Gain, info: &ModelInfo) -> String {
    let name = info.coordinates[gain.column].name;
    let motion = match gain.matrix {
        MatrixName::Cm1 => format!("{name}_rate/v"),
        MatrixName::C0 => format!("{name}_rate"),
        MatrixName::C1 => format!("v*{name}_rate"),
        MatrixName::K1 => format!("v*{name}"),
        MatrixName::K2 => format!("v^2*{name}"),
        _ => name.to_owned(),
    };
    format!("{}*{motion}", shortest(gain.value))
}
