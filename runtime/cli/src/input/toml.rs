//! Parameter files in TOML: the format of the bicycles that ship with Carvallo.

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::document::{Document, Entry, File, Written};
use super::matrices;

/// Reads a file that holds a table `parameters`, or the parameters at its top.
pub fn read(file: File) -> Document {
    let mut document = Document::default();
    let (table, errors) = DeTable::parse_recoverable(file.text);
    for error in errors {
        let place = file.line_at(error.span().map_or(0, |span| span.start));
        document.problem(place, format!("this is not TOML: {}", error.message()));
    }
    let table = table.into_inner();
    let nested = table.get("parameters").map(Spanned::get_ref).and_then(DeValue::as_table);
    for (key, value) in &table {
        let name = key.get_ref().as_ref();
        match value.get_ref() {
            DeValue::String(text) if document.take_heading(name, text) => {}
            _ if name == "parameters" && nested.is_some() => {}
            DeValue::Array(rows) if nested.is_none() && matrices::name(name).is_some() => {
                let rows = rows.iter().map(|row| {
                    let row = row.get_ref().as_array()?;
                    Some(row.iter().map(|value| written(file, value)).collect())
                });
                if let Some(matrix) = matrices::name(name) {
                    document.take_matrix(matrix, &file.line_at(key.span().start), rows.collect());
                }
            }
            _ if nested.is_some() => {
                document.problem(file.line_at(key.span().start), format!("`{name}` stands outside of [parameters]"));
            }
            _ => take(&mut document, file, key.span().start, name, value),
        }
    }
    document.finish_matrices();
    for (key, value) in nested.into_iter().flatten() {
        take(&mut document, file, key.span().start, key.get_ref(), value);
    }
    document
}

/// `value`, or `{ value = …, std = …, unit = … }`.
fn take(document: &mut Document, file: File, offset: usize, name: &str, value: &Spanned<DeValue>) {
    let place = file.line_at(offset);
    match value.get_ref() {
        DeValue::String(text) => document.entries.push(Entry::from_text(name, place, text)),
        DeValue::Table(table) => {
            let members = table.iter().map(|(key, value)| (key.get_ref().as_ref(), written(file, value)));
            document.take_members(name, place, members, "a table without `value`");
        }
        _ => {
            let value = written(file, value);
            document.entries.push(Entry { name: name.to_owned(), place, value, deviation: None });
        }
    }
}

/// The digits of the file itself: none is lost on the way.
fn written(file: File, value: &Spanned<DeValue>) -> Written {
    match value.get_ref() {
        DeValue::String(text) => Written::Text(text.to_string()),
        DeValue::Integer(_) | DeValue::Float(_) => {
            Written::Text(file.text.get(value.span()).unwrap_or_default().replace('_', ""))
        }
        DeValue::Boolean(_) => Written::Other("a boolean"),
        DeValue::Datetime(_) => Written::Other("a date"),
        DeValue::Array(_) => Written::Other("an array"),
        DeValue::Table(_) => Written::Other("a table"),
    }
}
