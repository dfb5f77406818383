//! Tables for documents: what a command found, once, and each language that it is written in.
//!
//! A command fills a [`Document`]: tables with headings, in which units stand, and cells with the numbers as they are
//! printed at a terminal. The languages know nothing of bicycles.

mod latex;
mod markdown;
mod terminal;

use carvallo::ParameterInfo;

/// Languages of documents.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    Markdown,
    Latex,
}

/// What a command found.
pub struct Document {
    pub title: String,
    /// Sentences below the title, such as where the parameters come from.
    pub about: Vec<String>,
    pub tables: Vec<Table>,
}

/// A table, with sentences below it.
pub struct Table {
    pub title: String,
    pub columns: Vec<Column>,
    /// Each with a cell for every column.
    pub rows: Vec<Vec<Cell>>,
    pub notes: Vec<String>,
}

/// A column of a table.
pub struct Column {
    pub heading: Cell,
    pub side: Side,
}

/// Where the texts of a column stand below each other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    Left,
    Right,
}

/// What stands in a cell.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Cell {
    /// Words, perhaps with numbers and units in them.
    Words(String),
    /// Numbers with their signs, exponents and `i`; several are separated by commas.
    Number(String),
    /// The name of a parameter or a coordinate, and its symbol in formulas.
    Symbol { name: String, symbol: String },
}

impl Document {
    /// The document in a language.
    pub fn write(&self, language: Language) -> String {
        match language {
            Language::Markdown => markdown::write(self),
            Language::Latex => latex::write(self),
        }
    }

    /// The document at a terminal.
    pub fn at_terminal(&self) -> String {
        terminal::write(self)
    }
}

impl Column {
    /// Of words, which begin below each other.
    pub fn left(heading: impl Into<String>) -> Self {
        Self { heading: Cell::words(heading), side: Side::Left }
    }

    /// Of numbers, which end below each other.
    pub fn right(heading: impl Into<String>) -> Self {
        Self { heading: Cell::words(heading), side: Side::Right }
    }
}

impl Cell {
    pub fn words(text: impl Into<String>) -> Self {
        Self::Words(text.into())
    }

    /// Of a parameter.
    pub fn parameter(ParameterInfo { name, symbol, .. }: &ParameterInfo) -> Self {
        Self::Symbol { name: (*name).to_owned(), symbol: (*symbol).to_owned() }
    }

    pub fn number(text: impl Into<String>) -> Self {
        Self::Number(text.into())
    }
}

/// A line of cells, each with spaces up to the width of its column.
fn aligned(cells: &[String], widths: &[usize], columns: &[Column]) -> Vec<String> {
    let cell = |((cell, width), column): ((&String, &usize), &Column)| match column.side {
        Side::Left => format!("{cell:<width$}"),
        Side::Right => format!("{cell:>width$}"),
    };
    cells.iter().zip(widths).zip(columns).map(cell).collect()
}

/// The widths of the columns of lines of cells.
fn widths(lines: &[Vec<String>], least: usize) -> Vec<usize> {
    let columns = lines.iter().map(Vec::len).max().unwrap_or(0);
    let widest = |column: usize| {
        lines.iter().filter_map(|line| line.get(column)).map(|cell| cell.chars().count()).fold(least, usize::max)
    };
    (0..columns).map(widest).collect()
}

/// A note with a capital letter, since it stands by itself; a symbol that it begins with, as in `g = 9.81`, keeps its own.
fn sentence(note: &str) -> String {
    if note.split_whitespace().nth(1) == Some("=") {
        return note.to_owned();
    }
    let mut letters = note.chars();
    letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect()
}
