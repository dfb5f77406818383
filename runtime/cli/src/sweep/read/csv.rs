//! Designs from comma-separated values.

use std::path::{Path, PathBuf};

use csv::{ByteRecord, Reader, ReaderBuilder, Trim};

use super::{Cell, Rows};
use crate::failure::Failure;

/// The rows of a file.
pub struct Records {
    path: PathBuf,
    reader: Reader<std::fs::File>,
    record: ByteRecord,
    columns: usize,
}

fn open(path: &Path) -> Result<Reader<std::fs::File>, Failure> {
    let mut builder = ReaderBuilder::new();
    builder.flexible(true).trim(Trim::All).comment(Some(b'#'));
    builder.from_path(path).map_err(|error| fail(path, error))
}

fn fail(path: &Path, error: csv::Error) -> Failure {
    Failure::Run(format!("cannot read {}: {error}", path.display()))
}

/// The names in the first line.
///
/// # Errors
/// If the file cannot be read.
pub fn names(path: &Path) -> Result<Vec<String>, Failure> {
    let mut reader = open(path)?;
    let header = reader.byte_headers().map_err(|error| fail(path, error))?;
    Ok(header.iter().map(|name| String::from_utf8_lossy(name).into_owned()).collect())
}

impl Records {
    /// # Errors
    /// If the file cannot be read.
    pub fn open(path: &Path) -> Result<Self, Failure> {
        let mut reader = open(path)?;
        let columns = reader.byte_headers().map_err(|error| fail(path, error))?.len();
        Ok(Self { path: path.to_owned(), reader, record: ByteRecord::new(), columns })
    }

    /// Adds the next row; whether there is one.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub(super) fn next(&mut self, rows: &mut Rows) -> Result<bool, Failure> {
        let is_there = self.reader.read_byte_record(&mut self.record).map_err(|error| fail(&self.path, error))?;
        if is_there && self.record.len() != self.columns {
            let (found, expected) = (self.record.len(), self.columns);
            rows.add_fault(format!("the row has {found} fields; the header has {expected}"));
        } else if is_there {
            rows.add(self.record.iter().map(|field| match std::str::from_utf8(field) {
                Ok("") => Cell::Empty,
                Ok(text) => Cell::Text(text),
                Err(_) => Cell::Other("not UTF-8 text"),
            }));
        }
        Ok(is_there)
    }
}
