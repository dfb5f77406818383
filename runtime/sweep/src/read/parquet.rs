//! Designs from Parquet.

use std::path::{Path, PathBuf};

use carvallo_design::{Failure, Place, Problem};
use parquet::basic::{Compression, ConvertedType, Repetition, Type as Physical};
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader as _, SerializedFileReader};
use parquet::schema::types::Type;

use super::chunk::Chunk;
use super::rows::{Named, Rows};
use crate::table::parquet_message;

/// The rows of a file.
pub struct Records {
    path: PathBuf,
    reader: SerializedFileReader<std::fs::File>,
    /// The number of the next row group.
    next: usize,
    /// The columns of the row group before, as far as they are not read, and how many rows of it are left.
    chunks: Vec<Chunk>,
    left: usize,
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
        Ok(Self { path: path.to_owned(), reader: open(path)?, next: 0, chunks: Vec::new(), left: 0 })
    }

    /// Adds the next rows, at most so many.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn read(&mut self, rows: &mut Rows, most: usize) -> Result<(), Failure> {
        self.fill(rows, most).map_err(|error| fail(&self.path, error))
    }

    fn fill(&mut self, rows: &mut Rows, most: usize) -> Result<(), ParquetError> {
        while rows.designs.rows < most {
            if self.left == 0 {
                if self.next == self.reader.num_row_groups() {
                    break;
                }
                let group = self.reader.get_row_group(self.next)?;
                self.chunks = (0..group.num_columns()).map(|at| Chunk::open(&*group, at)).collect::<Result<_, _>>()?;
                self.left = group.metadata().num_rows().try_into().unwrap_or_default();
                self.next += 1;
                continue;
            }
            let (first, count) = (rows.designs.rows, self.left.min(most - rows.designs.rows));
            rows.extend(count);
            for (column, chunk) in self.chunks.iter_mut().enumerate() {
                chunk.read(count, |row, cell| rows.put(column, first + row, cell))?;
            }
            self.left -= count;
        }
        Ok(())
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
    for (Named { name, parameter, .. }, field) in columns.iter().zip(fields) {
        let is_copied = parameter.is_none();
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
