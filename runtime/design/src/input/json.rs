//! Parameter files in JSON: an object of values, alone or under `parameters`, as `--format json` writes it.

use jsonc_parser::ast::{self, ObjectProp};
use jsonc_parser::common::Ranged as _;
use jsonc_parser::{CollectOptions, ParseOptions, parse_to_ast};

use super::document::{Document, File};
use super::tables::{Named, Node, Value, Words};
use crate::failure::Problem;

const WORDS: Words =
    Words { parameters: "`parameters`", table: "an object", table_without_value: "an object without `value`" };

/// Reads an object that holds an object `parameters`, or the parameters themselves.
pub fn read(file: File) -> Document {
    let mut document = Document::default();
    let members = members(file, &mut document.problems);
    document.take_all(members, &WORDS);
    document
}

/// What is in the object, whatever it is.
pub fn members(file: File, problems: &mut Vec<Problem>) -> Vec<Named> {
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
        Ok(Some(ast::Value::Object(object))) => object,
        // An empty file has no parameters, whatever its format.
        Ok(None) => return Vec::new(),
        Ok(_) => {
            let message = "this is not a JSON object of parameters".to_owned();
            problems.push(Problem { place: file.line(1), message });
            return Vec::new();
        }
        Err(error) => {
            let message = format!("this is not JSON: {}", error.kind());
            problems.push(Problem { place: file.line_at(error.range().start), message });
            return Vec::new();
        }
    };
    object.properties.iter().map(|property| named(file, property)).collect()
}

fn named(file: File, property: &ObjectProp) -> Named {
    let node = Node { place: file.line_at(property.range.start), value: value(file, &property.value) };
    Named { name: property.name.as_str().to_owned(), node }
}

fn value(file: File, value: &ast::Value) -> Value {
    match value {
        ast::Value::StringLit(text) => Value::Text(text.value.to_string()),
        ast::Value::NumberLit(number) => Value::Number(number.value.to_owned()),
        ast::Value::Array(array) => {
            let node =
                |inner: &ast::Value| Node { place: file.line_at(inner.range().start), value: self::value(file, inner) };
            Value::List(array.elements.iter().map(node).collect())
        }
        ast::Value::Object(object) => {
            Value::Table(object.properties.iter().map(|property| named(file, property)).collect())
        }
        ast::Value::BooleanLit(_) => Value::Other("a boolean"),
        ast::Value::NullKeyword(_) => Value::Other("null"),
    }
}
