//! Bicycles: shipped ones by name, and files in any of the formats that people have.

mod document;
mod expression;
mod json;
mod lines;
mod literal;
mod names;
mod parameters;
mod plausible;
mod toml;
mod value;

use std::io::Read as _;
use std::path::Path;

use carvallo_models::{BICYCLES, Whipple};

use self::document::{Document, Entry, File};
use crate::failure::{Failure, Place, Problem};

pub use self::names::{nearest, unit};
pub use self::plausible::warnings;

/// A bicycle for the model of Whipple and Carvallo.
pub type Bicycle = parameters::Bicycle<Whipple<f64>>;

/// Where the parameters come from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Request {
    /// The name of a shipped bicycle, a path, or `-` for the standard input.
    pub bicycle: String,
    /// Values from the command line: the option as it was given, the name and the value.
    pub overrides: Vec<(String, String, String)>,
}

/// Reads and judges the bicycle.
///
/// # Errors
/// Everything that is wrong with the request or the file, or that the file cannot be read.
pub fn load(request: &Request) -> Result<Bicycle, Failure> {
    let overrides = request.overrides.iter();
    let overrides =
        overrides.map(|(option, name, value)| Entry::from_text(name, Place::Option(option.clone()), value)).collect();
    let name = request.bicycle.as_str();
    let (label, document) = if let Some(shipped) = BICYCLES.iter().find(|bicycle| bicycle.name == name) {
        (name, toml::read(File { label: name, text: shipped.toml }))
    } else if name == "-" {
        let mut bytes = Vec::new();
        let read = std::io::stdin().lock().read_to_end(&mut bytes);
        read.map_err(|error| Failure::Run(format!("cannot read the standard input: {error}")))?;
        ("<stdin>", parse("<stdin>", bytes)?)
    } else if Path::new(name).exists() {
        let bytes = std::fs::read(name).map_err(|error| Failure::Run(format!("cannot read {name}: {error}")))?;
        (name, parse(name, bytes)?)
    } else {
        return Err(Failure::usage(unknown(name)));
    };
    parameters::resolve(document, label, overrides).map_err(Failure::Input)
}

/// Reads and judges the contents of a file; the ending of its label tells the format, or else what is in it.
///
/// # Errors
/// Everything that is wrong with it.
pub fn read(label: &str, bytes: Vec<u8>) -> Result<Bicycle, Failure> {
    parameters::resolve(parse(label, bytes)?, label, Vec::new()).map_err(Failure::Input)
}

fn unknown(name: &str) -> String {
    if name.contains(['/', '\\', '.']) {
        return format!("there is no file {name}");
    }
    let hint = nearest(name, BICYCLES.iter().map(|bicycle| bicycle.name));
    let hint = hint.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
    format!("there is neither a bicycle nor a file `{name}`{hint}\n`carvallo bicycles` lists the bicycles")
}

fn parse(label: &str, bytes: Vec<u8>) -> Result<Document, Failure> {
    let text = String::from_utf8(bytes).map_err(|error| {
        let line = 1 + error.as_bytes().iter().take(error.utf8_error().valid_up_to()).filter(|&&b| b == b'\n').count();
        Failure::Input(vec![Problem {
            place: Place::Line(label.to_owned(), line),
            message: "this is not UTF-8 text".to_owned(),
        }])
    })?;
    // Some editors begin a file with a byte order mark.
    let file = File { label, text: text.strip_prefix('\u{feff}').unwrap_or(&text) };
    let ending = Path::new(label).extension().and_then(|ending| ending.to_str()).map(str::to_lowercase);
    Ok(match ending.as_deref() {
        Some("toml") => toml::read(file),
        Some("json") => json::read(file),
        Some("yml" | "yaml") => lines::read(file, ':'),
        _ => by_content(file),
    })
}

/// Other endings tell nothing: the first line that is neither empty nor a comment does.
fn by_content(file: File) -> Document {
    let mut lines = file.text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
    let first = lines.next().unwrap_or_default();
    if first.starts_with('{') {
        json::read(file)
    } else if first.starts_with('[') || lines.any(|line| line == "[parameters]" || line.contains("= {")) {
        toml::read(file)
    } else if first.split_once(':').is_some_and(|(name, _)| !name.contains('=')) {
        lines::read(file, ':')
    } else {
        lines::read(file, '=')
    }
}
