//! Slips of single parameters: a sign, a decimal, a factor, one that is lost, and two that are exchanged.

use carvallo::ModelInfo;

use super::Convention;

/// All of them, for parameters with these values.
pub fn parameters(info: &ModelInfo, values: &[f64]) -> Vec<Convention> {
    let mut found = Vec::new();
    let used = || info.parameters.iter().enumerate().filter(|(_, parameter)| parameter.used);
    for (at, parameter) in used() {
        let (name, value) = (parameter.name, values[at]);
        if value != 0.0 {
            for (what, factor) in [
                ("has the other sign", -1.0),
                ("is lost", 0.0),
                ("is doubled, as a diameter for a radius is", 2.0),
                ("is halved", 0.5),
                ("has its decimal point one place too far to the right", 10.0),
                ("has its decimal point one place too far to the left", 0.1),
                ("is in thousandths of its unit", 1000.0),
                ("is in thousands of its unit", 0.001),
            ] {
                let changed = vec![(at, factor * value)];
                found.push(Convention::of_parameters(format!("{name} {what}"), changed).ranked(1));
            }
        }
        for (other, with) in used().filter(|(other, with)| *other != at && with.unit == parameter.unit) {
            if values[other] == value {
                continue;
            }
            let what = format!("{name} has the value of {}", with.name);
            found.push(Convention::of_parameters(what, vec![(at, values[other])]).ranked(4));
            if at < other {
                let what = format!("{name} and {} are exchanged", with.name);
                found.push(Convention::of_parameters(what, vec![(at, values[other]), (other, value)]).ranked(2));
            }
        }
    }
    found
}
