//! How critical speeds change with the parameters, in tables.

use carvallo_design::number::shortest;
use carvallo_plot::analysis::name;
use carvallo_plot::analysis::sensitivity::{Changes, decides};
use carvallo_plot::data::matrices;

use crate::output::ranges::{ranges, undecided};
use crate::output::sensitivity::{
    RANKING, contributions, matrices_with_deviations, notes, ranking, ranking_more, with_deviation,
};
use crate::output::table::describe_effect;
use crate::output::typeset::{Cell, Column, Document, Table};

/// The critical speeds, the ranking of the parameters, and standard deviations where there are any.
pub fn of_sensitivity(changes: &Changes) -> Document {
    let mut tables = vec![critical_speeds(changes)];
    if !changes.ranked().is_empty() {
        tables.push(ranked(changes));
    }
    if changes.deviations.is_some() {
        tables.push(deviations(changes));
        let title = "Matrices with standard deviations".to_owned();
        let entries = matrices_with_deviations(changes);
        tables.push(super::matrices(&changes.design, title, &matrices(&changes.design), entries));
    }
    super::about(&changes.design, tables)
}

fn critical_speeds(changes: &Changes) -> Table {
    let unit = changes.of_speeds();
    let deciding = changes.critical_speeds.iter().filter(|critical| decides(&critical.speed));
    let row = deciding.map(|critical| {
        let reason = critical.derivatives.as_ref().err();
        let reason = reason.map(|reason| format!("; not ranked: {reason}")).unwrap_or_default();
        let effect = describe_effect(&changes.stability, &critical.speed);
        vec![
            Cell::words(name(&critical.speed, changes.design.info()).replace('_', " ")),
            Cell::number(shortest(unit.value(critical.speed.speed))),
            Cell::words(format!("{effect}{reason}")),
        ]
    });
    let ranges = ranges(&changes.stability, &unit).into_iter().map(|(_, sentence)| sentence);
    Table {
        title: "Critical speeds".to_owned(),
        columns: vec![
            Column::left("critical speed"),
            Column::right(format!("v ({})", unit.unit())),
            Column::left("what happens"),
        ],
        rows: row.collect(),
        notes: undecided(&changes.stability, &unit).into_iter().chain(ranges).collect(),
    }
}

fn ranked(changes: &Changes) -> Table {
    let (columns, info, speed) = (ranking(changes), changes.design.info(), changes.of_speeds().unit());
    let heading = |(index, (heading, _)): (usize, &(String, Vec<String>))| match index {
        0 => Column::left("parameter"),
        3 => Column::left(heading.clone()),
        // The unit of effects stands with the name of the speed, which is above the column of the effects.
        _ if index > 3 && index % 2 == 0 => Column::right(format!("{heading} ({speed})")),
        _ => Column::right(heading.clone()),
    };
    let row = |(line, parameter): (usize, usize)| {
        let cell = |(index, (_, cells)): (usize, &(String, Vec<String>))| match index {
            0 => Cell::parameter(&info.parameters[parameter]),
            3 => Cell::words(cells[line].clone()),
            _ => Cell::number(cells[line].clone()),
        };
        columns.iter().enumerate().map(cell).collect()
    };
    Table {
        title: format!("{RANKING}, {}", ranking_more(changes)),
        columns: columns.iter().enumerate().map(heading).collect(),
        rows: changes.order().into_iter().enumerate().map(row).collect(),
        notes: notes(changes),
    }
}

fn deviations(changes: &Changes) -> Table {
    let unit = changes.of_speeds();
    let row = |(critical, derivatives): (&carvallo::CriticalSpeed, _)| {
        let derivatives: &carvallo_plot::analysis::sensitivity::Derivatives = derivatives;
        vec![
            Cell::words(name(critical, changes.design.info()).replace('_', " ")),
            Cell::number(with_deviation(unit.value(critical.speed), unit.value(derivatives.deviation.unwrap_or(0.0)))),
            Cell::words(contributions(changes, derivatives)),
        ]
    };
    Table {
        title: "Standard deviations".to_owned(),
        columns: vec![
            Column::left("critical speed"),
            Column::right(format!("v ({})", unit.unit())),
            Column::left("where they come from"),
        ],
        rows: changes.ranked().into_iter().map(row).collect(),
        notes: vec!["to first order, from those of the parameters, taken to be independent".to_owned()],
    }
}
