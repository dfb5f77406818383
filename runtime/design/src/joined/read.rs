//! Bodies from files, and from the text of an option: `mass=5 kg, at=(0.3, 0, -0.9), to=rear`.

use std::path::Path;

use super::body::Body;
use super::members::of_members;
use crate::failure::{Failure, Place};
use crate::input::{Named, Node, Value, load_raw};

/// Reads a body from a file, or from what an option says of it.
///
/// # Errors
/// Everything that is wrong with it, or that the file cannot be read.
pub fn read(option: &str, text: &str) -> Result<Body, Failure> {
    let place = Place::Option(option.to_owned());
    if text.contains('=') && !Path::new(text).exists() {
        return of_members(inline(text, &place)?, place).map_err(Failure::Input);
    }
    let raw = load_raw(text).map_err(|failure| match failure {
        Failure::Input(_) if !Path::new(text).exists() => {
            let expected = "; expected a file, or a body such as `mass=5 kg, at=(0.3, 0, -0.9), to=rear`";
            Failure::at(place, format!("there is no file `{text}`{expected}"))
        }
        failure => failure,
    })?;
    of_members(raw.members, Place::File(raw.label)).map_err(Failure::Input)
}

/// Names and values between commas; those in parentheses or brackets belong together.
fn inline(text: &str, place: &Place) -> Result<Vec<Named>, Failure> {
    let node = |value: Value| Node { place: place.clone(), value };
    let named = |part: &str| {
        let (name, value) = part.split_once('=').ok_or_else(|| {
            let message = format!("`{}` is not of the form `name=value`; lists are in parentheses", part.trim());
            Failure::at(place.clone(), message)
        })?;
        let value = value.trim();
        let inner = [('(', ')'), ('[', ']')]
            .into_iter()
            .find_map(|(open, close)| value.strip_prefix(open)?.strip_suffix(close))
            .filter(|inner| inner.contains(','));
        let value = match inner {
            Some(list) => {
                Value::List(outside(list).into_iter().map(|text| node(Value::Text(text.to_owned()))).collect())
            }
            None => Value::Text(value.to_owned()),
        };
        Ok(Named { name: name.trim().to_owned(), node: node(value) })
    };
    outside(text).into_iter().filter(|part| !part.trim().is_empty()).map(named).collect()
}

/// The parts between commas that stand outside of parentheses.
pub fn outside(text: &str) -> Vec<&str> {
    let mut depth = 0;
    text.split(|found: char| {
        depth += i32::from("([{".contains(found)) - i32::from(")]}".contains(found));
        depth == 0 && found == ','
    })
    .collect()
}
