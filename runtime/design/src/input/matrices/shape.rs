//! The rows of a matrix as they were written, and whether they are as many and as long as they must be.

use carvallo::MatrixName;

use crate::failure::Place;
use crate::input::document::{Document, Entry};
use crate::input::tables::{Node, Value, Words};
use crate::matrices::entry_name;

/// A matrix as it was written.
pub struct Given {
    pub matrix: MatrixName,
    pub place: Place,
    /// Of what is no list of rows, how many numbers there are in the place of them.
    pub rows: Result<Vec<Row>, usize>,
}

/// A row of a matrix; its entries do not have their names yet.
pub struct Row {
    pub place: Place,
    pub entries: Vec<Entry>,
}

impl Document {
    /// The rows of a matrix; of one coordinate a list of its entry will do.
    pub fn rows_of(&mut self, matrix: MatrixName, rows: Vec<Node>, words: &Words) -> Result<Vec<Row>, usize> {
        let count = rows.len();
        let is_list = |node: &Node| matches!(node.value, Value::List(_));
        if count == 1 && !is_list(&rows[0]) {
            return Ok(rows
                .into_iter()
                .map(|node| self.row(matrix, 0, node.place.clone(), vec![node], words))
                .collect());
        }
        let mut taken = Vec::new();
        for (index, Node { place, value }) in rows.into_iter().enumerate() {
            let Value::List(entries) = value else { return Err(count) };
            taken.push(self.row(matrix, index, place, entries, words));
        }
        Ok(taken)
    }

    fn row(&mut self, matrix: MatrixName, row: usize, place: Place, entries: Vec<Node>, words: &Words) -> Row {
        let count = entries.len();
        let mut entry = |(column, Node { place, value }): (usize, Node)| {
            self.entry_of(entry_name(matrix, row, column, count), place, value, words)
        };
        Row { place, entries: entries.into_iter().enumerate().map(&mut entry).collect() }
    }

    /// Takes the entries of a matrix, if it has as many rows and columns as there are coordinates.
    pub fn take_entries(&mut self, given: Given, count: usize) {
        let before = self.problems.len();
        self.check_rows(&given, Some(count));
        if self.problems.len() > before {
            return;
        }
        for (row, Row { entries, .. }) in given.rows.into_iter().flatten().enumerate() {
            let named = |(column, entry)| Entry { name: entry_name(given.matrix, row, column, count), ..entry };
            self.entries.extend(entries.into_iter().enumerate().map(named));
        }
    }

    /// Tells what is wrong with the shape of a matrix, which must have as many rows as there are coordinates; where they are
    /// not known, as many as it has columns.
    pub fn check_rows(&mut self, Given { matrix, place, rows }: &Given, count: Option<usize>) {
        let rows = match rows {
            Ok(rows) if !rows.is_empty() => rows,
            found => {
                let found = found.as_ref().map_or_else(|count| format!("one list of {count}"), |_| "empty".to_owned());
                let message = format!("`{matrix}` is {found}; expected a list of rows, such as [[1, 0], [0, 1]]");
                return self.problem(place.clone(), message);
            }
        };
        let count = count.unwrap_or(rows.len());
        if rows.len() != count {
            let (found, shape) = (plural(rows.len(), "row"), shape(count));
            return self.problem(place.clone(), format!("`{matrix}` has {found}; expected {shape}, as `M` has"));
        }
        for (index, Row { place, entries }) in rows.iter().enumerate().filter(|(_, row)| row.entries.len() != count) {
            let (row, found) = (index + 1, plural(entries.len(), "number"));
            let message = format!("row {row} of `{matrix}` has {found}; expected {count}, as many as there are rows");
            self.problem(place.clone(), message);
        }
    }
}

/// `2 rows of 2 numbers`
pub fn shape(count: usize) -> String {
    format!("{} of {}", plural(count, "row"), plural(count, "number"))
}

fn plural(count: usize, noun: &str) -> String {
    let s = if count == 1 { "" } else { "s" };
    format!("{count} {noun}{s}")
}
