//! Parameter files in JSON: an object of values, alone or under `parameters`, as `--format json` writes it.

use jsonc_parser::ast::{Array, ObjectProp, Value};
use jsonc_parser::{CollectOptions, ParseOptions, parse_to_ast};

use super::document::{Document, Entry, File, Written};
use super::matrices;

/// What the output of an analysis, or of the sensitivity, holds besides the parameters.
const RESULTS: [&str; 5] =
    ["matrices", "matrix_standard_deviations", "critical_speeds", "stable_ranges", "eigenvalues"];

/// Reads an object that holds an object `parameters`, or the parameters themselves.
pub fn read(file: File) -> Document {
    let mut document = Document::default();
    // What Python prints and people add is read; what is missing is not guessed.
    let options = ParseOptions {
        allow_comments: true,
        allow_loose_object_property_names: false,
        allow_trailing_commas: true,
        allow_missing_commas: false,
        allow_single_quoted_strings: true,
        allow_hexadecimal_numbers: false,
        allow_unary_plus_numbers: true,
        allow_bare_decimal_point_numbers: true,
        // Python writes NaN and Infinity; they are read so that the message can name the parameter.
        allow_non_finite_numbers: true,
        allow_extended_string_escapes: false,
    };
    let object = match parse_to_ast(file.text, &CollectOptions::default(), &options).map(|parsed| parsed.value) {
        Ok(Some(Value::Object(object))) => object,
        // An empty file has no parameters, whatever its format.
        Ok(None) => return document,
        Ok(_) => {
            document.problem(file.line(1), "this is not a JSON object of parameters");
            return document;
        }
        Err(error) => {
            document.problem(file.line_at(error.range().start), format!("this is not JSON: {}", error.kind()));
            return document;
        }
    };
    let nested = object.get_object("parameters");
    let matrices = object.get_object("matrices").filter(|_| nested.is_none());
    for property in matrices.unwrap_or(&object).properties.iter().filter(|_| nested.is_none()) {
        if let (Some(matrix), Value::Array(rows)) = (matrices::name(property.name.as_str()), &property.value) {
            document.take_matrix(matrix, &file.line_at(property.range.start), rows_of(rows));
        } else if matrices.is_some() {
            take(&mut document, file, property);
        }
    }
    for property in &object.properties {
        let name = property.name.as_str();
        match &property.value {
            Value::StringLit(text) if document.take_heading(name, &text.value) => {}
            Value::Array(_) if nested.is_none() && matrices::name(name).is_some() => {}
            Value::Object(_) if matrices.is_some() && name == "matrices" => {}
            _ if nested.is_some() && (name == "parameters" || RESULTS.contains(&name)) => {}
            _ if nested.is_some() => {
                document
                    .problem(file.line_at(property.range.start), format!("`{name}` stands outside of `parameters`"));
            }
            _ => take(&mut document, file, property),
        }
    }
    let properties = nested.map(|object| object.properties.as_slice()).unwrap_or_default();
    properties.iter().for_each(|property| take(&mut document, file, property));
    document.finish_matrices();
    document
}

/// The rows of a matrix.
fn rows_of(rows: &Array) -> Option<Vec<Vec<Written>>> {
    let row = |row: &Value| match row {
        Value::Array(row) => Some(row.elements.iter().map(written).collect()),
        _ => None,
    };
    rows.elements.iter().map(row).collect()
}

/// `"name": value`, or `"name": { "value": …, "std": …, "unit": … }`.
fn take(document: &mut Document, file: File, property: &ObjectProp) {
    let name = property.name.as_str();
    let place = file.line_at(property.range.start);
    match &property.value {
        Value::StringLit(text) => document.entries.push(Entry::from_text(name, place, &text.value)),
        Value::Object(object) => {
            let members = object.properties.iter().map(|member| (member.name.as_str(), written(&member.value)));
            document.take_members(name, place, members, "an object without `value`");
        }
        value => {
            let value = written(value);
            document.entries.push(Entry { name: name.to_owned(), place, value, deviation: None });
        }
    }
}

fn written(value: &Value) -> Written {
    match value {
        Value::StringLit(text) => Written::Text(text.value.to_string()),
        Value::NumberLit(number) => Written::Text(number.value.to_owned()),
        Value::BooleanLit(_) => Written::Other("a boolean"),
        Value::Object(_) => Written::Other("an object"),
        Value::Array(_) => Written::Other("an array"),
        Value::NullKeyword(_) => Written::Other("null"),
    }
}
