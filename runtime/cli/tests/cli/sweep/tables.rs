//! Files of results and of designs in both formats.

use std::fs::File;
use std::path::Path;
use std::sync::Arc;

use parquet::basic::{Compression, GzipLevel};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DoubleType, FloatType, Int32Type, Int64Type};
use parquet::file::properties::WriterProperties;
use parquet::file::reader::{FileReader as _, SerializedFileReader};
use parquet::file::writer::SerializedFileWriter;
use parquet::record::Field;
use parquet::schema::parser::parse_message_type;

use super::Table;
use crate::Directory;

/// A file of Parquet as text, as CSV has it.
fn read(path: &Path) -> Table {
    let reader = SerializedFileReader::new(File::open(path).unwrap()).unwrap();
    let fields = reader.metadata().file_metadata().schema().get_fields().to_vec();
    let header = fields.iter().map(|field| field.name().to_owned()).collect();
    let text = |field: &Field| match field {
        Field::Null => String::new(),
        Field::Double(value) => format!("{value:?}"),
        Field::Int(value) => value.to_string(),
        Field::Str(text) => text.clone(),
        other => panic!("{other:?}"),
    };
    let rows = reader.get_row_iter(None).unwrap();
    let rows = rows.map(|row| row.unwrap().get_column_iter().map(|(_, field)| text(field)).collect()).collect();
    Table { header, rows }
}

#[test]
fn csv_and_parquet_have_the_same_values() {
    let directory = Directory::new("sweep-formats");
    let vary = ["sweep", "--vary", "w=-0.1:1.2:0.1", "--vary", "lam=-10 deg:30 deg:10 deg", "--eigenvalues", "5"];
    for output in ["table.csv", "table.parquet", "TABLE.PARQUET"] {
        let run = directory.run(&[&vary[..], &["--output", output]].concat());
        assert_eq!((run.code, run.stdout.as_str()), (Some(0), ""), "{}", run.stderr);
        assert!(run.stderr.ends_with(&format!("wrote: {output}\n")), "{}", run.stderr);
    }
    let csv = Table::read(&std::fs::read_to_string(directory.0.join("table.csv")).unwrap());
    let parquet = read(&directory.0.join("table.parquet"));
    assert_eq!(csv.rows.len(), 14 * 5);
    assert_eq!(csv.header, parquet.header);
    assert_eq!(csv.rows, parquet.rows);
    // Nothing but the results is left.
    assert_eq!(std::fs::read_dir(&directory.0).unwrap().count(), 3);
    // And they are what is printed without a file.
    let printed = directory.run(&vary).stdout;
    assert_eq!(printed, std::fs::read_to_string(directory.0.join("table.csv")).unwrap());
}

#[test]
fn parquet_has_units() {
    let directory = Directory::new("sweep-units");
    directory.run(&["sweep", "--vary", "IBxx=9,10", "--output", "table.parquet"]);
    let reader = SerializedFileReader::new(File::open(directory.0.join("table.parquet")).unwrap()).unwrap();
    let units = reader.metadata().file_metadata().key_value_metadata().unwrap();
    for (key, unit) in [("unit:IBxx", "kg m²"), ("unit:weave_1", "m/s")] {
        let found = units.iter().find(|entry| entry.key == key).and_then(|entry| entry.value.as_deref());
        assert_eq!(found, Some(unit));
    }
}

#[test]
fn designs_come_from_rows_of_parquet() {
    let directory = Directory::new("sweep-from-parquet");
    let schema = "message designs {
        optional double w; required int32 mB; optional binary lam (UTF8); optional binary name (UTF8);
    }";
    let schema = Arc::new(parse_message_type(schema).unwrap());
    let file = File::create(directory.0.join("bikes.parquet")).unwrap();
    let mut writer = SerializedFileWriter::new(file, schema, Arc::new(WriterProperties::default())).unwrap();
    let mut group = writer.next_row_group().unwrap();
    let mut column = group.next_column().unwrap().unwrap();
    column.typed::<DoubleType>().write_batch(&[1.02, 1.1], Some(&[1, 1, 0]), None).unwrap();
    column.close().unwrap();
    let mut column = group.next_column().unwrap().unwrap();
    column.typed::<Int32Type>().write_batch(&[85, 60, 70], None, None).unwrap();
    column.close().unwrap();
    for texts in [["18 deg", "0.3", "0.3"], ["first", "second", "third"]] {
        let texts = texts.map(ByteArray::from);
        let mut column = group.next_column().unwrap().unwrap();
        column.typed::<ByteArrayType>().write_batch(&texts, Some(&[1, 1, 1]), None).unwrap();
        column.close().unwrap();
    }
    group.close().unwrap();
    writer.close().unwrap();

    let from_parquet = directory.run(&["sweep", "--designs", "bikes.parquet"]);
    directory.write("bikes.csv", "w,mB,lam,name\n1.02,85,18 deg,first\n1.1,60,0.3,second\n,70,0.3,third\n");
    let from_csv = super::table(directory.run(&["sweep", "--designs", "bikes.csv"]));
    let from_parquet = super::table(from_parquet);
    assert_eq!(from_parquet.header, from_csv.header);
    assert_eq!(from_parquet.rows[..2], from_csv.rows[..2]);
    assert_eq!(from_parquet.text(2, "error"), "`w` is empty; expected a number");
    assert!((from_parquet.number(0, "weave_1").unwrap() - 4.292_382_536_341_11).abs() < 1e-13);
}

/// Row groups that end elsewhere than what is computed at once; with kinds of numbers, and rows without a value.
#[test]
fn long_parquet_is_read_to_its_end() {
    let directory = Directory::new("sweep-long-parquet");
    let schema =
        "message designs { optional double w; required float c; optional int64 mB; required binary id (UTF8); }";
    let schema = Arc::new(parse_message_type(schema).unwrap());
    let file = File::create(directory.0.join("bikes.parquet")).unwrap();
    let mut writer = SerializedFileWriter::new(file, schema, Arc::new(WriterProperties::default())).unwrap();
    let mut csv = "w,c,mB,id\n".to_owned();
    let mut first = 0;
    for rows in [700, 1, 5000] {
        let range = first..first + rows;
        let w = |row: &i32| (row % 7 != 3).then_some(1.0 + f64::from(row % 100) * 1e-3);
        // Floats that the nearest double to a decimal is.
        let c = |row: &i32| 0.0625 + (row % 3) as f32 * 0.015625;
        let mass = |row: &i32| (row % 1000 != 999).then_some(i64::from(60 + row % 40));
        let mut group = writer.next_row_group().unwrap();
        let levels =
            |is_there: &dyn Fn(&i32) -> bool| range.clone().map(|row| is_there(&row).into()).collect::<Vec<i16>>();
        let mut column = group.next_column().unwrap().unwrap();
        let values: Vec<f64> = range.clone().filter_map(|row| w(&row)).collect();
        let is_there = levels(&|row| w(row).is_some());
        column.typed::<DoubleType>().write_batch(&values, Some(&is_there), None).unwrap();
        column.close().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        let values: Vec<f32> = range.clone().map(|row| c(&row)).collect();
        column.typed::<FloatType>().write_batch(&values, None, None).unwrap();
        column.close().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        let values: Vec<i64> = range.clone().filter_map(|row| mass(&row)).collect();
        let is_there = levels(&|row| mass(row).is_some());
        column.typed::<Int64Type>().write_batch(&values, Some(&is_there), None).unwrap();
        column.close().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        let values: Vec<ByteArray> = range.clone().map(|row| ByteArray::from(format!("r{row}").as_str())).collect();
        column.typed::<ByteArrayType>().write_batch(&values, None, None).unwrap();
        column.close().unwrap();
        group.close().unwrap();
        let text = |number: Option<String>| number.unwrap_or_default();
        let row = |row: i32| {
            let [w, mass] = [text(w(&row).map(|w| w.to_string())), text(mass(&row).map(|mass| mass.to_string()))];
            format!("{w},{},{mass},r{row}\n", c(&row))
        };
        csv.extend(range.map(row));
        first += rows;
    }
    writer.close().unwrap();
    directory.write("bikes.csv", &csv);
    let outputs = ["bikes.parquet", "bikes.csv"].map(|designs| {
        let output = format!("of-{designs}");
        let run = directory.run(&["sweep", "--designs", designs, "--output", &output]);
        assert!(run.stderr.contains("computed: 5701 designs in "), "{}", run.stderr);
        directory.0.join(output)
    });
    let from_parquet = read(&outputs[0]);
    let from_csv = Table::read(&std::fs::read_to_string(&outputs[1]).unwrap());
    assert_eq!(from_parquet.rows.len(), 5701);
    assert_eq!(from_parquet.text(3, "error"), "`w` is empty; expected a number");
    assert_eq!(from_parquet.text(999, "error"), "`mB` is empty; expected a number");
    assert_eq!(from_parquet.header, from_csv.header);
    assert!(from_parquet.rows == from_csv.rows);
}

/// A file with one row: `w` and another column.
fn two_columns<T: parquet::data_type::DataType>(path: &Path, column: &str, values: &[T::T], compression: Compression) {
    let schema = Arc::new(parse_message_type(&format!("message designs {{ required double w; {column}; }}")).unwrap());
    let properties = WriterProperties::builder().set_compression(compression).build();
    let mut writer = SerializedFileWriter::new(File::create(path).unwrap(), schema, Arc::new(properties)).unwrap();
    let mut group = writer.next_row_group().unwrap();
    let mut column = group.next_column().unwrap().unwrap();
    column.typed::<DoubleType>().write_batch(&vec![1.02; values.len()], None, None).unwrap();
    column.close().unwrap();
    let mut column = group.next_column().unwrap().unwrap();
    column.typed::<T>().write_batch(values, None, None).unwrap();
    column.close().unwrap();
    group.close().unwrap();
    writer.close().unwrap();
}

/// 2^53 + 1 and 2^64 - 1 are no doubles.
#[test]
fn integers_are_copied_as_they_are() {
    let directory = Directory::new("sweep-integers");
    let path = directory.0.join("bikes.parquet");
    let ids = || super::table(directory.run(&["sweep", "--designs", "bikes.parquet"]));
    two_columns::<Int64Type>(&path, "required int64 id", &[9_007_199_254_740_993, -5], Compression::UNCOMPRESSED);
    assert_eq!([0, 1].map(|row| ids().text(row, "id").to_owned()), ["9007199254740993", "-5"]);
    two_columns::<Int64Type>(&path, "required int64 id (UINT_64)", &[-1], Compression::UNCOMPRESSED);
    assert_eq!(ids().text(0, "id"), "18446744073709551615");
}

#[test]
fn columns_that_cannot_be_copied_are_refused() {
    let directory = Directory::new("sweep-kinds");
    let path = directory.0.join("bikes.parquet");
    let check = |message: &str| {
        let message = format!("error: bikes.parquet: column {message}\n");
        directory.run(&["sweep", "--designs", "bikes.parquet"]).fails(2, &message);
    };
    two_columns::<FloatType>(&path, "required float id", &[0.1], Compression::UNCOMPRESSED);
    check("`id` holds FLOAT; expected integers or text");
    two_columns::<BoolType>(&path, "required boolean mB", &[true], Compression::UNCOMPRESSED);
    check("`mB` holds BOOLEAN; expected numbers or text");
    two_columns::<Int32Type>(&path, "required int32 name (DATE)", &[1], Compression::UNCOMPRESSED);
    check("`name` holds INT32 (Date); expected integers or text");
    two_columns::<ByteArrayType>(&path, "required binary name", &["a".into()], Compression::UNCOMPRESSED);
    check("`name` holds BYTE_ARRAY; expected integers or text");
}

#[test]
fn compressed_parquet_is_read() {
    let directory = Directory::new("sweep-compressed");
    let path = directory.0.join("bikes.parquet");
    let gzip = Compression::GZIP(GzipLevel::default());
    for compression in [Compression::SNAPPY, gzip, Compression::LZ4, Compression::LZ4_RAW] {
        two_columns::<Int32Type>(&path, "required int32 id", &[7; 100], compression);
        let table = super::table(directory.run(&["sweep", "--designs", "bikes.parquet"]));
        assert_eq!((table.rows.len(), table.text(99, "id")), (100, "7"), "{compression}");
    }
    // Files like those of other programs: the footer says how the column `w` is compressed (6: Zstandard, 4: Brotli).
    two_columns::<Int32Type>(&path, "required int32 id", &[7], Compression::SNAPPY);
    let bytes = std::fs::read(&path).unwrap();
    let place = bytes.windows(6).position(|bytes| bytes == b"\x19\x18\x01w\x15\x02").unwrap();
    for (number, name) in [(6, "zstd"), (4, "brotli")] {
        let mut changed = bytes.clone();
        changed[place + 5] = 2 * number;
        std::fs::write(&path, changed).unwrap();
        let message = format!("it is compressed with {name}; expected snappy, gzip, lz4 or no compression");
        let run = directory.run(&["sweep", "--designs", "bikes.parquet"]);
        run.fails(2, &format!("error: bikes.parquet: {message}\n"));
    }
}
