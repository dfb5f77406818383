//! The best design within ranges, in tables: what was best, what changed, and how the critical speeds came from those before.

use carvallo_design::number::{shortest, with_unit};
use carvallo_design::units::Units;
use carvallo_optimize::{End, Measure, Optimum, Problem};
use carvallo_plot::analysis::compare::Comparison;

use super::compare::{critical_speeds, explained, rounded};
use crate::output::typeset::{Cell, Column, Document, Table};

/// Compared is the design before with the one that is best.
pub fn of_optimum(problem: &Problem, optimum: &Optimum, comparison: &Comparison, units: &Units) -> Document {
    let aim = if problem.goal.maximize { "maximize" } else { "minimize" };
    let mut tables = vec![goal(problem, optimum, units), parameters(problem, optimum, units)];
    if !problem.constraints.is_empty() {
        tables.push(constraints(problem, optimum));
    }
    tables.push(critical_speeds(comparison, units));
    tables.push(explained(&comparison.designs[0], &comparison.designs[1], &comparison.differences[0], units));
    let the = if matches!(problem.goal.measure, Measure::Parameter(..)) { "" } else { "the " };
    let title = format!("{}: {aim} {the}{}", problem.design.title(), problem.goal.measure);
    Document { title, about: problem.design.source.iter().cloned().collect(), tables }
}

fn goal(problem: &Problem, optimum: &Optimum, units: &Units) -> Table {
    let unit = units.of(problem.goal.measure.unit());
    let in_unit = |value: f64| with_unit(unit.value(value), &unit.written);
    let before = optimum.before.map_or("there is none".to_owned(), in_unit);
    let speed = units.of("m/s");
    let [low, high] = problem.settings.speeds.map(|end| shortest(speed.value(end)));
    let Optimum { starts, agreeing, evaluations, .. } = optimum;
    Table {
        title: "Goal".to_owned(),
        columns: vec![Column::left("goal"), Column::right("before"), Column::right("best")],
        rows: vec![vec![
            Cell::words(problem.goal.measure.to_string()),
            Cell::words(before),
            Cell::words(in_unit(optimum.value)),
        ]],
        notes: vec![
            format!("{agreeing} of {starts} searches came to this value, in {evaluations} designs"),
            format!("the speeds that count for stable ranges are from {low} to {high} {}", speed.unit()),
        ],
    }
}

fn parameters(problem: &Problem, optimum: &Optimum, units: &Units) -> Table {
    let row = |(index, (range, end)): (usize, (&carvallo_optimize::Range, &Option<End>))| {
        let at = match end {
            Some(End::Low) => "at the low end",
            Some(End::High) => "at the high end",
            None => "",
        };
        let unit = units.of(range.parameter.unit);
        let value = |value: f64| Cell::number(shortest(unit.value(value)));
        vec![
            Cell::parameter(&range.parameter),
            Cell::words(unit.unit()),
            problem.before(index).map_or_else(|| Cell::words(String::new()), &value),
            value(optimum.varied[index]),
            Cell::words(format!("{} to {}", rounded(unit.value(range.low)), rounded(unit.value(range.high)))),
            Cell::words(at),
        ]
    };
    let at_ends = optimum.ends.iter().flatten().count();
    let notes = match at_ends {
        0 => Vec::new(),
        _ => vec!["where the best value is at an end, a wider range may have a better one".to_owned()],
    };
    Table {
        title: "Parameters".to_owned(),
        columns: vec![
            Column::left("parameter"),
            Column::left("unit"),
            Column::right("before"),
            Column::right("best"),
            Column::left("range"),
            Column::left(""),
        ],
        rows: problem.ranges.iter().zip(&optimum.ends).enumerate().map(row).collect(),
        notes,
    }
}

fn constraints(problem: &Problem, optimum: &Optimum) -> Table {
    let row = |(constraint, is_tight): (&carvallo_optimize::Constraint, &bool)| {
        let room = if *is_tight { "leaves no room" } else { "holds with room" };
        vec![Cell::words(constraint.written.clone()), Cell::words(room)]
    };
    Table {
        title: "What is kept".to_owned(),
        columns: vec![Column::left("constraint"), Column::left("")],
        rows: problem.constraints.iter().zip(&optimum.is_tight).map(row).collect(),
        notes: Vec::new(),
    }
}
