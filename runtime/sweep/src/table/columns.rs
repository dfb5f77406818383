//! Columns: what they are called, and the values that they hold.

use std::borrow::Cow;

/// The name, the unit and the kind of a column.
#[derive(Clone, Debug, PartialEq)]
pub struct Heading {
    pub name: String,
    /// As declared, such as `kg*m^2`; empty where there is none.
    pub unit: &'static str,
    pub kind: Kind,
}

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    Number,
    Count,
    Text,
}

/// The values of a column; `None` where there is none.
#[derive(Clone, Debug, PartialEq)]
pub enum Column {
    Numbers(Vec<Option<f64>>),
    Counts(Vec<Option<i32>>),
    Texts(Vec<Option<Cow<'static, str>>>),
}

impl Heading {
    pub fn number(name: impl Into<String>, unit: &'static str) -> Self {
        Self { name: name.into(), unit, kind: Kind::Number }
    }

    pub fn count(name: &str) -> Self {
        Self { name: name.to_owned(), unit: "", kind: Kind::Count }
    }

    pub fn text(name: impl Into<String>) -> Self {
        Self { name: name.into(), unit: "", kind: Kind::Text }
    }
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
