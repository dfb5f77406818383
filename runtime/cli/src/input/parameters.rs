//! From what was written to the parameters of a model: every name and every value is judged, all at once.

use std::collections::HashMap;

use carvallo::{Model, ModelInfo};

use super::document::{Document, Entry};
use super::names;
use super::value::judge;
use crate::failure::{Place, Problem};

/// A bicycle as it was given, with the model that it makes.
#[derive(Debug)]
pub struct Bicycle<M> {
    pub name: String,
    pub kind: Option<String>,
    pub source: Option<String>,
    pub model: M,
    /// The parameters in the order of the model.
    pub parameters: Vec<Given>,
    /// What was read but not used.
    pub notes: Vec<String>,
}

/// One parameter that was given.
#[derive(Clone, Debug)]
pub struct Given {
    /// As it was written: a number, or an expression.
    pub written: String,
    pub value: f64,
    /// The standard deviation of its measurement as it was written, unless it is 0.
    pub deviation: Option<String>,
}

impl<M: Model<2, Scalar = f64>> Bicycle<M> {
    /// What the model tells about itself.
    pub fn info(&self) -> &'static ModelInfo {
        M::INFO
    }

    /// The value of the parameter called `name`.
    pub fn value(&self, name: &str) -> Option<f64> {
        self.parameters.get(M::INFO.position(name)?).map(|given| given.value)
    }
}

/// Judges a file together with the values of the command line, which replace those of the file.
///
/// # Errors
/// Everything that is wrong.
pub fn resolve<M: Model<2, Scalar = f64>>(
    document: Document,
    label: &str,
    overrides: Vec<Entry>,
) -> Result<Bicycle<M>, Vec<Problem>> {
    let mut problems = document.problems;
    let unreadable = !problems.is_empty();
    if let Some(model) = document.model.filter(|model| !model.eq_ignore_ascii_case(M::INFO.name)) {
        let message = format!("the parameters are for the model `{model}`; only {} is known", M::INFO.name);
        problems.push(Problem { place: Place::File(label.to_owned()), message });
    }
    let is_empty = document.entries.is_empty();
    let mut notes = Vec::new();
    let mut given = collect(document.entries, M::INFO, &mut problems, &mut notes);
    for (position, entry) in collect(overrides, M::INFO, &mut problems, &mut notes) {
        given.insert(position, entry);
    }

    let mut missing = Vec::new();
    let mut parameters = Vec::new();
    for (position, info) in M::INFO.parameters.iter().enumerate() {
        match given.get(&position).map(|entry| judge(entry, info)) {
            Some(Ok(parameter)) => parameters.push(parameter),
            Some(Err(mut found)) => problems.append(&mut found),
            None => missing.push(format!("`{}`", info.name)),
        }
    }
    // What cannot be read may hold what seems to be missing.
    if !missing.is_empty() && !unreadable {
        let message = match is_empty {
            true => "it has no parameters; `carvallo show benchmark` prints a file to start from".to_owned(),
            false => format!("missing: {} (of {} parameters)", missing.join(", "), M::INFO.parameters.len()),
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
    let model = M::from_slice(&values).map_err(|error| fail(error.to_string()))?;
    model.validate().map_err(|error| {
        let value = names::with_unit(error.value, error.unit);
        fail(format!("`{}` is {value}; it must be {}", error.subject, error.required))
    })?;
    let name = document.name.unwrap_or_else(|| label.to_owned());
    Ok(Bicycle { name, kind: document.kind, source: document.source, model, parameters, notes })
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
        } else if let Some(reason) = names::ignored(&entry.name) {
            notes.push(format!("{}: `{}` is ignored: {reason}", entry.place, entry.name));
        } else {
            let known = info.parameters.iter().map(|parameter| parameter.name);
            let hint = names::nearest(&entry.name, known).map(|name| format!("; did you mean `{name}`?"));
            let message = format!("`{}` is not a parameter of {}{}", entry.name, info.name, hint.unwrap_or_default());
            problems.push(Problem { place: entry.place, message });
        }
    }
    given
}
