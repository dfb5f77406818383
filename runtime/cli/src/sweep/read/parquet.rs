//! Designs from Parquet.

use std::path::{Path, PathBuf};

use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader as _, SerializedFileReader};
use parquet::record::Field;
use parquet::record::reader::RowIter;

use super::{Cell, Rows};
use crate::failure::Failure;

/// The rows of a file.
pub struct Records {
    path: PathBuf,
    rows: RowIter<'static>,
}

fn open(path: &Path) -> Result<SerializedFileReader<std::fs::File>, Failure> {
    let file = std::fs::File::open(path).map_err(|error| fail(path, error.into()))?;
    SerializedFileReader::new(file).map_err(|error| fail(path, error))
}

fn fail(path: &Path, error: ParquetError) -> Failure {
    Failure::Run(format!("cannot read {}: {error}", path.display()))
}

/// The names of the columns.
///
/// # Errors
/// If the file cannot be read.
pub fn names(path: &Path) -> Result<Vec<String>, Failure> {
    let reader = open(path)?;
    let fields = reader.metadata().file_metadata().schema().get_fields();
    Ok(fields.iter().map(|field| field.name().to_owned()).collect())
}

impl Records {
    /// # Errors
    /// If the file cannot be read.
    pub fn open(path: &Path) -> Result<Self, Failure> {
        Ok(Self { path: path.to_owned(), rows: open(path)?.into_iter() })
    }

    /// Adds the next row; whether there is one.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub(super) fn next(&mut self, rows: &mut Rows) -> Result<bool, Failure> {
        let Some(row) = self.rows.next() else { return Ok(false) };
        let row = row.map_err(|error| fail(&self.path, error))?;
        rows.add(row.get_column_iter().map(|(_, field)| cell(field)));
        Ok(true)
    }
}

fn cell(field: &Field) -> Cell<'_> {
    match field {
        Field::Null => Cell::Empty,
        Field::Double(value) => Cell::Number(*value),
        Field::Float(value) => Cell::Number(f64::from(*value)),
        Field::Byte(value) => Cell::Number(f64::from(*value)),
        Field::Short(value) => Cell::Number(f64::from(*value)),
        Field::Int(value) => Cell::Number(f64::from(*value)),
        Field::Long(value) => Cell::Number(*value as f64),
        Field::UByte(value) => Cell::Number(f64::from(*value)),
        Field::UShort(value) => Cell::Number(f64::from(*value)),
        Field::UInt(value) => Cell::Number(f64::from(*value)),
        Field::ULong(value) => Cell::Number(*value as f64),
        Field::Str(text) => Cell::Text(text),
        Field::Bool(_) => Cell::Other("a boolean"),
        Field::Date(_) => Cell::Other("a date"),
        _ => Cell::Other("neither a number nor text"),
    }
}
