//! Parameter files in TOML: the format of the bicycles that ship with Carvallo.

use carvallo::sort_by;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::document::{Document, File};
use super::tables::{Named, Node, Value, Words};
use crate::failure::Problem;

pub const WORDS: Words =
    Words { parameters: "[parameters]", table: "a table", table_without_value: "a table without `value`" };

/// Reads a file that holds a table `parameters`, or the parameters at its top.
pub fn read(file: File) -> Document {
    let mut document = Document::default();
    let members = members(file, &mut document.problems);
    document.take_all(members, &WORDS);
    document
}

/// Whether all of a file is in TOML.
pub fn is_whole(file: File) -> bool {
    DeTable::parse(file.text).is_ok()
}

/// What is in the file, whatever it is.
pub fn members(file: File, problems: &mut Vec<Problem>) -> Vec<Named> {
    let (table, errors) = DeTable::parse_recoverable(file.text);
    #[cfg(feature = "full")]
    if let (Some((at, end)), false) = (super::unclosed::unclosed(file.text), errors.is_empty()) {
        let what = if end == ']' { "list" } else { "table" };
        let message = format!("this is not TOML: the {what} that begins here has no end, expected `{end}`");
        problems.push(Problem { place: file.line_at(at), message });
        return of_table(file, table.get_ref());
    }
    for error in errors {
        let place = file.line_at(error.span().map_or(0, |span| span.start));
        problems.push(Problem { place, message: format!("this is not TOML: {}", error.message()) });
    }
    of_table(file, table.get_ref())
}

fn of_table(file: File, table: &DeTable) -> Vec<Named> {
    let named = |(key, inner): (&Spanned<_>, &Spanned<DeValue>)| {
        let node = Node { place: file.line_at(key.span().start), value: value(file, inner) };
        Named { name: AsRef::<str>::as_ref(key.get_ref()).to_owned(), node }
    };
    let mut members: Vec<_> = table.iter().collect();
    sort_by(&mut members, |(a, _), (b, _)| a.span().start.cmp(&b.span().start));
    members.into_iter().map(named).collect()
}

fn value(file: File, value: &Spanned<DeValue>) -> Value {
    match value.get_ref() {
        DeValue::String(text) => Value::Text(text.to_string()),
        // The digits of the file itself: none is lost on the way.
        DeValue::Integer(_) | DeValue::Float(_) => {
            Value::Number(file.text.get(value.span()).unwrap_or_default().replace('_', ""))
        }
        DeValue::Array(array) => {
            let node = |inner: &Spanned<DeValue>| Node {
                place: file.line_at(inner.span().start),
                value: self::value(file, inner),
            };
            Value::List(array.iter().map(node).collect())
        }
        DeValue::Table(table) => Value::Table(of_table(file, table)),
        DeValue::Boolean(_) => Value::Other("a boolean"),
        DeValue::Datetime(_) => Value::Other("a date"),
    }
}
