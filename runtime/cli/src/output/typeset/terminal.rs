//! Tables at a terminal: columns side by side as far as a line goes, the rest below with the first columns anew.

use std::fmt::Write as _;

use super::{Cell, Column, Document, Side, Table, aligned, widths};
use crate::output::columns::LINE;
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
    let lines: Vec<Vec<String>> = lines.iter().map(|line| aligned(line, &widths, &table.columns)).collect();
    let parts = if table.rows.is_empty() { Vec::new() } else { parts(&table.columns, &widths) };
    for (number, part) in parts.iter().enumerate() {
        if number > 0 {
            text.push('\n');
        }
        for (index, line) in lines.iter().enumerate() {
            let line = part.iter().map(|&column| line[column].as_str()).collect::<Vec<_>>().join("  ");
            let line = line.trim_end();
            let _ = match index {
                0 if line.is_empty() => Ok(()),
                0 => writeln!(text, "{FAINT}  {line}{FAINT:#}"),
                _ => writeln!(text, "  {line}"),
            };
        }
    }
    for note in &table.notes {
        let _ = writeln!(text, "  {note}");
    }
}

/// The columns of each part, which all begin with the first columns, those of words.
fn parts(columns: &[Column], widths: &[usize]) -> Vec<Vec<usize>> {
    let keys = columns.iter().take_while(|column| column.side == Side::Left).count();
    let room = |column: usize| widths[column] + 2;
    let of_keys: usize = (0..keys).map(room).sum();
    let mut parts: Vec<Vec<usize>> = vec![(0..keys).collect()];
    let mut used = of_keys;
    for column in keys..columns.len() {
        let part = parts.last_mut().filter(|part| used + room(column) <= LINE || part.len() == keys);
        match part {
            Some(part) => part.push(column),
            None => {
                used = of_keys;
                parts.push((0..keys).chain([column]).collect());
            }
        }
        used += room(column);
    }
    parts
}

fn plain(cell: &Cell) -> String {
    match cell {
        Cell::Words(text) | Cell::Number(text) => text.clone(),
        Cell::Symbol { name, .. } => name.clone(),
    }
}

#[cfg(test)]
mod tests {
    use crate::output::typeset::{Cell, Column, Document, Table};

    #[test]
    fn what_is_wider_than_a_line_goes_on_below() {
        let wide = "x".repeat(60);
        let document = Document {
            title: "t".to_owned(),
            about: Vec::new(),
            tables: vec![Table {
                title: String::new(),
                columns: ["", "a", "b", "c"]
                    .map(|heading| if heading.is_empty() { Column::left("") } else { Column::right(heading) })
                    .into(),
                rows: vec![[Cell::words("key")].into_iter().chain(vec![Cell::words(wide.clone()); 3]).collect()],
                notes: Vec::new(),
            }],
        };
        let text = anstream::adapter::strip_str(&document.at_terminal()).to_string();
        let lines: Vec<&str> = text.lines().filter(|line| line.starts_with("  key ")).collect();
        assert_eq!(lines.len(), 3, "{text}");
        assert!(lines.iter().all(|line| line.ends_with(&wide)), "{text}");
    }
}
