//! `carvallo sweep`: many designs at once.

mod designs;
mod maps;
mod mistakes;
mod names;
mod results;
mod resume;
mod tables;

use crate::{Directory, Run};

/// Rows of text by the names of their columns.
struct Table {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    /// Fields here have no line feeds.
    fn read(text: &str) -> Self {
        let mut lines = text.lines().map(fields);
        let header = lines.next().unwrap();
        let rows: Vec<_> = lines.collect();
        assert!(rows.iter().all(|row| row.len() == header.len()), "{text}");
        Self { header, rows }
    }

    #[track_caller]
    fn text(&self, row: usize, column: &str) -> &str {
        let index = self.header.iter().position(|name| name == column);
        &self.rows[row][index.unwrap_or_else(|| panic!("there is no column {column}: {:?}", self.header))]
    }

    /// `None` for an empty field.
    #[track_caller]
    fn number(&self, row: usize, column: &str) -> Option<f64> {
        Some(self.text(row, column)).filter(|text| !text.is_empty()).map(|text| text.parse().unwrap())
    }

    fn column(&self, column: &str) -> Vec<f64> {
        (0..self.rows.len()).map(|row| self.number(row, column).unwrap()).collect()
    }

    /// The numbered columns of a kind that are not empty.
    fn numbered(&self, row: usize, kind: &str) -> Vec<f64> {
        let names = (1..).map(|index| format!("{kind}_{index}"));
        names.take_while(|name| self.header.contains(name)).filter_map(|name| self.number(row, &name)).collect()
    }
}

/// The fields of a line of CSV.
fn fields(line: &str) -> Vec<String> {
    let mut fields = vec![String::new()];
    let mut quoted = false;
    let mut chars = line.chars().peekable();
    while let Some(char) = chars.next() {
        match char {
            '"' if quoted && chars.peek() == Some(&'"') => {
                chars.next();
                fields.last_mut().unwrap().push('"');
            }
            '"' => quoted = !quoted,
            ',' if !quoted => fields.push(String::new()),
            char => fields.last_mut().unwrap().push(char),
        }
    }
    fields
}

/// What a sweep prints that must succeed.
#[track_caller]
fn table(run: Run) -> Table {
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    Table::read(&run.stdout)
}

#[track_caller]
fn sweep(arguments: &[&str]) -> Table {
    table(Directory::of_this_test().run(&[&["sweep"], arguments].concat()))
}
