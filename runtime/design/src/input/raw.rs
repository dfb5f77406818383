//! Files of something else than a design, such as a body or measurements, in the formats that parameters come in.

use carvallo::ParameterInfo;

use super::document::{Document, Entry, File};
use super::form::{Form, decode};
use super::{contents, json, lines, toml, value};
use crate::design::Given;
use crate::failure::{Failure, Place, Problem};
use crate::quantity::no_names;

pub use super::tables::{Named, Node, Value};

/// What is in a file, before anything is judged.
#[derive(Debug)]
pub struct Raw {
    /// The path as it was given, or `<stdin>`.
    pub label: String,
    /// In the order of the file.
    pub members: Vec<Named>,
}

/// Reads what is in a file, or with `-` in the standard input.
///
/// # Errors
/// If it cannot be read, or if its format is wrong.
pub fn load_raw(path: &str) -> Result<Raw, Failure> {
    match contents(path)? {
        Some((label, bytes)) => read_raw(label, bytes),
        None => Err(Failure::usage(format!("there is no file {path}"))),
    }
}

/// Reads the contents of a file; the ending of its label tells the format, or else what is in it.
///
/// # Errors
/// Everything that is wrong with the format.
pub fn read_raw(label: &str, bytes: Vec<u8>) -> Result<Raw, Failure> {
    let text = decode(label, bytes)?;
    let file = File { label, text: &text };
    let mut problems = Vec::new();
    let members = match Form::of(file) {
        // Lines that assign may be matrices of a machine, which has all of them; here they may be any.
        Form::Lines('=') if toml::is_whole(file) => toml::members(file, &mut problems),
        Form::Toml => toml::members(file, &mut problems),
        Form::Json => json::members(file, &mut problems),
        Form::Lines(separator) => flat(label, lines::read(file, separator), &mut problems),
        #[cfg(feature = "full")]
        Form::Cells => flat(label, super::cells::read(file), &mut problems),
        #[cfg(feature = "full")]
        Form::Designs => flat(label, super::cells::refuse_designs(file), &mut problems),
    };
    if problems.is_empty() { Ok(Raw { label: label.to_owned(), members }) } else { Err(Failure::Input(problems)) }
}

/// What is in a file without groups.
fn flat(label: &str, document: Document, problems: &mut Vec<Problem>) -> Vec<Named> {
    problems.extend(document.problems);
    let name = document.name.map(|name| Entry::from_text("name", Place::File(label.to_owned()), &name));
    name.into_iter().chain(document.entries).chain(document.outside).map(Named::from).collect()
}

impl Named {
    /// Judges it as the value of a parameter, with its standard deviation if it has one.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn judge(self, info: &ParameterInfo) -> Result<Given, Vec<Problem>> {
        let mut document = Document::default();
        let Node { place, value } = self.node;
        let entry = document.entry_of(self.name, place, value, &toml::WORDS);
        let given = value::validate(&entry, info, &no_names);
        if document.problems.is_empty() {
            return given;
        }
        document.problems.extend(given.err().into_iter().flatten());
        Err(document.problems)
    }
}
