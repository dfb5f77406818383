//! The values that columns hold.

use std::borrow::Cow;

use carvallo_plot::analysis::columns::{Cell, Kind, VERDICTS};

/// The values of a column; `None` where there is none.
#[derive(Clone, Debug, PartialEq)]
pub enum Column {
    Numbers(Vec<Option<f64>>),
    Counts(Vec<Option<i32>>),
    Texts(Vec<Option<Cow<'static, str>>>),
}

impl Column {
    /// Without values yet, but with room for so many.
    pub fn new(kind: Kind, rows: usize) -> Self {
        match kind {
            Kind::Number => Self::Numbers(Vec::with_capacity(rows)),
            Kind::Count => Self::Counts(Vec::with_capacity(rows)),
            Kind::Text => Self::Texts(Vec::with_capacity(rows)),
        }
    }

    /// Adds a row with the value of one design.
    pub fn push(&mut self, cell: Cell) {
        match (self, cell) {
            (Self::Numbers(values), Cell::Number(value)) => values.push(value),
            (Self::Counts(values), Cell::Count(count)) => values.push(i32::try_from(count).ok()),
            (Self::Texts(values), Cell::Verdict(place)) => values.push(Some(Cow::Borrowed(VERDICTS[place]))),
            // Headings and cells are in one order.
            (column, _) => column.push_none(),
        }
    }

    /// Adds a row without a value.
    pub fn push_none(&mut self) {
        match self {
            Self::Numbers(values) => values.push(None),
            Self::Counts(values) => values.push(None),
            Self::Texts(values) => values.push(None),
        }
    }

    /// The number in a row, if it is one.
    pub fn number(&self, row: usize) -> Option<f64> {
        match self {
            Self::Numbers(values) => values.get(row).copied().flatten(),
            _ => None,
        }
    }
}
