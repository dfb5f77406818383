//! Designs from Parquet.

use std::path::{Path, PathBuf};

use parquet::basic::{Compression, ConvertedType, Repetition, Type as Physical};
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader as _, SerializedFileReader};
use parquet::record::Field;
use parquet::record::reader::RowIter;
use parquet::schema::types::Type;

use super::rows::{Cell, Named, Rows};
use crate::failure::{Failure, Place, Problem};
use crate::sweep::table::parquet_message;

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
    Failure::Run(format!("cannot read {}: {}", path.display(), parquet_message(error)))
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
    pub fn next(&mut self, rows: &mut Rows) -> Result<bool, Failure> {
        let Some(row) = self.rows.next() else { return Ok(false) };
        let row = row.map_err(|error| fail(&self.path, error))?;
        rows.add(row.get_column_iter().map(|(_, field)| cell(field)));
        Ok(true)
    }
}

/// Reads what the file says of its columns, so that what cannot be used is found before anything is computed.
///
/// # Errors
/// If the file cannot be read, or a column is of a kind or compressed in a way that is not read.
pub fn check(path: &Path, columns: &[Named]) -> Result<(), Failure> {
    let reader = open(path)?;
    let mut problems = Vec::new();
    let mut problem = |message| {
        let place = Place::File(path.display().to_string());
        problems.push(Problem { place, message });
    };
    let fields = reader.metadata().file_metadata().schema().get_fields();
    for (Named { name, position }, field) in columns.iter().zip(fields) {
        let is_copied = position.is_none();
        if !is_readable(field, is_copied) {
            let expected = if is_copied { "integers or text" } else { "numbers or text" };
            problem(format!("column `{name}` holds {}; expected {expected}", description(field)));
        }
    }
    let chunks = reader.metadata().row_groups().iter().flat_map(|group| group.columns());
    let unknown = chunks.map(|chunk| chunk.compression()).find(|compression| {
        !matches!(
            compression,
            Compression::UNCOMPRESSED
                | Compression::SNAPPY
                | Compression::GZIP(_)
                | Compression::LZ4
                | Compression::LZ4_RAW
        )
    });
    if let Some(compression) = unknown {
        let name = compression.to_string();
        let name = name.split('(').next().unwrap_or_default().to_lowercase();
        problem(format!("it is compressed with {name}; expected snappy, gzip, lz4 or no compression"));
    }
    if problems.is_empty() { Ok(()) } else { Err(Failure::Input(problems)) }
}

/// Whether the values of a column are numbers or text; of those that are copied, integers or text.
fn is_readable(field: &Type, is_copied: bool) -> bool {
    if !field.is_primitive() || field.get_basic_info().repetition() == Repetition::REPEATED {
        return false;
    }
    let info = field.get_basic_info();
    let is_plain = info.converted_type() == ConvertedType::NONE && info.logical_type_ref().is_none();
    match (field.get_physical_type(), info.converted_type()) {
        (Physical::FLOAT | Physical::DOUBLE, _) => !is_copied,
        (Physical::INT32 | Physical::INT64, ConvertedType::NONE) => is_plain,
        (Physical::INT32, ConvertedType::INT_8 | ConvertedType::INT_16 | ConvertedType::INT_32) => true,
        (Physical::INT32, ConvertedType::UINT_8 | ConvertedType::UINT_16 | ConvertedType::UINT_32) => true,
        (Physical::INT64, ConvertedType::INT_64 | ConvertedType::UINT_64) => true,
        (Physical::BYTE_ARRAY, ConvertedType::UTF8 | ConvertedType::ENUM | ConvertedType::JSON) => true,
        _ => false,
    }
}

/// What a column holds, in the words of Parquet.
fn description(field: &Type) -> String {
    if !field.is_primitive() || field.get_basic_info().repetition() == Repetition::REPEATED {
        return "groups or lists".to_owned();
    }
    let physical = field.get_physical_type();
    match (field.get_basic_info().logical_type_ref(), field.get_basic_info().converted_type()) {
        (None, ConvertedType::NONE) => physical.to_string(),
        (None, converted) => format!("{physical} ({converted})"),
        (Some(logical), _) => format!("{physical} ({logical:?})"),
    }
}

fn cell(field: &Field) -> Cell<'_> {
    match field {
        Field::Double(value) => Cell::Number(*value),
        Field::Float(value) => Cell::Number(f64::from(*value)),
        Field::Byte(value) => Cell::Integer((*value).into()),
        Field::Short(value) => Cell::Integer((*value).into()),
        Field::Int(value) => Cell::Integer((*value).into()),
        Field::Long(value) => Cell::Integer((*value).into()),
        Field::UByte(value) => Cell::Integer((*value).into()),
        Field::UShort(value) => Cell::Integer((*value).into()),
        Field::UInt(value) => Cell::Integer((*value).into()),
        Field::ULong(value) => Cell::Integer((*value).into()),
        Field::Str(text) => Cell::Text(text),
        // Columns of other kinds are refused before a row is read.
        _ => Cell::Empty,
    }
}
