//! Parameters of a model: shipped ones by name, and files in any of the formats that people have.

#[cfg(feature = "full")]
mod cells;
#[cfg(feature = "full")]
mod correlations;
mod document;
#[cfg(feature = "full")]
mod encodings;
mod entries;
mod form;
mod json;
mod kind;
mod lines;
mod magnitude;
mod matrices;
mod members;
mod names;
mod neutral;
mod parameters;
mod plausible;
mod raw;
mod request;
mod scope;
mod shipped;
mod tables;
mod texts;
mod toml;
#[cfg(feature = "full")]
mod unclosed;
mod value;

use std::io::Read as _;
use std::path::Path;

#[cfg(feature = "full")]
pub(crate) use self::correlations::{Names, resolve as resolve_correlations};
#[cfg(feature = "full")]
pub(crate) use self::document::Written;
pub(crate) use self::document::{Document, Entry};
use self::form::parse;
use self::kind::Kind;
use crate::design::Design;
use crate::failure::{Failure, Place, Problem};
#[cfg(feature = "full")]
use crate::joined::Body;
use crate::model::{Shipped, WHIPPLE};

#[cfg(feature = "full")]
pub use self::encodings::{in_utf8, text};
pub use self::entries::given_twice;
pub use self::form::decode;
#[cfg(feature = "full")]
pub use self::magnitude::{too_large, warning_of_varied, warnings_of_body};
pub use self::matrices::{list, matrix_of_rows};
pub use self::names::{Expected, Known, known, position};
#[cfg(feature = "full")]
pub(crate) use self::names::{is_of_part, is_part, without_owner};
pub use self::raw::{Named, Node, Raw, Value, load_raw, read_raw};
pub use self::request::{Request, is_same_file};
#[cfg(feature = "full")]
pub(crate) use self::scope::Scope;
pub use self::shipped::{DEFAULT_BICYCLE, default_name, kind, names};
pub use self::value::{evaluated, measured};
#[cfg(feature = "full")]
pub(crate) use self::value::{number as value_of, validate};

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

/// What the parameters of a real machine would hardly be; how large they are is judged by values of their own.
#[cfg(feature = "full")]
pub(crate) fn warnings(info: &carvallo::ModelInfo, sizes: &[f64], values: &[f64]) -> Vec<String> {
    let mut warnings = magnitude::warnings(info, sizes);
    warnings.extend(plausible::warnings(info, values));
    warnings
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

/// The same of values that were computed, and that nobody wrote in another unit.
///
/// # Errors
/// Everything that is wrong with them.
#[cfg(feature = "full")]
pub fn computed(
    model: &'static Shipped,
    label: &str,
    values: impl IntoIterator<Item = (String, String)>,
) -> Result<Design, Failure> {
    let design = given(model, label, values)?;
    let warnings = plausible::warnings(design.info(), &design.values());
    Ok(Design { warnings, ..design })
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

/// That a folder stands where a file is expected.
pub fn is_folder(name: &str) -> String {
    format!("there is no file {name}: it is a folder")
}

/// What is in a file or the standard input, with what it is called; `None` if there is no such file.
fn contents(name: &str) -> Result<Option<(&str, Vec<u8>)>, Failure> {
    if name == "-" {
        let mut bytes = Vec::new();
        let read = std::io::stdin().lock().read_to_end(&mut bytes);
        read.map_err(|error| Failure::Run(format!("cannot read the standard input: {error}")))?;
        Ok(Some(("<stdin>", bytes)))
    } else if Path::new(name).exists() {
        if Path::new(name).is_dir() {
            return Err(Failure::usage(is_folder(name)));
        }
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
