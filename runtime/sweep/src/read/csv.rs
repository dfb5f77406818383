//! Designs from comma-separated values; also from those that spreadsheets separate by semicolons or tabs where the comma is
//! in numbers.

use std::fs::File;
use std::io::{Cursor, Read, Seek as _};
use std::path::{Path, PathBuf};

use carvallo_design::input::in_utf8;
use carvallo_design::quantity::signs;
use carvallo_design::{Failure, Place};
use csv::{ByteRecord, Reader, ReaderBuilder, Trim};

use super::lines::{LineProblem, Lines};
use super::rows::{Cell, Named, Rows};

/// The rows of a file.
pub struct Records {
    path: PathBuf,
    reader: Reader<Lines<Source>>,
    separator: u8,
    record: ByteRecord,
    columns: usize,
    has_both_signs: bool,
}

/// The bytes of a file.
type Source = Box<dyn Read + Send>;

/// As they are, or in UTF-8 if they are in UTF-16, as spreadsheets write "Unicode text": all at once then. Of a table the first sign is
/// none of those of which both halves count.
fn source(path: &Path) -> std::io::Result<Source> {
    let mut file = File::open(path)?;
    let mut mark = Vec::new();
    file.by_ref().take(2).read_to_end(&mut mark)?;
    file.rewind()?;
    if mark != b"\xff\xfe" && mark != b"\xfe\xff" && !mark.contains(&0) {
        return Ok(Box::new(file));
    }
    let mut bytes = Vec::new();
    file.read_to_end(&mut bytes)?;
    Ok(Box::new(Cursor::new(in_utf8(bytes))))
}

fn open(path: &Path, separator: u8) -> Result<Reader<Lines<Source>>, Failure> {
    let file = source(path).map_err(|error| cannot_read(path, error))?;
    let mut builder = ReaderBuilder::new();
    builder.flexible(true).trim(Trim::All).delimiter(separator);
    Ok(builder.from_reader(Lines::new(file, separator)))
}

/// What separates the fields: a comma, unless there is none in the header but another separator.
fn separator(path: &Path) -> Result<u8, Failure> {
    let mut reader = open(path, b',')?;
    let header = reader.byte_headers().map_err(|error| fail(path, error))?;
    Ok(match header.iter().collect::<Vec<_>>()[..] {
        [only] => [b';', b'\t'].into_iter().find(|separator| only.contains(separator)).unwrap_or(b','),
        _ => b',',
    })
}

fn fail(path: &Path, error: csv::Error) -> Failure {
    match error.into_kind() {
        csv::ErrorKind::Io(error) => cannot_read(path, error),
        // Only reading can fail where rows may have any number of fields, of bytes.
        other => Failure::Run(format!("cannot read {}: {other:?}", path.display())),
    }
}

/// A line that is wrong is the user's mistake.
fn cannot_read(path: &Path, error: std::io::Error) -> Failure {
    let label = path.display().to_string();
    match error.get_ref().and_then(|error| error.downcast_ref()) {
        Some(LineProblem { line, message }) => Failure::at(Place::Line(label, *line), *message),
        None => Failure::Run(format!("cannot read {label}: {error}")),
    }
}

/// The names in the first line.
///
/// # Errors
/// If the file cannot be read.
pub fn names(path: &Path) -> Result<Vec<String>, Failure> {
    let mut reader = open(path, separator(path)?)?;
    let header = reader.byte_headers().map_err(|error| fail(path, error))?;
    Ok(header.iter().map(|name| String::from_utf8_lossy(&in_utf8(name.to_vec())).into_owned()).collect())
}

/// Reads the whole file, so that a line that is wrong is found before anything is computed. Whether decimals of parameters
/// stand behind points and behind commas: that is nowhere a question where commas separate the fields.
///
/// # Errors
/// If the file cannot be read, or a line is wrong.
pub fn check(path: &Path, columns: &[Named]) -> Result<bool, Failure> {
    let separator = separator(path)?;
    if separator == b',' {
        let file = source(path).map_err(|error| cannot_read(path, error))?;
        let mut lines = std::io::BufReader::with_capacity(1 << 16, Lines::new(file, separator));
        return std::io::copy(&mut lines, &mut std::io::sink())
            .map_err(|error| cannot_read(path, error))
            .map(|_| false);
    }
    let mut reader = open(path, separator)?;
    let mut record = ByteRecord::new();
    let mut found = [false; 2];
    while reader.read_byte_record(&mut record).map_err(|error| fail(path, error))? {
        let cells = record.iter().zip(columns).filter(|(_, column)| column.parameter.is_some());
        for text in cells.filter_map(|(cell, _)| std::str::from_utf8(cell).ok()) {
            let signs = signs(text);
            found = [found[0] || signs[0], found[1] || signs[1]];
        }
    }
    Ok(found == [true; 2])
}

impl Records {
    /// # Errors
    /// If the file cannot be read.
    pub fn open(path: &Path, has_both_signs: bool) -> Result<Self, Failure> {
        let separator = separator(path)?;
        let mut reader = open(path, separator)?;
        let columns = reader.byte_headers().map_err(|error| fail(path, error))?.len();
        Ok(Self { path: path.to_owned(), reader, separator, record: ByteRecord::new(), columns, has_both_signs })
    }

    /// Adds the next rows, at most so many.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn read(&mut self, rows: &mut Rows, most: usize) -> Result<(), Failure> {
        while rows.designs.rows < most && self.next(rows)? {}
        Ok(())
    }

    /// Adds the next row; whether there is one.
    fn next(&mut self, rows: &mut Rows) -> Result<bool, Failure> {
        let is_there = self.reader.read_byte_record(&mut self.record).map_err(|error| fail(&self.path, error))?;
        if std::str::from_utf8(self.record.as_slice()).is_err() {
            self.record = self.record.iter().map(|field| in_utf8(field.to_vec())).collect();
        }
        if is_there && self.record.len() != self.columns {
            let (found, expected) = (self.record.len(), self.columns);
            let fields = if found == 1 { "field" } else { "fields" };
            rows.add_error(format!("the row has {found} {fields}; the header has {expected}"));
        } else if is_there {
            rows.add(self.record.iter().map(|field| match std::str::from_utf8(field) {
                Ok("") => Cell::Empty,
                // Where commas do not separate fields, they separate decimals.
                Ok(text) if self.separator != b',' => Cell::TextWithCommas(text, self.has_both_signs),
                Ok(text) => Cell::Text(text),
                Err(_) => Cell::NotText,
            }));
        }
        Ok(is_there)
    }
}
