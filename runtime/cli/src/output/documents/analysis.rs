//! An analysis along the speed, in tables.

use carvallo_design::DisplayUnit;
use carvallo_design::Shape;
use carvallo_design::number::shortest;
use carvallo_plot::analysis::{self, Analysis, Rows};
use carvallo_plot::data::matrices;

use crate::output::columns::speeds;
use crate::output::equations::{entries, equation};
use crate::output::ranges::{ranges, undecided};
use crate::output::table::{ModeCells, critical_eigenvalue, describe_effect};
use crate::output::typeset::{Cell, Column, Document, Table};
use crate::output::{branches, shapes, sorted};

/// Matrices, critical speeds and eigenvalues, and eigenvectors if there are any.
pub fn of_analysis(analysis: &Analysis, rows: &Rows, shapes: Option<&[Vec<Shape>]>) -> Document {
    let design = &analysis.design;
    let title = format!("Equations of motion {}", equation(design.info()));
    let mut tables = vec![super::matrices(design, title, &matrices(design), entries(design))];
    if let (Some(gravity), [table]) = (design.gravity(), &mut tables[..]) {
        table.notes.push(format!("g = {} N/kg", shortest(gravity)));
    }
    if design.model.depends_on_speed() {
        tables.push(critical_speeds(analysis));
    }
    tables.push(eigenvalues(analysis, rows));
    let at_speeds = rows.values().into_iter().zip(shapes.into_iter().flatten());
    tables.extend(at_speeds.map(|((speed, values), shapes)| {
        let columns = shapes::coordinates(analysis).into_iter().map(Column::right);
        let row = |(name, cells): (String, Vec<String>)| {
            let cells = cells.into_iter().map(|cell| Cell::words(cell.trim_end()));
            std::iter::once(Cell::words(name)).chain(cells).collect()
        };
        Table {
            title: format!("Eigenvectors {}", shapes::at(analysis, speed)),
            columns: std::iter::once(Column::left("eigenvalue (1/s)")).chain(columns).collect(),
            rows: shapes::cells(values, shapes).into_iter().map(row).collect(),
            notes: vec!["sizes relative to the largest, and by how many degrees each leads it".to_owned()],
        }
    }));
    super::about(design, tables)
}

/// Above a column of speeds.
fn heading(unit: &DisplayUnit) -> String {
    format!("v ({})", unit.written)
}

fn critical_speeds(analysis: &Analysis) -> Table {
    let (stability, info, unit) = (&analysis.stability, analysis.design.info(), &analysis.unit);
    let heading = heading(unit);
    let row = |critical| {
        vec![
            Cell::words(analysis::name(critical, info).replace('_', " ")),
            Cell::number(shortest(unit.value(critical.speed))),
            Cell::number(critical_eigenvalue(critical)),
            Cell::words(describe_effect(stability, critical)),
        ]
    };
    let ranges = ranges(stability, unit).into_iter().map(|(_, sentence)| sentence);
    Table {
        title: "Critical speeds".to_owned(),
        columns: vec![
            Column::left("critical speed"),
            Column::right(heading),
            Column::right("λ (1/s)"),
            Column::left("what happens"),
        ],
        rows: stability.critical_speeds.iter().map(row).collect(),
        notes: undecided(stability, unit).into_iter().chain(ranges).collect(),
    }
}

fn eigenvalues(analysis: &Analysis, rows: &Rows) -> Table {
    let numbers = |cells: Vec<String>| cells.into_iter().map(Cell::number).collect::<Vec<Cell>>();
    let mut columns: Vec<(Column, Vec<Cell>)> = Vec::new();
    let mut notes = Vec::new();
    match rows {
        Rows::Modes(rows) => {
            let ModeCells { casterings, capsizes, weaves, others } = ModeCells::of(rows);
            columns.push((Column::right(heading(&analysis.unit)), numbers(speeds(rows, &analysis.unit))));
            columns.push((Column::right("castering"), numbers(casterings)));
            columns.push((Column::right("capsize"), numbers(capsizes)));
            let weaves = weaves.iter().map(|weave| weave.split_whitespace().collect::<Vec<_>>().join(" "));
            columns.push((Column::right("weave"), numbers(weaves.collect())));
            if others.iter().any(|other| !other.is_empty()) {
                columns.push((Column::right("without a name"), numbers(others)));
            }
            let verdict = |speed| if analysis.is_stable(speed) { "stable" } else { "" };
            let verdicts = rows.iter().map(|row| Cell::words(verdict(row.speed)));
            columns.push((Column::left("motion"), verdicts.collect()));
        }
        Rows::Branches(rows) => {
            columns.push((Column::right(heading(&analysis.unit)), numbers(speeds(rows, &analysis.unit))));
            let verdicts = rows.iter().map(|row| Cell::words(row.values.verdict.to_string()));
            columns.push((Column::left("motion"), verdicts.collect()));
            let strands = branches::cells(rows).into_iter();
            columns.extend(strands.map(|(title, cells)| (Column::right(title), numbers(cells))));
        }
        Rows::Sorted(rows) => {
            let verdicts = rows.iter().map(|row| Cell::words(row.values.verdict.to_string()));
            columns.push((Column::left("motion"), verdicts.collect()));
            columns.push((Column::left("λ"), numbers(sorted::cells(rows))));
            notes.push("at every speed: nothing depends on v".to_owned());
        }
    }
    let count = columns.first().map_or(0, |(_, cells)| cells.len());
    let row = |index: usize| columns.iter().map(|(_, cells)| cells[index].clone()).collect();
    let lines = (0..count).map(row).collect();
    let columns = columns.into_iter().map(|(column, _)| column).collect();
    Table { title: "Eigenvalues (1/s)".to_owned(), columns, rows: lines, notes }
}
