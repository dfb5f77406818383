//! From what was written to the parameters of a model: every name and every value is judged, all at once.

use std::collections::HashMap;

use carvallo::ModelInfo;

use super::document::{Document, Entry};
use super::names;
use super::shipped::{DEFAULT_BICYCLE, default_name};
use super::value::validate;
use crate::design::Design;
use crate::failure::{Place, Problem};
use crate::model::Shipped;
use crate::nearest::nearest;
use crate::quantity::no_names;

/// Judges a file together with the values of the command line, which replace those of the file.
///
/// # Errors
/// Everything that is wrong.
pub fn resolve(
    document: Document,
    label: &str,
    model: &'static Shipped,
    overrides: Vec<Entry>,
) -> Result<Design, Vec<Problem>> {
    let info = model.info;
    let mut problems = document.problems;
    let unreadable = !problems.is_empty();
    let is_empty = document.entries.is_empty();
    let mut notes = Vec::new();
    let mut given = collect(document.entries, info, &mut problems, &mut notes);
    for (position, entry) in collect(overrides, info, &mut problems, &mut notes) {
        given.insert(position, entry);
    }

    let mut missing = Vec::new();
    let mut parameters = Vec::new();
    for (position, parameter) in info.parameters.iter().enumerate() {
        match given.get(&position).map(|entry| validate(entry, parameter, &no_names)) {
            Some(Ok(given)) => parameters.push(given),
            Some(Err(mut found)) => problems.append(&mut found),
            None => missing.push(format!("`{}`", parameter.name)),
        }
    }
    // What cannot be read may hold what seems to be missing.
    if !missing.is_empty() && !unreadable {
        let message = match is_empty {
            true => format!("it has no parameters{}", start(model)),
            false => format!("missing: {} (of {} parameters)", missing.join(", "), info.parameters.len()),
        };
        problems.push(Problem { place: Place::File(label.to_owned()), message });
    }
    if !problems.is_empty() {
        problems.sort_by(|a, b| a.place.cmp(&b.place));
        // A parser that recovers may meet the same mistake again.
        problems.dedup();
        return Err(problems);
    }

    let fail = |message: String| vec![Problem { place: Place::File(label.to_owned()), message }];
    let values: Vec<f64> = parameters.iter().map(|parameter| parameter.value).collect();
    let equations = model.equations(&values).map_err(fail)?;
    let name = document.name.unwrap_or_else(|| label.to_owned());
    Ok(Design { name, kind: document.kind, source: document.source, model, parameters, equations, notes })
}

/// How to get a file to start from, if there is one for the model.
fn start(model: &Shipped) -> String {
    let arguments = match default_name(model) {
        None => return String::new(),
        Some(_) if model.is_whipple() => DEFAULT_BICYCLE.to_owned(),
        Some(_) => format!("--model {}", model.info.name),
    };
    format!("; `carvallo show {arguments}` prints a file to start from")
}

/// The entries by the position of their parameter; what has no such position is a problem or a note.
fn collect(
    entries: Vec<Entry>,
    info: &ModelInfo,
    problems: &mut Vec<Problem>,
    notes: &mut Vec<String>,
) -> HashMap<usize, Entry> {
    let mut given: HashMap<usize, Entry> = HashMap::new();
    for entry in entries {
        if let Some(position) = info.position(&entry.name) {
            if let Some(first) = given.get(&position) {
                let message = format!("`{}` is given twice; first at {}", entry.name, first.place);
                problems.push(Problem { place: entry.place, message });
            } else {
                given.insert(position, entry);
            }
        } else if let Some(reason) = names::ignored(&entry.name, info) {
            notes.push(format!("{}: `{}` is ignored: {reason}", entry.place, entry.name));
        } else {
            let known = info.parameters.iter().map(|parameter| parameter.name);
            let hint = nearest(&entry.name, known).map(|name| format!("; did you mean `{name}`?"));
            let message = format!("`{}` is not a parameter of {}{}", entry.name, info.name, hint.unwrap_or_default());
            problems.push(Problem { place: entry.place, message });
        }
    }
    given
}
