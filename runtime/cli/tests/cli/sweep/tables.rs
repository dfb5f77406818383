//! Files of results and of designs in both formats.

use std::fs::File;
use std::path::Path;
use std::sync::Arc;

use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int32Type};
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
