//! The shipped bicycles, in a table.

use carvallo::CriticalKind;
use carvallo_design::DisplayUnit;
use carvallo_plot::analysis::Analysis;

use crate::output::list::{ranges, speeds};
use crate::output::typeset::{Cell, Column, Document, Table};

/// With their critical speeds.
pub fn of_bicycles(analyses: &[Analysis], unit: &DisplayUnit) -> Document {
    let heading = |what: &str| format!("{what} ({})", unit.written);
    let row = |analysis: &Analysis| {
        vec![
            Cell::words(analysis.design.name.clone()),
            Cell::number(speeds(analysis, CriticalKind::Weave, unit)),
            Cell::number(speeds(analysis, CriticalKind::Capsize, unit)),
            Cell::words(ranges(analysis.stable_ranges(), unit)),
            Cell::words(analysis.design.kind.clone().unwrap_or_default()),
        ]
    };
    let table = Table {
        title: String::new(),
        columns: vec![
            Column::left("bicycle"),
            Column::right(heading("weave")),
            Column::right(heading("capsize")),
            Column::left(heading("stable")),
            Column::left("kind"),
        ],
        rows: analyses.iter().map(row).collect(),
        notes: Vec::new(),
    };
    Document { title: "Bicycles with their critical speeds".to_owned(), about: Vec::new(), tables: vec![table] }
}
