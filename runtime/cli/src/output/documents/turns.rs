//! Steady turns, in a table for each curve.

use carvallo_design::units::Units;
use carvallo_plot::analysis::turns::{Families, end, verdict};

use crate::output::turns::{begin, cells, shown};
use crate::output::typeset::{Cell, Column, Document, Table};

/// All turns, or of a curve some, from its beginning to its end.
pub fn of_turns(families: &Families, all: bool, units: &Units) -> Document {
    let tables = families.families.iter().map(|family| {
        let turns = shown(family, all);
        let (headings, rows) = cells(families, &turns, units);
        let rows = rows.into_iter().zip(turns).map(|(row, turn)| {
            let verdict = Cell::words(verdict(turn));
            row.into_iter().map(Cell::number).chain([verdict]).collect()
        });
        let mut notes = Vec::new();
        if family.capsize.is_none() && !all {
            notes.push(format!("beginning of the curve: {}", end(family.begin)));
        }
        if !all {
            notes.push(format!("end of the curve: {}", end(family.end)));
        } else if family.turns.is_empty() {
            notes.push("none at these steers".to_owned());
        }
        Table {
            title: format!("Steady turns {}", begin(family, units)),
            columns: headings.into_iter().map(Column::right).chain([Column::left("motion")]).collect(),
            rows: rows.collect(),
            notes,
        }
    });
    super::about(families.design, tables.collect())
}
