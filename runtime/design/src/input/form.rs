//! In which form a file is, by its ending or by what is in it.

use std::path::Path;

#[cfg(feature = "full")]
use super::cells;
use super::document::{Document, File};
#[cfg(feature = "full")]
use super::encodings;
use super::{json, lines, texts, toml};
use crate::failure::{Failure, Place};

/// What is in a file, whatever its form.
///
/// # Errors
/// If it is no text; all else is told by the document.
pub(super) fn parse(label: &str, bytes: Vec<u8>) -> Result<Document, Failure> {
    let text = decode(label, bytes)?;
    let file = File { label, text: &text };
    let document = match Form::of(file) {
        Form::Toml => toml::read(file),
        Form::Json => json::read(file),
        Form::Lines(separator) => lines::read(file, separator),
        #[cfg(feature = "full")]
        Form::Cells => cells::read(file),
        #[cfg(feature = "full")]
        Form::Designs => cells::refuse_designs(file),
    };
    // Names may stand in each other's values, which takes long of so many.
    #[cfg(feature = "full")]
    if document.entries.len() > MOST {
        let message = format!("it has {} names, and no machine has so many parameters", document.entries.len());
        return Err(Failure::at(Place::File(label.to_owned()), message));
    }
    Ok(document)
}

/// Of matrices of twelve coordinates there are about half as many.
#[cfg(feature = "full")]
const MOST: usize = 3000;

/// The contents of a file as text, without a byte order mark.
///
/// # Errors
/// If they are none.
pub fn decode(label: &str, bytes: Vec<u8>) -> Result<String, Failure> {
    #[cfg(feature = "full")]
    let bytes = encodings::text(bytes);
    let mut text = String::from_utf8(bytes).map_err(|error| {
        let before = error.as_bytes().iter().take(error.utf8_error().valid_up_to());
        let line = 1 + before.filter(|&&byte| byte == b'\n').count();
        Failure::at(Place::Line(label.to_owned(), line), "this is not UTF-8 text")
    })?;
    // Some editors begin a file with a byte order mark.
    if text.starts_with('\u{feff}') {
        text.remove(0);
    }
    Ok(text)
}

/// How names and values stand in a file.
pub(super) enum Form {
    Toml,
    Json,
    /// One of each a line, with this between them.
    Lines(char),
    /// One of each a line, in columns that have names.
    #[cfg(feature = "full")]
    Cells,
    /// Many designs, one a line, which is no file of parameters.
    #[cfg(feature = "full")]
    Designs,
}

impl Form {
    pub fn of(file: File) -> Self {
        let ending = Path::new(file.label).extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
        let begins = without_comments(file.text);
        match ending.as_deref() {
            // Neither TOML nor a YAML of lines begins so, and no JSON assigns: such a file has the wrong ending.
            Some("toml" | "yml" | "yaml") if begins.starts_with('{') => Self::Json,
            Some("json") if !begins.starts_with('{') && is_assigning(begins) => Self::by_content(file),
            // What `carvallo convert` writes for JBike6 into a file that is called so.
            Some("toml") if lines::is_matlab(file) && !toml::is_whole(file) => Self::by_content(file),
            Some("toml") => Self::Toml,
            Some("json") => Self::Json,
            Some("yml" | "yaml") => Self::Lines(':'),
            Some("py" | "m") => Self::Lines('='),
            _ => Self::by_content(file),
        }
    }

    /// Other endings tell nothing: the first line that is neither empty nor a comment does, nor in a script the head of a
    /// class.
    fn by_content(file: File) -> Self {
        let is_comment = |line: &&str| line.is_empty() || line.starts_with(['#', '%']) || lines::is_statement(line);
        // What a script of Python says of itself tells nothing, either.
        let folded = texts::fold_python(file.text);
        let text = if lines::is_matlab(file) { file.text } else { &folded.text };
        let mut lines = text.lines().map(str::trim).filter(|line| !is_comment(line));
        let first = lines.next().unwrap_or_default();
        #[cfg(feature = "full")]
        if cells::is_heading(first) {
            return Self::Cells;
        }
        #[cfg(feature = "full")]
        if cells::is_heading_of_designs(first, lines.clone().next()) {
            return Self::Designs;
        }
        if first.starts_with('{') {
            Self::Json
        } else if first.starts_with('[') || lines.any(is_of_toml) {
            Self::Toml
        } else if first.split_once(':').is_some_and(|(name, _)| !name.contains('=')) {
            Self::Lines(':')
        } else if text.contains('{') && toml::is_whole(file) {
            // A table in one line, or in several.
            Self::Toml
        } else {
            Self::Lines('=')
        }
    }
}

/// What follows the comments that a file in JSON begins with.
fn without_comments(text: &str) -> &str {
    let text = text.trim_start();
    let rest = text.strip_prefix("//").map(|rest| rest.split_once('\n').map_or("", |(_, rest)| rest));
    let rest = rest.or_else(|| text.strip_prefix("/*").map(|rest| rest.split_once("*/").map_or("", |(_, rest)| rest)));
    rest.map_or(text, without_comments)
}

/// Whether there is an assignment to a name in some line.
fn is_assigning(text: &str) -> bool {
    let is_name = |name: &str| !name.trim().is_empty() && !name.contains(['"', '\'', ':']);
    text.lines().any(|line| line.split_once('=').is_some_and(|(name, _)| is_name(name)))
}

/// Whether a line, alone, tells that a file is in TOML.
fn is_of_toml(line: &str) -> bool {
    line.starts_with("[parameters]")
        || line.starts_with("[matrices]")
        || line.starts_with("[measurements]")
        || line == "[[coordinates]]"
        || line.starts_with('{')
        || line.contains("= {")
        || line.contains("[{")
}
