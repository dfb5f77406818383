//! Rows of a file as designs, whatever its format.

use carvallo::ParameterInfo;
use carvallo_design::conventions::{Naming, Varying};
use carvallo_design::input::measured;
use carvallo_design::number::shortest;
use carvallo_design::quantity::{Scale, ambiguous};

use crate::table::{Column, Designs, Kind};

/// A column of a file.
pub struct Named {
    pub name: String,
    /// Its parameter; columns without one are copied.
    pub parameter: Option<Varying>,
    /// What its numbers are in, if that is not the unit of the parameter.
    pub unit: Option<Unit>,
}

/// The unit of a column.
pub struct Unit {
    pub written: String,
    /// To the unit of the parameter.
    pub scale: Scale,
}

/// A value of a file.
pub enum Cell<'a> {
    Number(f64),
    /// Wide enough for every integer of a file.
    Integer(i128),
    Text(&'a str),
    /// Text in which decimals may stand after a comma; whether others in the table stand after points, and others after
    /// commas.
    TextWithCommas(&'a str, bool),
    Empty,
    /// Bytes that are not UTF-8.
    NotText,
}

/// Designs to which rows are added.
pub struct Rows<'a> {
    columns: &'a [Named],
    naming: &'a Naming,
    pub designs: Designs,
}

impl<'a> Rows<'a> {
    /// None yet, but with room for so many.
    pub fn new(columns: &'a [Named], naming: &'a Naming, room: usize) -> Self {
        let column = |named: &Named| match named.parameter {
            Some(_) => Column::new(Kind::Number, room),
            None => Column::new(Kind::Text, room),
        };
        let designs = columns.iter().map(column).collect();
        Self { columns, naming, designs: Designs { rows: 0, columns: designs, errors: Vec::with_capacity(room) } }
    }

    /// A row that has the cells of the columns.
    pub fn add<'c>(&mut self, cells: impl Iterator<Item = Cell<'c>>) {
        self.designs.errors.push(None);
        cells.enumerate().for_each(|(column, cell)| self.put(column, self.designs.rows, cell));
        self.designs.rows += 1;
    }

    /// More rows, whose cells are put into them column by column.
    pub fn extend(&mut self, rows: usize) {
        self.designs.rows += rows;
        self.designs.errors.resize(self.designs.rows, None);
    }

    /// The next cell of a column, which is in a row. Of a row the first mistake is told, so columns come in their order.
    pub fn put(&mut self, column: usize, row: usize, cell: Cell) {
        let Named { name, parameter, unit } = &self.columns[column];
        let error = &mut self.designs.errors[row];
        match &mut self.designs.columns[column] {
            Column::Numbers(values) => {
                let naming = self.naming;
                let found = parameter.as_ref().map(|parameter| match cell {
                    Cell::Text(text) | Cell::TextWithCommas(text, _) if parameter.has_sizes() => {
                        parameter.in_numbers(text, naming).and_then(|text| number(Cell::Text(&text), &parameter.info))
                    }
                    cell => in_unit(cell, &parameter.info, unit.as_ref()),
                });
                match found.transpose() {
                    Ok(value) => values.push(value),
                    Err(message) => {
                        error.get_or_insert(message);
                        values.push(None);
                    }
                }
            }
            Column::Texts(values) => values.push(match cell {
                Cell::Text(text) | Cell::TextWithCommas(text, _) => Some(text.to_owned().into()),
                Cell::Integer(integer) => Some(integer.to_string().into()),
                Cell::Number(number) => Some(shortest(number).into()),
                Cell::Empty => None,
                Cell::NotText => {
                    error.get_or_insert_with(|| format!("`{name}` is not UTF-8 text"));
                    None
                }
            }),
            Column::Counts(values) => values.push(None),
        }
    }

    /// A row that cannot be read.
    pub fn add_error(&mut self, error: String) {
        self.designs.columns.iter_mut().for_each(Column::push_none);
        self.designs.errors.push(Some(error));
        self.designs.rows += 1;
    }
}

/// A number in the unit of the column, unless it has one of its own.
fn in_unit(cell: Cell, info: &ParameterInfo, unit: Option<&Unit>) -> Result<f64, String> {
    let Some(Unit { written, scale }) = unit else { return number(cell, info) };
    let text = match cell {
        Cell::Number(value) if value.is_finite() => return Ok(scale.apply(value)),
        Cell::Integer(value) => return Ok(scale.apply(value as f64)),
        Cell::Text(text) => text,
        Cell::TextWithCommas(text, both) if !both || ambiguous(text).is_none() => {
            let text = if text.contains('.') { text.to_owned() } else { text.replace(',', ".") };
            return in_unit(Cell::Text(&text), info, unit);
        }
        cell => return number(cell, info),
    };
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() && value != 0.0 => Ok(scale.apply(value)),
        _ => match measured(&format!("({text}) {written}"), info) {
            Ok((value, _)) => Ok(value),
            Err(_) => number(Cell::Text(text), info),
        },
    }
}

fn number(cell: Cell, info: &ParameterInfo) -> Result<f64, String> {
    let found = match cell {
        Cell::Number(value) if value.is_finite() => return Ok(value),
        Cell::Number(value) => format!("`{value}`; expected a finite number"),
        Cell::Integer(value) => return Ok(value as f64),
        // Zero may be what is left of a number that is too small.
        Cell::Text(text) => match text.parse::<f64>() {
            Ok(value) if value.is_finite() && value != 0.0 => return Ok(value),
            // Designs are points: how well they were measured is not asked.
            _ => match measured(text, info) {
                Ok((value, _)) => return Ok(value),
                Err(found) => found,
            },
        },
        Cell::TextWithCommas(text, true) if let Some(number) = ambiguous(text) => {
            let both = "decimals stand behind points and behind commas in this table";
            let thousands = number.replace(['.', ','], "");
            format!("`{text}`; {both}: write `{number}0`, or `{thousands}` if thousands are meant")
        }
        // With both signs it is not clear which of them separates thousands.
        Cell::TextWithCommas(text, _) if text.contains(',') && !text.contains('.') => {
            return number(Cell::Text(&text.replace(',', ".")), info);
        }
        Cell::TextWithCommas(text, _) => return number(Cell::Text(text), info),
        Cell::Empty => "empty; expected a number".to_owned(),
        Cell::NotText => "not UTF-8 text; expected a number".to_owned(),
    };
    Err(format!("`{}` is {found}", info.name))
}
