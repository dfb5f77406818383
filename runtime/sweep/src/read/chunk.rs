//! A column of a row group of Parquet.

use parquet::basic::ConvertedType;
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, FloatType, Int32Type, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::reader::RowGroupReader;

use super::rows::Cell;

/// The values that are not read yet. Columns of other kinds are refused before a row is read.
pub enum Chunk {
    Double(Values<DoubleType>),
    Float(Values<FloatType>),
    Int32(Values<Int32Type>, bool),
    Int64(Values<Int64Type>, bool),
    Text(Values<ByteArrayType>),
}

/// Values of one kind; with their memory, which serves one call after the other.
pub struct Values<T: DataType> {
    reader: ColumnReaderImpl<T>,
    values: Vec<T::T>,
    /// For each row 1, or 0 where it has no value; empty in columns where each row has one.
    levels: Vec<i16>,
}

impl Chunk {
    /// # Errors
    /// If the file cannot be read.
    pub fn open(group: &dyn RowGroupReader, column: usize) -> Result<Self, ParquetError> {
        let converted = group.metadata().column(column).column_descr().converted_type();
        let is_unsigned = matches!(
            converted,
            ConvertedType::UINT_8 | ConvertedType::UINT_16 | ConvertedType::UINT_32 | ConvertedType::UINT_64
        );
        Ok(match group.get_column_reader(column)? {
            ColumnReader::DoubleColumnReader(reader) => Self::Double(Values::new(reader)),
            ColumnReader::FloatColumnReader(reader) => Self::Float(Values::new(reader)),
            ColumnReader::Int32ColumnReader(reader) => Self::Int32(Values::new(reader), is_unsigned),
            ColumnReader::Int64ColumnReader(reader) => Self::Int64(Values::new(reader), is_unsigned),
            ColumnReader::ByteArrayColumnReader(reader) => Self::Text(Values::new(reader)),
            _ => return Err(ParquetError::General(format!("column {} holds no numbers and no text", column + 1))),
        })
    }

    /// The cells of the next rows, of which there must be so many; the rows are counted from 0 on.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn read(&mut self, rows: usize, mut put: impl FnMut(usize, Cell)) -> Result<(), ParquetError> {
        match self {
            Self::Double(values) => values.read(rows, |row, value| put(row, value.map_or(Cell::Empty, double))),
            Self::Float(values) => values.read(rows, |row, value| {
                put(row, value.map_or(Cell::Empty, |value| Cell::Number(f64::from(*value))));
            }),
            Self::Int32(values, is_unsigned) => values.read(rows, |row, value| {
                let integer = |value: &i32| if *is_unsigned { i128::from(*value as u32) } else { i128::from(*value) };
                put(row, value.map_or(Cell::Empty, |value| Cell::Integer(integer(value))));
            }),
            Self::Int64(values, is_unsigned) => values.read(rows, |row, value| {
                let integer = |value: &i64| if *is_unsigned { i128::from(*value as u64) } else { i128::from(*value) };
                put(row, value.map_or(Cell::Empty, |value| Cell::Integer(integer(value))));
            }),
            Self::Text(values) => values.read(rows, |row, value| put(row, value.map_or(Cell::Empty, text))),
        }
    }
}

fn double(value: &f64) -> Cell<'_> {
    Cell::Number(*value)
}

fn text(value: &ByteArray) -> Cell<'_> {
    std::str::from_utf8(value.data()).map_or(Cell::NotText, Cell::Text)
}

impl<T: DataType> Values<T> {
    fn new(reader: ColumnReaderImpl<T>) -> Self {
        Self { reader, values: Vec::new(), levels: Vec::new() }
    }

    fn read(&mut self, rows: usize, mut put: impl FnMut(usize, Option<&T::T>)) -> Result<(), ParquetError> {
        self.values.clear();
        self.levels.clear();
        let (found, ..) = self.reader.read_records(rows, Some(&mut self.levels), None, &mut self.values)?;
        if found < rows {
            return Err(ParquetError::General("a column has fewer rows than its row group".to_owned()));
        }
        if self.levels.is_empty() {
            self.values.iter().enumerate().for_each(|(row, value)| put(row, Some(value)));
            return Ok(());
        }
        let mut values = self.values.iter();
        for (row, &level) in self.levels.iter().enumerate() {
            put(row, if level > 0 { values.next() } else { None });
        }
        Ok(())
    }
}
