//! An optimum as JSON, which is read as a file of its parameters; its form is documented in `docs/optimize.md`, and stays.

use std::io::{Result, Write};

use carvallo_optimize::{End, Goal, Optimum, Problem};
use serde::Serialize;

use crate::analysis::Analysis;
use crate::data::analysis::{Event, Range, events, ranges};
use crate::data::head::Head;
use crate::data::layout::{Line, Members, write_document};

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    head: Head<'a>,
    parameters: Members<Line<f64>>,
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
}

#[derive(Serialize)]
struct Varied {
    before: Option<f64>,
    after: f64,
    low: f64,
    high: f64,
    /// The end of the range at which it is.
    at: Option<&'static str>,
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

/// With the analysis of the design that is best.
///
/// # Errors
/// If it cannot be written.
pub fn write_json(problem: &Problem, optimum: &Optimum, best: &Analysis, output: &mut dyn Write) -> Result<()> {
    let (design, Goal { measure, maximize }) = (&best.design, problem.goal);
    let parameters = design.info().parameters.iter().zip(&design.parameters);
    let varied = problem.ranges.iter().zip(&optimum.ends).enumerate().map(|(index, (range, at))| {
        let before = problem.before(index);
        let after = optimum.varied[index];
        (range.parameter.name, Line(Varied { before, after, low: range.low, high: range.high, at: end(*at) }))
    });
    let constraints = problem.constraints.iter().zip(&optimum.is_tight);
    let document = Document {
        head: Head::of(design),
        parameters: Members(parameters.map(|(info, given)| (info.name, Line(given.value))).collect()),
        goal: Line(Aim { measure: measure.to_string(), maximize, before: optimum.before, after: optimum.value }),
        varied: Members(varied.collect()),
        constraints: constraints
            .map(|(constraint, &tight)| Line(Kept { constraint: &constraint.written, tight }))
            .collect(),
        critical_speeds: events(&best.stability, design.info(), &best.unit),
        stable_ranges: ranges(&best.stability, &best.unit),
        search: Line(Search {
            speeds: problem.settings.speeds,
            seed: problem.settings.seed,
            starts: optimum.starts,
            agreeing: optimum.agreeing,
            evaluations: optimum.evaluations,
        }),
    };
    write_document(&document, output)
}
