//! A comparison as JSON; its form is documented in `docs/compare.md`, and stays.

use std::io::{Result, Write};

use carvallo_design::DisplayUnit;
use carvallo_design::units::Units;
use serde::Serialize;

use crate::analysis::compare::{Compared, Comparison, Difference, Event as Happening, Way, Whole};
use crate::analysis::name;
use crate::data::analysis::{Event, Range, events, ranges};
use crate::data::head::Head;
use crate::data::layout::{Line, Members, write_document};
use crate::data::parameters::other;

#[derive(Serialize)]
struct Document<'a> {
    /// What all speeds are in, where that is not m/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    speed_unit: Option<String>,
    designs: Vec<Design<'a>>,
    differing_parameters: Line<Vec<&'static str>>,
    differences: Vec<Against<'a>>,
}

#[derive(Serialize)]
struct Design<'a> {
    label: &'a str,
    #[serde(flatten)]
    head: Head<'a>,
    parameters: Members<Line<f64>>,
    critical_speeds: Vec<Line<Event>>,
    stable_ranges: Vec<Line<Range>>,
}

/// A design against the first one: how its critical speeds come from those of the first, or why that is not known.
#[derive(Serialize)]
struct Against<'a> {
    from: &'a str,
    to: &'a str,
    critical_speeds: Option<Vec<Change>>,
    unexplained: Option<&'a str>,
}

/// How a critical speed changes: with contributions if it is one of both designs, and else with where it appears or vanishes.
#[derive(Serialize)]
struct Change {
    kind: &'static str,
    from: Option<f64>,
    to: Option<f64>,
    difference: Option<f64>,
    contributions: Option<Members<Line<f64>>>,
    residual: Option<f64>,
    vanishes: Option<Line<Place>>,
    appears: Option<Line<Place>>,
}

/// Where something happens on the way, as a part of it, and at which speed.
#[derive(Serialize)]
struct Place {
    place: f64,
    speed: f64,
    reason: String,
}

/// Speeds are in units, and parameters, which are read again, in those of the SI.
///
/// # Errors
/// If it cannot be written.
pub fn write_json(comparison: &Comparison, units: &Units, output: &mut dyn Write) -> Result<()> {
    let unit = units.of("m/s");
    let (first, others) = (&comparison.designs[0], &comparison.designs[1..]);
    let document = Document {
        speed_unit: other(&unit),
        designs: comparison.designs.iter().map(|compared| of_design(compared, &unit)).collect(),
        differing_parameters: Line(comparison.parameters(false).iter().map(|parameter| parameter.info.name).collect()),
        differences: others
            .iter()
            .zip(&comparison.differences)
            .map(|(against, difference)| Against {
                from: &first.label,
                to: &against.label,
                critical_speeds: changes(against, difference, &unit),
                unexplained: match difference {
                    Difference::Explained { .. } => None,
                    Difference::Unexplained(reason) => Some(reason),
                },
            })
            .collect(),
    };
    write_document(&document, output)
}

fn of_design<'a>(Compared { label, analysis }: &'a Compared, unit: &DisplayUnit) -> Design<'a> {
    let parameters = analysis.design.info().parameters.iter().zip(&analysis.design.parameters);
    Design {
        label,
        head: Head::of(&analysis.design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        critical_speeds: events(&analysis.stability, analysis.design.info(), unit),
        stable_ranges: ranges(&analysis.stability, unit),
    }
}

fn changes(other: &Compared, difference: &Difference, unit: &DisplayUnit) -> Option<Vec<Change>> {
    let Difference::Explained { parameters, ways } = difference else { return None };
    let info = other.analysis.design.info();
    let change = |way: &Way| {
        let empty = Change {
            kind: name(way.critical(), info),
            from: None,
            to: None,
            difference: None,
            contributions: None,
            residual: None,
            vanishes: None,
            appears: None,
        };
        match way {
            Way::Whole(Whole { from, to, contributions, residual }) => Change {
                from: Some(unit.value(from.speed)),
                to: Some(unit.value(to.speed)),
                difference: Some(unit.value(to.speed - from.speed)),
                contributions: Some(Members(
                    parameters
                        .iter()
                        .zip(contributions)
                        .map(|(&index, contribution)| {
                            (info.parameters[index].name, Line(unit.value(*contribution) + 0.0))
                        })
                        .collect(),
                )),
                residual: Some(unit.value(*residual)),
                ..empty
            },
            Way::Lost { from, event } => {
                Change { from: Some(unit.value(from.speed)), vanishes: Some(place(event, unit)), ..empty }
            }
            Way::Found { to, event } => {
                Change { to: Some(unit.value(to.speed)), appears: Some(place(event, unit)), ..empty }
            }
        }
    };
    Some(ways.iter().map(change).collect())
}

fn place(Happening { place, speed, end }: &Happening, unit: &DisplayUnit) -> Line<Place> {
    Line(Place { place: *place, speed: unit.value(*speed), reason: end.to_string() })
}
