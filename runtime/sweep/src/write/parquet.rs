//! Results as Parquet.
//!
//! A file cannot grow: what is in it stands at its end. So each batch is a small file of its own, behind the one before,
//! and when all are there they become the row groups of one file by another end, which tells where their columns are.

use std::io::{Read, Seek, SeekFrom};
use std::sync::Arc;

use carvallo_design::number;
use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int32Type};
use parquet::errors::ParquetError;
use parquet::file::FOOTER_SIZE;
use parquet::file::metadata::{
    FileMetaData, FooterTail, KeyValue, ParquetMetaData, ParquetMetaDataReader, ParquetMetaDataWriter, RowGroupMetaData,
};
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{ColumnPath, Type, TypePtr};

use crate::table::{Column, Heading, Kind, written};

/// One row group, as a file of its own. The parts of a column come one after the other.
///
/// # Errors
/// What the library says.
pub fn part(headings: &[Heading], tables: &[Vec<Column>]) -> Result<Vec<u8>, ParquetError> {
    let mut bytes = Vec::new();
    // Of the type that the end is written to as well: for each the library is compiled once.
    let mut writer = SerializedFileWriter::new(&mut bytes, schema(headings)?, Arc::new(properties(headings)))?;
    let mut group = writer.next_row_group()?;
    for index in 0..headings.len() {
        if let Some(mut column) = group.next_column()? {
            tables.iter().try_for_each(|table| write(&mut column, &table[index]))?;
            column.close()?;
        }
    }
    group.close()?;
    writer.close()?;
    Ok(bytes)
}

fn write(writer: &mut SerializedColumnWriter, column: &Column) -> Result<(), ParquetError> {
    fn levels<T>(values: &[Option<T>]) -> Vec<i16> {
        values.iter().map(|value| i16::from(value.is_some())).collect()
    }
    match column {
        Column::Numbers(values) => {
            let numbers: Vec<f64> = values.iter().flatten().copied().collect();
            writer.typed::<DoubleType>().write_batch(&numbers, Some(&levels(values)), None)?;
        }
        Column::Counts(values) => {
            let counts: Vec<i32> = values.iter().flatten().copied().collect();
            writer.typed::<Int32Type>().write_batch(&counts, Some(&levels(values)), None)?;
        }
        Column::Texts(values) => {
            let texts: Vec<ByteArray> = values.iter().flatten().map(|text| ByteArray::from(text.as_ref())).collect();
            writer.typed::<ByteArrayType>().write_batch(&texts, Some(&levels(values)), None)?;
        }
    }
    Ok(())
}

/// Every column may be without a value.
fn schema(headings: &[Heading]) -> Result<TypePtr, ParquetError> {
    let column = |heading: &Heading| {
        let (physical, logical) = match heading.kind {
            Kind::Number => (Physical::DOUBLE, None),
            Kind::Count => (Physical::INT32, None),
            Kind::Text => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        };
        let builder = Type::primitive_type_builder(&heading.name, physical).with_logical_type(logical);
        builder.with_repetition(Repetition::OPTIONAL).build().map(Arc::new)
    };
    let columns = headings.iter().map(column).collect::<Result<_, _>>()?;
    Type::group_type_builder("sweep").with_fields(columns).build().map(Arc::new)
}

/// What is read of a file is a column of a row group and no page of it alone. Numbers are seldom the same in two rows, and
/// a dictionary of them would take as much again.
fn properties(headings: &[Heading]) -> WriterProperties {
    let builder = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_created_by(format!("carvallo {}", env!("CARGO_PKG_VERSION")))
        .set_statistics_enabled(EnabledStatistics::Chunk)
        .set_offset_index_disabled(true);
    let numbers = headings.iter().filter(|heading| heading.kind == Kind::Number);
    let columns = numbers.map(|heading| ColumnPath::from(vec![heading.name.clone()]));
    columns.fold(builder, |builder, column| builder.set_column_dictionary_enabled(column, false)).build()
}

/// The end of a file of parts, which stand one after the other and are each as long as it is said. The units of the columns
/// go into the metadata of the file, as `unit:w` = `m`.
///
/// # Errors
/// If the parts cannot be read, or are none.
pub fn footer(
    headings: &[Heading],
    parts: &mut (impl Read + Seek),
    lengths: impl Iterator<Item = u64>,
) -> Result<Vec<u8>, ParquetError> {
    let mut groups = Vec::new();
    let mut last = None;
    let mut start = 0;
    for length in lengths {
        let part = metadata(parts, start + length)?;
        for group in part.row_groups() {
            groups.push(moved(group, start as i64, groups.len())?);
        }
        start += length;
        last = Some(part);
    }
    let part = last.ok_or_else(|| ParquetError::General("there is no part".to_owned()))?;
    let part = part.file_metadata();
    let units = headings.iter().filter(|heading| !heading.unit.is_empty());
    let units = units.map(|heading| KeyValue::new(format!("unit:{}", heading.name), number::unit(written(heading))));
    let file = FileMetaData::new(
        part.version(),
        groups.iter().map(RowGroupMetaData::num_rows).sum(),
        part.created_by().map(str::to_owned),
        Some(units.collect()),
        part.schema_descr_ptr(),
        part.column_orders().cloned(),
    );
    let mut bytes = Vec::new();
    ParquetMetaDataWriter::new(&mut bytes, &ParquetMetaData::new(file, groups)).finish()?;
    Ok(bytes)
}

/// What a part that ends there says of itself.
fn metadata(parts: &mut (impl Read + Seek), end: u64) -> Result<ParquetMetaData, ParquetError> {
    let mut tail = [0; FOOTER_SIZE];
    parts.seek(SeekFrom::Start(end - FOOTER_SIZE as u64))?;
    parts.read_exact(&mut tail)?;
    let mut bytes = vec![0; FooterTail::try_new(&tail)?.metadata_length()];
    parts.seek(SeekFrom::Start(end.saturating_sub((FOOTER_SIZE + bytes.len()) as u64)))?;
    parts.read_exact(&mut bytes)?;
    ParquetMetaDataReader::decode_metadata(&bytes)
}

/// A row group of a part that starts there.
fn moved(group: &RowGroupMetaData, start: i64, ordinal: usize) -> Result<RowGroupMetaData, ParquetError> {
    let columns = group.columns().iter().map(|column| {
        let dictionary = column.dictionary_page_offset().map(|offset| offset + start);
        let builder = column.clone().into_builder().set_dictionary_page_offset(dictionary);
        builder.set_data_page_offset(column.data_page_offset() + start).build()
    });
    let mut builder = group.clone().into_builder().set_column_metadata(columns.collect::<Result<_, _>>()?);
    if let Some(offset) = group.file_offset() {
        builder = builder.set_file_offset(offset + start);
    }
    let ordinal = ordinal.try_into().map_err(|_| ParquetError::General("there are too many row groups".to_owned()))?;
    builder.set_ordinal(ordinal).build()
}
