//! An optimum as JSON, which is read as a file of its parameters; its form is documented in `docs/optimize.md`, and stays.

use std::io::{Result, Write};

use carvallo_design::units::Units;
use carvallo_optimize::{End, Goal, Optimum, Problem};
use serde::Serialize;

use crate::analysis::Analysis;
use crate::data::analysis::{Event, Range, events, ranges};
use crate::data::head::Head;
use crate::data::layout::{Line, Members, write_document};
use crate::data::parameters::other;

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    parameters: Members<Line<f64>>,
    /// What all speeds are in, where that is not m/s.
    #[serde(skip_serializing_if = "Option::is_none")]
    speed_unit: Option<String>,
    goal: Line<Aim>,
    varied: Members<Line<Varied>>,
    constraints: Vec<Line<Kept<'a>>>,
    critical_speeds: Vec<Line<Event>>,
    stable_ranges: Vec<Line<Range>>,
    search: Line<Search>,
}

#[derive(Serialize)]
struct Aim {
    measure: String,
    maximize: bool,
    before: Option<f64>,
    after: f64,
    /// Where it is not that of the SI.
    #[serde(skip_serializing_if = "Option::is_none")]
    unit: Option<String>,
}

#[derive(Serialize)]
struct Varied {
    before: Option<f64>,
    after: f64,
    low: f64,
    high: f64,
    /// The end of the range at which it is.
    at: Option<&'static str>,
    /// Where it is not that of the SI.
    #[serde(skip_serializing_if = "Option::is_none")]
    unit: Option<String>,
}

#[derive(Serialize)]
struct Kept<'a> {
    constraint: &'a str,
    /// Whether it leaves no room.
    tight: bool,
}

#[derive(Serialize)]
struct Search {
    speeds: [f64; 2],
    seed: u64,
    starts: u32,
    agreeing: u32,
    evaluations: u64,
}

/// What an end of a range is called.
pub fn end(end: Option<End>) -> Option<&'static str> {
    end.map(|end| match end {
        End::Low => "low",
        End::High => "high",
    })
}

/// With the analysis of the design that is best; its parameters, which are read again, are in units of the SI.
///
/// # Errors
/// If it cannot be written.
pub fn write_json(
    problem: &Problem,
    optimum: &Optimum,
    best: &Analysis,
    units: &Units,
    output: &mut dyn Write,
) -> Result<()> {
    let (design, Goal { measure, maximize }) = (&best.design, problem.goal);
    let parameters = design.info().parameters.iter().zip(&design.parameters);
    let varied = problem.ranges.iter().zip(&optimum.ends).enumerate().map(|(index, (range, at))| {
        let unit = units.of(range.parameter.unit);
        let varied = Varied {
            before: problem.before(index).map(|before| unit.value(before)),
            after: unit.value(optimum.varied[index]),
            low: unit.value(range.low),
            high: unit.value(range.high),
            at: end(*at),
            unit: other(&unit),
        };
        (range.parameter.name, Line(varied))
    });
    let (speed, of_goal) = (units.of("m/s"), units.of(measure.unit()));
    let constraints = problem.constraints.iter().zip(&optimum.is_tight);
    let document = Document {
        head: Head::of(design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        speed_unit: other(&speed),
        goal: Line(Aim {
            measure: measure.to_string(),
            maximize,
            before: optimum.before.map(|before| of_goal.value(before)),
            after: of_goal.value(optimum.value),
            unit: other(&of_goal),
        }),
        varied: Members(varied.collect()),
        constraints: constraints
            .map(|(constraint, &tight)| Line(Kept { constraint: &constraint.written, tight }))
            .collect(),
        critical_speeds: events(&best.stability, design.info(), &speed),
        stable_ranges: ranges(&best.stability, &speed),
        search: Line(Search {
            speeds: problem.settings.speeds.map(|own| speed.value(own)),
            seed: problem.settings.seed,
            starts: optimum.starts,
            agreeing: optimum.agreeing,
            evaluations: optimum.evaluations,
        }),
    };
    write_document(&document, output)
}
