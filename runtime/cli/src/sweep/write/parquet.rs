//! Results as Parquet.
//!
//! A file cannot grow: what is in it stands at its end. So each batch is first kept as a small file of its own, and when
//! all are there their columns are copied, as they are, into row groups of one file.

use std::fs::File;
use std::io::{BufReader, BufWriter, Read as _, Write};
use std::path::Path;
use std::sync::Arc;

use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
use parquet::column::writer::ColumnCloseResult;
use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int32Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::{KeyValue, ParquetMetaDataReader};
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{Type, TypePtr};

use crate::number;
use crate::sweep::table::{Column, Heading, Kind};

/// One row group, as a file of its own. The parts of a column come one after the other.
///
/// # Errors
/// What the library says.
pub fn part(headings: &[Heading], tables: &[Vec<Column>]) -> Result<Vec<u8>, ParquetError> {
    let mut writer = SerializedFileWriter::new(Vec::new(), schema(headings)?, Arc::new(properties(&[])))?;
    let mut group = writer.next_row_group()?;
    for index in 0..headings.len() {
        if let Some(mut column) = group.next_column()? {
            tables.iter().try_for_each(|table| write(&mut column, &table[index]))?;
            column.close()?;
        }
    }
    group.close()?;
    writer.into_inner()
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

/// The units of the columns go into the metadata of the file, as `unit:w` = `m`.
fn properties(headings: &[Heading]) -> WriterProperties {
    let units = headings.iter().filter(|heading| !heading.unit.is_empty());
    let units = units.map(|Heading { name, unit, .. }| KeyValue::new(format!("unit:{name}"), number::unit(unit)));
    WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_created_by(format!("carvallo {}", env!("CARGO_PKG_VERSION")))
        .set_key_value_metadata(Some(units.collect()))
        .build()
}

/// One file of the parts that stand one after the other in another, each as long as it is said.
///
/// # Errors
/// If one of the files cannot be read or written.
pub fn assemble(
    headings: &[Heading],
    parts: &Path,
    lengths: impl Iterator<Item = u64>,
    whole: &Path,
) -> Result<(), ParquetError> {
    let mut parts = BufReader::new(File::open(parts)?);
    let whole = BufWriter::new(File::create(whole)?);
    let mut writer = SerializedFileWriter::new(whole, schema(headings)?, Arc::new(properties(headings)))?;
    for length in lengths {
        let mut part = Vec::new();
        parts.by_ref().take(length).read_to_end(&mut part)?;
        let part = bytes::Bytes::from(part);
        let metadata = ParquetMetaDataReader::new().parse_and_finish(&part)?;
        for group in metadata.row_groups() {
            let mut copy = writer.next_row_group()?;
            for column in group.columns() {
                let close = ColumnCloseResult {
                    bytes_written: column.compressed_size() as u64,
                    rows_written: group.num_rows() as u64,
                    metadata: column.clone(),
                    bloom_filter: None,
                    column_index: None,
                    offset_index: None,
                };
                copy.append_column(&part, close)?;
            }
            copy.close()?;
        }
    }
    let mut whole = writer.into_inner()?;
    whole.flush()?;
    Ok(whole.get_ref().sync_all()?)
}
