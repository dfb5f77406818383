//! Parameters of a model: shipped ones by name, and files in any of the formats that people have.

#[cfg(feature = "full")]
mod cells;
#[cfg(feature = "full")]
mod correlations;
mod document;
mod entries;
mod json;
mod lines;
mod magnitude;
mod matrices;
mod members;
mod names;
mod neutral;
mod parameters;
mod plausible;
mod raw;
mod scope;
mod shipped;
mod tables;
mod texts;
mod toml;
mod value;

use std::io::Read as _;
use std::path::Path;

#[cfg(feature = "full")]
pub(crate) use self::correlations::{Names, resolve as resolve_correlations};
use self::document::File;
#[cfg(feature = "full")]
pub(crate) use self::document::Written;
pub(crate) use self::document::{Document, Entry};
use crate::design::Design;
use crate::failure::{Failure, Place, Problem};
#[cfg(feature = "full")]
use crate::joined::Body;
use crate::model::{Shipped, WHIPPLE};

#[cfg(feature = "full")]
pub use self::magnitude::warning_of_varied;
pub use self::matrices::{list, matrix_of_rows};
#[cfg(feature = "full")]
pub(crate) use self::names::without_owner;
pub use self::names::{Expected, Known, known, position};
pub use self::raw::{Named, Node, Raw, Value, load_raw, read_raw};
#[cfg(feature = "full")]
pub(crate) use self::scope::Scope;
pub use self::shipped::{DEFAULT_BICYCLE, default_name, kind, names};
pub use self::value::{evaluated, measured};
#[cfg(feature = "full")]
pub(crate) use self::value::{number as value_of, validate};

/// Where the parameters come from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Request {
    /// The name of the model; otherwise a file chooses it, or it is the one of the bicycles.
    pub model: Option<String>,
    /// The name of what ships for the model, a path, or `-` for the standard input; otherwise the first that ships.
    pub parameters: Option<String>,
    /// Values from the command line: the option as it was given, the name and the value.
    pub overrides: Vec<(String, String, String)>,
    /// Laws of feedback from the command line, each with the option as it was given. A file's law for the same force gives way.
    pub feedback: Vec<(String, String)>,
    /// Bodies that are joined to frames, each with the option as it was given: files, or what they are in one line. What the
    /// overrides make of a frame, they are joined to.
    #[cfg(feature = "full")]
    pub bodies: Vec<(String, String)>,
}

impl Request {
    /// Whether the parameters are read from this file, so that nothing must be written there.
    pub fn reads(&self, path: &Path) -> bool {
        let is_same = |name: &String| is_same_file(Path::new(name), path);
        #[cfg(feature = "full")]
        let reads_body = self.bodies.iter().any(|(_, text)| is_same(text));
        #[cfg(not(feature = "full"))]
        let reads_body = false;
        self.parameters.as_ref().is_some_and(is_same) || reads_body
    }
}

/// What replaces something of a file.
#[derive(Default)]
struct Changes {
    overrides: Vec<Entry>,
    laws: Vec<(Place, String)>,
    #[cfg(feature = "full")]
    bodies: Vec<Body>,
}

impl Changes {
    /// Of values and laws alone.
    fn new(overrides: Vec<Entry>, laws: Vec<(Place, String)>) -> Self {
        Self {
            overrides,
            laws,
            #[cfg(feature = "full")]
            bodies: Vec::new(),
        }
    }
}

/// What the parameters of a real machine would hardly be.
#[cfg(feature = "full")]
pub(crate) fn warnings(info: &carvallo::ModelInfo, values: &[f64]) -> Vec<String> {
    let mut warnings = magnitude::warnings(info, values);
    warnings.extend(plausible::warnings(info, values));
    warnings
}

/// Whether two paths are of one file, which is there.
pub fn is_same_file(first: &Path, second: &Path) -> bool {
    first.canonicalize().is_ok_and(|first| second.canonicalize().is_ok_and(|second| first == second))
}

/// Reads and judges the parameters.
///
/// # Errors
/// Everything that is wrong with the request or the file, or that the file cannot be read.
pub fn load(request: &Request) -> Result<Design, Failure> {
    let overrides = entries(&request.overrides);
    let asked = request.model.as_ref().map(|name| {
        let place = Place::Option(format!("--model {name}"));
        Kind::called(name).map_err(|message| Failure::Input(vec![Problem { place, message }]))
    });
    let asked = asked.transpose()?;
    let expected = asked.unwrap_or(Kind::Shipped(&WHIPPLE));
    let shipped = expected.shipped();
    let name = request.parameters.as_deref().or_else(|| shipped.and_then(shipped::default_name));
    let Some(name) = name else {
        return Err(Failure::usage(format!(
            "no parameter set ships for the model {}: expected a file",
            expected.name()
        )));
    };
    let (label, document) = open(shipped, name)?;
    let laws = placed(&request.feedback);
    #[cfg(feature = "full")]
    let bodies = bodies(&request.bodies)?;
    let changes = Changes {
        overrides,
        laws,
        #[cfg(feature = "full")]
        bodies,
    };
    resolve(document, label, asked, changes)
}

/// What is wrong with several of them is told at once.
#[cfg(feature = "full")]
fn bodies(texts: &[(String, String)]) -> Result<Vec<Body>, Failure> {
    let (mut bodies, mut problems) = (Vec::new(), Vec::new());
    for (option, text) in texts {
        match crate::joined::read(option, text) {
            Ok(body) => bodies.push(body),
            Err(Failure::Input(found)) => problems.extend(found),
            Err(failure) => return Err(failure),
        }
    }
    if problems.is_empty() { Ok(bodies) } else { Err(Failure::Input(problems)) }
}

/// Reads and judges what ships for a model under a name, or a file for it.
///
/// # Errors
/// Everything that is wrong with the name or the file, or that the file cannot be read.
pub fn load_for(model: &'static Shipped, name: &str) -> Result<Design, Failure> {
    let (label, document) = open(Some(model), name)?;
    resolve(document, label, Some(Kind::Shipped(model)), Changes::default())
}

/// Judges values for a model, each with its name as files have it.
///
/// # Errors
/// Everything that is wrong with them.
pub fn given(
    model: &'static Shipped,
    label: &str,
    values: impl IntoIterator<Item = (String, String)>,
) -> Result<Design, Failure> {
    let entry = |(name, text): (String, String)| Entry::from_text(&name, Place::Option(label.to_owned()), &text);
    let document = Document { entries: values.into_iter().map(entry).collect(), ..Document::default() };
    resolve(document, label, Some(Kind::Shipped(model)), Changes::default())
}

/// What ships under a name, or what is in a file or the standard input; with what it is called.
fn open<'a>(shipped: Option<&Shipped>, name: &'a str) -> Result<(&'a str, Document), Failure> {
    if let Some(document) = shipped.and_then(|shipped| shipped::find(shipped, name)) {
        Ok((name, document))
    } else if let Some((label, bytes)) = contents(name)? {
        Ok((label, parse(label, bytes)?))
    } else {
        Err(Failure::usage(match shipped {
            Some(shipped) => shipped::unknown(shipped, name),
            None => format!("there is no file {name}"),
        }))
    }
}

/// What is in a file or the standard input, with what it is called; `None` if there is no such file.
fn contents(name: &str) -> Result<Option<(&str, Vec<u8>)>, Failure> {
    if name == "-" {
        let mut bytes = Vec::new();
        let read = std::io::stdin().lock().read_to_end(&mut bytes);
        read.map_err(|error| Failure::Run(format!("cannot read the standard input: {error}")))?;
        Ok(Some(("<stdin>", bytes)))
    } else if Path::new(name).exists() {
        let bytes = std::fs::read(name).map_err(|error| Failure::Run(format!("cannot read {name}: {error}")))?;
        Ok(Some((name, bytes)))
    } else {
        Ok(None)
    }
}

/// Reads and judges the contents of a file; the ending of its label tells the format, or else what is in it.
///
/// # Errors
/// Everything that is wrong with it.
pub fn read(label: &str, bytes: Vec<u8>) -> Result<Design, Failure> {
    read_changed(label, bytes, &[], None)
}

/// The same with values that replace those of the file, each with what messages call it, its name and the value; and with laws
/// of feedback that replace all of the file, each with what messages call it.
///
/// # Errors
/// Everything that is wrong with the file, the values or the laws.
pub fn read_changed(
    label: &str,
    bytes: Vec<u8>,
    overrides: &[(String, String, String)],
    feedback: Option<&[(String, String)]>,
) -> Result<Design, Failure> {
    let mut document = parse(label, bytes)?;
    if feedback.is_some() {
        document.feedback.clear();
    }
    let laws = placed(feedback.unwrap_or_default());
    resolve(document, label, None, Changes::new(entries(overrides), laws))
}

fn entries(overrides: &[(String, String, String)]) -> Vec<Entry> {
    let entry =
        |(option, name, value): &(String, String, String)| Entry::from_text(name, Place::Option(option.clone()), value);
    overrides.iter().map(entry).collect()
}

fn placed(laws: &[(String, String)]) -> Vec<(Place, String)> {
    laws.iter().map(|(option, law)| (Place::Option(option.clone()), law.clone())).collect()
}

/// Judges the parameters by the model that was asked for, or else the one that they name themselves.
fn resolve(mut document: Document, label: &str, asked: Option<Kind>, changes: Changes) -> Result<Design, Failure> {
    let kind = match (asked, &document.model) {
        (None, None) => Ok(Kind::Shipped(&WHIPPLE)),
        (None, Some(name)) => Kind::called(name),
        (Some(asked), Some(name)) if !asked.is_called(name) => {
            Err(format!("the parameters are for the model `{name}`, but --model is {}", asked.name()))
        }
        (Some(asked), _) => Ok(asked),
    };
    let model = kind.and_then(|kind| match (kind, &document.form) {
        (Kind::Shipped(model), None) => Ok(Some(model)),
        (Kind::Shipped(model), Some(_)) => {
            Err(format!("there are matrices in the place of parameters of the model `{}`", model.info.name))
        }
        (Kind::Matrices, Some(form)) => Ok(Some(crate::matrices::model(form))),
        (Kind::Matrices, None) if document.problems.is_empty() => {
            Err("there are no matrices; expected `M` and others, in JSON or TOML".to_owned())
        }
        (Kind::Matrices, None) => Ok(None),
    });
    match model {
        Ok(Some(model)) => parameters::resolve(document, label, model, changes).map_err(Failure::Input),
        Ok(None) => Err(Failure::Input(document.problems)),
        Err(message) => {
            document.problem(Place::File(label.to_owned()), message);
            Err(Failure::Input(document.problems))
        }
    }
}

/// What a model can be.
#[derive(Clone, Copy)]
enum Kind {
    Shipped(&'static Shipped),
    /// That of given matrices.
    Matrices,
}

impl Kind {
    fn called(name: &str) -> Result<Self, String> {
        if crate::matrices::is_called(name) { Ok(Self::Matrices) } else { Shipped::called(name).map(Self::Shipped) }
    }

    fn is_called(self, name: &str) -> bool {
        match self {
            Self::Shipped(model) => model.is_called(name),
            Self::Matrices => crate::matrices::is_called(name),
        }
    }

    fn name(self) -> &'static str {
        self.shipped().map_or(crate::matrices::NAME, |model| model.info.name)
    }

    fn shipped(self) -> Option<&'static Shipped> {
        match self {
            Self::Shipped(model) => Some(model),
            Self::Matrices => None,
        }
    }
}

fn parse(label: &str, bytes: Vec<u8>) -> Result<Document, Failure> {
    let text = decode(label, bytes)?;
    let file = File { label, text: &text };
    Ok(match Form::of(file) {
        Form::Toml => toml::read(file),
        Form::Json => json::read(file),
        Form::Lines(separator) => lines::read(file, separator),
        #[cfg(feature = "full")]
        Form::Cells => cells::read(file),
    })
}

/// The contents of a file as text.
fn decode(label: &str, bytes: Vec<u8>) -> Result<String, Failure> {
    let mut text = match String::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => latin_script(label, error.as_bytes()).ok_or_else(|| {
            let before = error.as_bytes().iter().take(error.utf8_error().valid_up_to());
            let line = 1 + before.filter(|&&byte| byte == b'\n').count();
            Failure::at(Place::Line(label.to_owned(), line), "this is not UTF-8 text")
        })?,
    };
    // Some editors begin a file with a byte order mark.
    if text.starts_with('\u{feff}') {
        text.remove(0);
    }
    Ok(text)
}

/// How names and values stand in a file.
enum Form {
    Toml,
    Json,
    /// One of each a line, with this between them.
    Lines(char),
    /// One of each a line, in columns that have names.
    #[cfg(feature = "full")]
    Cells,
}

impl Form {
    fn of(file: File) -> Self {
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

/// A script of MATLAB in Latin-1, as older programs write them, for the sake of comments such as `% ©`.
fn latin_script(label: &str, bytes: &[u8]) -> Option<String> {
    if !cfg!(feature = "full") {
        return None;
    }
    let text: String = bytes.iter().map(|&byte| char::from(byte)).collect();
    let is_text = !text.contains(|sign: char| sign.is_control() && !sign.is_whitespace());
    (is_text && lines::is_matlab(File { label, text: &text })).then_some(text)
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
