//! What every file format is read into, before any name or value is judged.

use super::tables::Named;
use crate::failure::{Place, Problem};
use crate::matrices::Form;

/// What laws of feedback stand under.
pub const FEEDBACK: &str = "feedback";

/// A parameter file, with its values still as they were written.
#[derive(Debug, Default)]
pub struct Document {
    pub name: Option<String>,
    pub kind: Option<String>,
    pub source: Option<String>,
    pub model: Option<String>,
    /// The laws of feedback.
    pub feedback: Vec<(Place, String)>,
    /// Under which names and in which axes the parameters are, if the file says so, and where.
    pub parameterization: Option<(Place, String)>,
    /// In the order of the file.
    pub entries: Vec<Entry>,
    /// What describes the file where its parameters stand in a group of their own.
    pub outside: Vec<Entry>,
    /// Matrices in the place of parameters, and what goes with them, until all of the file is read.
    pub parts: Vec<Named>,
    /// What matrices there are, if there are any: their entries are among the others then.
    pub form: Option<Form>,
    /// The correlations of measured parameters, as they were written.
    #[cfg(feature = "full")]
    pub correlations: Vec<Named>,
    /// What was taken for something else than it is called.
    pub notes: Vec<String>,
    /// What was wrong with the format itself.
    pub problems: Vec<Problem>,
}

/// One parameter as it was written.
#[derive(Clone, Debug)]
pub struct Entry {
    pub name: String,
    pub place: Place,
    pub value: Written,
    /// Its standard deviation, in formats that keep it apart from the value.
    pub deviation: Option<Written>,
    /// The name that it was written with, where it is read by another one.
    #[cfg(feature = "full")]
    pub renamed: Option<String>,
}

/// A value as it was written.
#[derive(Clone, Debug)]
pub enum Written {
    /// A number or an expression, perhaps with a standard deviation.
    Text(String),
    /// Something that cannot be a number, in words: `an array`.
    Other(&'static str),
}

impl Entry {
    /// An entry by the name that it is written with.
    pub fn new(name: String, place: Place, value: Written, deviation: Option<Written>) -> Self {
        Self {
            name,
            place,
            value,
            deviation,
            #[cfg(feature = "full")]
            renamed: None,
        }
    }

    /// What it is called where it is written.
    #[cfg(feature = "full")]
    pub fn called(&self) -> &str {
        self.renamed.as_ref().unwrap_or(&self.name)
    }

    /// An entry of a format that keeps value and deviation in one text: `1.02 +/- 0.01`.
    pub fn from_text(name: &str, place: Place, text: &str) -> Self {
        Self::new(name.to_owned(), place, Written::Text(text.trim().to_owned()), None)
    }
}

/// Where in a file something is: its label, and its text to count lines in.
#[derive(Clone, Copy)]
pub struct File<'a> {
    /// The path as it was given, or `<stdin>`.
    pub label: &'a str,
    pub text: &'a str,
}

impl File<'_> {
    pub fn line(&self, number: usize) -> Place {
        Place::Line(self.label.to_owned(), number)
    }

    /// The line that holds the byte at `offset`.
    pub fn line_at(&self, offset: usize) -> Place {
        let before = self.text.as_bytes().iter().take(offset);
        self.line(1 + before.filter(|&&byte| byte == b'\n').count())
    }
}

impl Document {
    /// Takes a law of feedback; whether there is one under this name.
    pub fn take_law(&mut self, key: &str, place: &Place, text: &str) -> bool {
        // An assignment of a number may have any name.
        let is_law = key == FEEDBACK && text.contains('=');
        if is_law {
            self.feedback.push((place.clone(), text.to_owned()));
        }
        is_law
    }

    /// Takes the text of a heading such as `name` or `source`; whether it is one.
    pub fn take_heading(&mut self, key: &str, text: &str) -> bool {
        let heading = match key {
            // `bicycle` is what the JSON output of the command line calls it.
            "name" | "bicycle" => &mut self.name,
            "kind" => &mut self.kind,
            "source" => &mut self.source,
            "model" => &mut self.model,
            _ => return false,
        };
        *heading = Some(text.to_owned());
        true
    }

    pub fn problem(&mut self, place: Place, message: impl Into<String>) {
        self.problems.push(Problem { place, message: message.into() });
    }
}
