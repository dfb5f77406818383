//! Designs from a file: a row each.

mod csv;
mod lines;
mod parquet;

use std::path::{Path, PathBuf};

use carvallo::{ModelInfo, ParameterInfo};

use super::axis::position;
use super::columns::{Column, Kind};
use super::evaluate::Designs;
use super::write::Format;
use crate::failure::{Failure, Place, Problem};
use crate::input::evaluated;
use crate::number::shortest;

/// Columns that are no parameters; they are copied to the result.
const COPIED: [&str; 2] = ["name", "id"];

/// A file of designs, of which the columns are known.
pub struct File {
    pub path: PathBuf,
    format: Format,
    info: &'static ModelInfo,
    /// Their names, and where their parameters are among those of the model.
    pub columns: Vec<(String, Option<usize>)>,
}

/// The rows of a file, one after the other.
pub enum Records {
    Csv(csv::Records),
    Parquet(parquet::Records),
}

/// A value of a file.
enum Cell<'a> {
    Number(f64),
    /// Wide enough for every integer of a file.
    Integer(i128),
    Text(&'a str),
    Empty,
    /// Bytes that are not UTF-8.
    NotText,
}

impl File {
    /// # Errors
    /// If the file cannot be read, and everything that is wrong with its columns.
    pub fn open(path: &Path, format: Format, info: &'static ModelInfo) -> Result<Self, Failure> {
        let label = path.display().to_string();
        // Files are read more than once, and reading others may never end.
        if std::fs::metadata(path).is_ok_and(|metadata| !metadata.is_file()) {
            let message = "expected a regular file".to_owned();
            return Err(Failure::Input(vec![Problem { place: Place::Option(format!("--designs {label}")), message }]));
        }
        let names = match format {
            Format::Csv => csv::names(path)?,
            Format::Parquet => parquet::names(path)?,
        };
        let mut problems = Vec::new();
        let mut problem = |message| problems.push(Problem { place: Place::File(label.clone()), message });
        let mut columns: Vec<(String, Option<usize>)> = Vec::new();
        for name in names {
            if columns.iter().any(|(other, _)| *other == name) {
                problem(format!("there are two columns `{name}`"));
            }
            let position = match position(&name, info) {
                Ok(position) => Some(position),
                Err(_) if COPIED.contains(&name.as_str()) => None,
                Err(message) => {
                    problem(format!("column {message}"));
                    None
                }
            };
            columns.push((name, position));
        }
        if columns.iter().all(|(_, position)| position.is_none()) && problems.is_empty() {
            problems
                .push(Problem { place: Place::File(label.clone()), message: "no column is a parameter".to_owned() });
        }
        if !problems.is_empty() {
            return Err(Failure::Input(problems));
        }
        match format {
            Format::Csv => csv::check(path)?,
            Format::Parquet => parquet::check(path, &columns)?,
        }
        let file = Self { path: path.to_owned(), format, info, columns };
        if file.designs(&mut file.records()?, 1)?.rows == 0 {
            let message = "there is no design: no row follows the names of the columns".to_owned();
            return Err(Failure::Input(vec![Problem { place: Place::File(label), message }]));
        }
        Ok(file)
    }

    /// # Errors
    /// If the file cannot be read.
    pub fn records(&self) -> Result<Records, Failure> {
        Ok(match self.format {
            Format::Csv => Records::Csv(csv::Records::open(&self.path)?),
            Format::Parquet => Records::Parquet(parquet::Records::open(&self.path)?),
        })
    }

    /// The next designs, at most so many.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn designs(&self, records: &mut Records, most: usize) -> Result<Designs, Failure> {
        let column = |(_, position): &(String, Option<usize>)| match position {
            Some(_) => Column::new(Kind::Number, most),
            None => Column::new(Kind::Text, most),
        };
        let columns = self.columns.iter().map(column).collect();
        let mut rows = Rows { file: self, designs: Designs { rows: 0, columns, faults: Vec::with_capacity(most) } };
        while rows.designs.rows < most {
            let is_there = match records {
                Records::Csv(records) => records.next(&mut rows)?,
                Records::Parquet(records) => records.next(&mut rows)?,
            };
            if !is_there {
                break;
            }
            rows.designs.rows += 1;
        }
        Ok(rows.designs)
    }
}

/// Designs to which rows are added.
struct Rows<'a> {
    file: &'a File,
    designs: Designs,
}

impl Rows<'_> {
    /// A row that has the cells of the columns.
    fn add<'c>(&mut self, cells: impl Iterator<Item = Cell<'c>>) {
        let mut fault = None;
        for ((cell, column), (name, position)) in cells.zip(&mut self.designs.columns).zip(&self.file.columns) {
            match column {
                Column::Numbers(values) => {
                    let parameter = position.map(|position| &self.file.info.parameters[position]);
                    match parameter.map_or(Ok(None), |parameter| number(cell, parameter).map(Some)) {
                        Ok(value) => values.push(value),
                        Err(message) => {
                            fault.get_or_insert(message);
                            values.push(None);
                        }
                    }
                }
                Column::Texts(values) => values.push(match cell {
                    Cell::Text(text) => Some(text.to_owned().into()),
                    Cell::Integer(integer) => Some(integer.to_string().into()),
                    Cell::Number(number) => Some(shortest(number).into()),
                    Cell::Empty => None,
                    Cell::NotText => {
                        fault.get_or_insert_with(|| format!("`{name}` is not UTF-8 text"));
                        None
                    }
                }),
                Column::Counts(values) => values.push(None),
            }
        }
        self.designs.faults.push(fault);
    }

    /// A row that cannot be read.
    fn add_fault(&mut self, fault: String) {
        self.designs.columns.iter_mut().for_each(Column::push_none);
        self.designs.faults.push(Some(fault));
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
            _ => match evaluated(text, info) {
                Ok(value) => return Ok(value),
                Err(found) => found,
            },
        },
        Cell::Empty => "empty; expected a number".to_owned(),
        Cell::NotText => "not UTF-8 text; expected a number".to_owned(),
    };
    Err(format!("`{}` is {found}", info.name))
}
