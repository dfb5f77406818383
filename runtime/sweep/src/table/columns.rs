//! The values that columns hold.

use std::borrow::Cow;

use carvallo_design::DisplayUnit;
use carvallo_design::units::Units;
use carvallo_plot::analysis::columns::{Cell, Heading, Kind, VERDICTS};

/// The values of a column; `None` where there is none.
#[derive(Clone, Debug, PartialEq)]
pub enum Column {
    Numbers(Vec<Option<f64>>),
    Counts(Vec<Option<i32>>),
    Texts(Vec<Option<Cow<'static, str>>>),
}

/// The unit that the numbers of a column are asked for in, if that is another one; its name then says so, as names in tables of
/// designs may.
pub fn shown_in(heading: &mut Heading, units: &Units) -> Option<DisplayUnit> {
    let unit = units.of(heading.unit);
    if heading.kind != Kind::Number || heading.unit.is_empty() || unit.is_declared() {
        return None;
    }
    heading.name = format!("{} ({})", heading.name, unit.written);
    Some(unit)
}

/// The unit that the numbers of a column are written in: that of its name, if it says one.
pub fn written(heading: &Heading) -> &str {
    let of_name = heading.name.rsplit_once(" (").and_then(|(_, unit)| unit.strip_suffix(')'));
    of_name.unwrap_or(heading.unit)
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

    /// The same numbers in another unit.
    pub fn shown(self, unit: Option<&DisplayUnit>) -> Self {
        match (self, unit) {
            (Self::Numbers(values), Some(unit)) => {
                Self::Numbers(values.into_iter().map(|value| value.map(|value| unit.value(value))).collect())
            }
            (column, _) => column,
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
