//! Stability along a parameter, in tables.

use carvallo::ParameterRange;
use carvallo_design::number::shortest;
use carvallo_plot::analysis::along::{AlongAnalysis, AtValue};

use crate::output::along::{critical_eigenvalue, entry};
use crate::output::table::effect;
use crate::output::typeset::{Cell, Column, Document, Table};

/// Critical values, and eigenvalues at some values.
pub fn of_along(analysis: &AlongAnalysis, rows: &[AtValue]) -> Document {
    let AlongAnalysis { design, parameter, range, stability, .. } = analysis;
    let name = parameter.name;
    let in_unit = |value: f64| analysis.with_unit(value);
    let plain = |value: f64| shortest(analysis.shown(value));
    let at = analysis.at_speed(", at ");
    let heading = analysis.heading();
    let mut notes = vec![format!("from {} to {}{at}", in_unit(range[0]), in_unit(range[1]))];
    notes.extend(stability.undecided.iter().map(|ParameterRange { from, to }| {
        format!("from {} to {} one may be missing: rounding decides there", plain(*from), in_unit(*to))
    }));
    let stable = stability.stable_ranges.iter();
    notes.extend(stable.map(|range| format!("stable from {} to {}", plain(range.from), in_unit(range.to))));
    if stability.stable_ranges.is_empty() {
        notes.push("stable at no value".to_owned());
    }
    let critical = stability.critical_values.iter().map(|critical| {
        vec![
            Cell::words(analysis.name(critical).replace('_', " ")),
            Cell::number(plain(critical.value)),
            Cell::number(critical_eigenvalue(critical)),
            Cell::words(effect(critical.change, stability.verdicts_around(critical))),
        ]
    });
    let critical = Table {
        title: format!("Critical values of {name}"),
        columns: vec![
            Column::left("critical value"),
            Column::right(heading.clone()),
            Column::right("λ (1/s)"),
            Column::left("what happens"),
        ],
        rows: critical.collect(),
        notes,
    };
    let lines = rows.iter().map(|row| {
        let entries = row.eigenvalues.iter().filter(|value| value.im <= 0.0).map(entry);
        let entries = Cell::number(entries.collect::<Vec<_>>().join(", "));
        vec![Cell::number(plain(row.value)), Cell::words(row.verdict.to_string()), entries]
    });
    let eigenvalues = Table {
        title: "Eigenvalues (1/s)".to_owned(),
        columns: vec![Column::right(heading), Column::left("motion"), Column::left("λ")],
        rows: lines.collect(),
        notes: Vec::new(),
    };
    super::about(design, vec![critical, eigenvalues])
}
