//! A comparison as comma-separated values.

use std::io::{Result, Write};

use carvallo_design::units::Units;

use crate::analysis::compare::{Comparison, Difference, Event, Way, Whole};
use crate::analysis::name;
use crate::data::cells::{exact, write_rows};

/// Of each critical speed that both designs have, one row for each parameter that differs, with its contribution to the
/// difference; of each that one of them has alone, one row with where it appears or vanishes. Cells are empty where there is
/// nothing.
///
/// # Errors
/// If it cannot be written.
pub fn write_csv(comparison: &Comparison, units: &Units, output: &mut dyn Write) -> Result<()> {
    let unit = units.of("m/s");
    let in_unit = |name: &str| format!("{name} ({})", unit.written);
    let (names, values) = (["from", "to", "critical speed"], ["parameter", "unit", "from value", "to value"]);
    let mut header: Vec<String> = names.map(str::to_owned).to_vec();
    header.extend(["from", "to"].map(in_unit));
    header.extend(values.map(str::to_owned));
    header.extend([in_unit("contribution"), "what happens".to_owned(), "part of the way".to_owned(), in_unit("at")]);
    let mut lines = vec![header];
    let (first, others) = (&comparison.designs[0], &comparison.designs[1..]);
    for (other, difference) in others.iter().zip(&comparison.differences) {
        let (from, to) = (&first.analysis.design, &other.analysis.design);
        let (Difference::Explained { parameters, ways }, info) = (difference, to.info()) else { continue };
        for way in ways {
            let speed = |critical: Option<f64>| critical.map(|speed| exact(unit.value(speed))).unwrap_or_default();
            let head = |from: Option<f64>, to: Option<f64>| {
                let kind = name(way.critical(), info).to_owned();
                vec![first.label.clone(), other.label.clone(), kind, speed(from), speed(to)]
            };
            let nothing = |count: usize| vec![String::new(); count];
            let event = |what: &str, Event { place, speed, end }: &Event| {
                vec![format!("{what}: {end}"), exact(*place), exact(unit.value(*speed))]
            };
            match way {
                Way::Whole(Whole { from: v0, to: v1, contributions, .. }) => {
                    for (&index, contribution) in parameters.iter().zip(contributions) {
                        let parameter = &info.parameters[index];
                        let own = units.of(parameter.unit);
                        let values = [from, to].map(|design| exact(own.value(design.parameters[index].value)));
                        let names = vec![parameter.name.to_owned(), own.written];
                        // Adding zero turns -0 into 0.
                        let contribution = vec![exact(unit.value(*contribution) + 0.0)];
                        let head = head(Some(v0.speed), Some(v1.speed));
                        lines.push([head, names, values.to_vec(), contribution, nothing(3)].concat());
                    }
                }
                Way::Lost { from, event: happening } => {
                    lines.push([head(Some(from.speed), None), nothing(5), event("vanishes", happening)].concat());
                }
                Way::Found { to, event: happening } => {
                    lines.push([head(None, Some(to.speed)), nothing(5), event("appears", happening)].concat());
                }
            }
        }
    }
    write_rows(lines, output)
}
