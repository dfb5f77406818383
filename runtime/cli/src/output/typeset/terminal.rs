//! Tables at a terminal.

use std::fmt::Write as _;

use super::{Cell, Document, Table, aligned, widths};
use crate::output::{FAINT, HEADING};

/// The least width of a column.
const LEAST: usize = 10;

/// Writing to a string cannot fail, so that the results of `write!` are dropped throughout.
pub fn write(document: &Document) -> String {
    let mut text = String::new();
    let (name, rest) = document.title.split_once(": ").unwrap_or((&document.title, ""));
    let colon = if rest.is_empty() { "" } else { ": " };
    let _ = writeln!(text, "{HEADING}{name}{HEADING:#}{colon}{rest}");
    for sentence in &document.about {
        let _ = writeln!(text, "{FAINT}{sentence}{FAINT:#}");
    }
    document.tables.iter().for_each(|table| write_table(table, &mut text));
    text
}

fn write_table(table: &Table, text: &mut String) {
    let _ = writeln!(text, "\n{HEADING}{}{HEADING:#}", table.title);
    let rows = table.rows.iter().map(|row| row.iter().map(plain).collect::<Vec<String>>());
    let headings = table.columns.iter().map(|column| plain(&column.heading)).collect();
    let lines: Vec<Vec<String>> = [headings].into_iter().chain(rows).collect();
    let widths = widths(&lines, LEAST);
    for (index, line) in lines.iter().enumerate() {
        let line = format!("  {}", aligned(line, &widths, &table.columns).join("  "));
        let line = line.trim_end();
        let _ = match index {
            0 if line.is_empty() => Ok(()),
            0 => writeln!(text, "{FAINT}{line}{FAINT:#}"),
            _ => writeln!(text, "{line}"),
        };
    }
    for note in &table.notes {
        let _ = writeln!(text, "  {note}");
    }
}

fn plain(cell: &Cell) -> String {
    match cell {
        Cell::Words(text) | Cell::Number(text) => text.clone(),
        Cell::Symbol { name, .. } => name.clone(),
    }
}
