//! Which parameter each entry of a file is for, and what is to be said of those that are for none.

use std::collections::HashMap;
use std::fmt::Display;

use carvallo::{ModelInfo, ParameterInfo};

use super::document::Entry;
use super::names::{self, Expected, Known};
use super::scope::Scope;
use super::value;
use crate::failure::{Place, Problem};
use crate::matrices;
use crate::nearest::nearest;
use crate::number::{shortest, with_unit};

/// The entries of a file, or of the command line, by what they are for.
#[derive(Default)]
pub struct Entries<'a> {
    /// By the position of the parameter.
    pub given: HashMap<usize, &'a Entry>,
    /// The other half of a symmetric tensor, where both are given.
    mirrored: Vec<(usize, &'a Entry)>,
    /// What the field carries along and no model needs.
    known: Vec<(Known, &'a Entry)>,
    /// Everything else.
    pub unknown: Vec<&'a Entry>,
}

impl<'a> Entries<'a> {
    pub fn new(entries: &'a [Entry], info: &ModelInfo, problems: &mut Vec<Problem>) -> Self {
        let mut sorted = Self::default();
        for entry in entries {
            let Some(position) = names::position(&entry.name, info) else {
                match names::known(&entry.name, info) {
                    Some(known) => sorted.known.push((known, entry)),
                    None => sorted.unknown.push(entry),
                }
                continue;
            };
            match sorted.given.get(&position) {
                Some(first) if is_mirrored(first) != is_mirrored(entry) => sorted.mirrored.push((position, entry)),
                Some(first) => {
                    let message = given_twice(&entry.name, &first.name, &first.place);
                    problems.push(Problem { place: entry.place.clone(), message });
                }
                None => {
                    sorted.given.insert(position, entry);
                }
            }
        }
        sorted
    }

    /// Whether what is given twice is the same, and what a model takes for granted is so.
    pub fn check(&self, scope: &Scope, info: &'static ModelInfo, remarks: &mut Remarks) {
        for (position, entry) in &self.mirrored {
            let parameter = &info.parameters[*position];
            let first = self.given[position];
            let [a, b] = [first, entry].map(|entry| value::number(entry, parameter, &|name| scope.value(name)));
            if let (Ok(a), Ok(b)) = (a, b)
                && !is_close(a, b)
            {
                let [a, b] = [a, b].map(|value| with_unit(value, parameter.unit));
                let message =
                    format!("`{}` is {b}, but `{}` is {a}; inertia tensors are symmetric", entry.name, first.name);
                remarks.problems.push(Problem { place: entry.place.clone(), message });
            }
        }
        for (Known { name, beside, value: expected, reason }, entry) in &self.known {
            // The unit and the domain of what it stands beside, whatever its sign.
            let parameter = ParameterInfo { name, ..info.parameters[*beside] };
            let found = match expected {
                Expected::Any => Ok(0.0),
                _ => value::number(entry, &parameter, &|name| scope.value(name)),
            };
            let value = match found {
                Ok(value) => value,
                Err(problem) => {
                    remarks.problems.push(problem);
                    continue;
                }
            };
            let other = info.parameters[*beside].name;
            let required = match expected {
                Expected::Any => None,
                Expected::Zero => Some(0.0),
                Expected::Equal => scope.value(other).and_then(Result::ok),
            };
            let differs = required.filter(|required| !is_close(*required, value));
            match (expected, differs.map(|required| with_unit(required, parameter.unit))) {
                (Expected::Equal, None) => {
                    remarks.ignored(&entry.place, &entry.name, format!("{reason}, so it equals {other}"))
                }
                (_, None) => remarks.ignored(&entry.place, &entry.name, (*reason).to_owned()),
                (Expected::Equal, Some(required)) => remarks.warnings.push(format!(
                    "`{0}` is {1}, but `{other}` is {required}: {reason}, and `{0}` is not used",
                    entry.name,
                    with_unit(value, parameter.unit),
                )),
                (_, Some(_)) => {
                    let value = shortest(value);
                    remarks.warnings.push(format!("`{0}` is {value}, but {reason}, and `{0}` is not used", entry.name));
                }
            }
        }
    }

    /// What is said of names that are not known: a slip of the pen where something is missing, or of no use here.
    pub fn check_unknown(&self, scope: &Scope, info: &ModelInfo, missing: &Missing, remarks: &mut Remarks) {
        let mut unused: Vec<&Entry> = Vec::new();
        for &entry in self.unknown.iter().filter(|entry| !scope.is_used(entry)) {
            let hint = nearest(&entry.name, missing.names.iter().copied());
            if info.name == matrices::NAME {
                let message = super::matrices::unknown(&entry.name);
                remarks.problems.push(Problem { place: entry.place.clone(), message });
            } else if missing.is_serious || hint.is_some() {
                remarks.problems.push(unknown(entry, info, hint));
            } else {
                unused.push(entry);
            }
        }
        if let [first, ..] = unused[..] {
            let names: Vec<String> =
                unused.iter().map(|entry| format!("`{}`{}", entry.name, meant(entry, info))).collect();
            let (file, name) = (first.place.file(), info.name);
            remarks.notes.push(format!("{file}: no parameters of {name}, and not used: {}", names.join(", ")));
        }
    }
}

/// The parameter that is called so but for capitals, which count, in parentheses.
#[cfg(feature = "full")]
fn meant(entry: &Entry, info: &ModelInfo) -> String {
    let meant = crate::conventions::folded(&entry.name, info);
    meant.map(|name| format!(" (did you mean `{name}`?)")).unwrap_or_default()
}

#[cfg(not(feature = "full"))]
fn meant(_: &Entry, _: &ModelInfo) -> &'static str {
    ""
}

/// The parameters that are not given.
pub struct Missing<'a> {
    pub names: Vec<&'a str>,
    /// Whether one of them has no value that is as good as any.
    pub is_serious: bool,
}

/// That something is given a second time, perhaps by another of its names.
pub fn given_twice(name: &str, first: &str, place: &dyn Display) -> String {
    let spelled = if first == name { String::new() } else { format!(" as `{first}`") };
    format!("`{name}` is given twice; first{spelled} at {place}")
}

/// That there is no parameter of this name, and what may have been meant.
pub fn unknown(entry: &Entry, info: &ModelInfo, hint: Option<&str>) -> Problem {
    let hint = hint.map(|name| format!("; did you mean `{name}`?"));
    #[cfg(feature = "full")]
    let hint = hint.or_else(|| crate::conventions::hint(&entry.name, info)).or_else(|| {
        let meant = crate::nearest(&entry.name, ["parameters", "matrices"])?;
        Some(format!("; did you mean `{meant}`, a group?"))
    });
    let message = format!("`{}` is not a parameter of {}{}", entry.name, info.name, hint.unwrap_or_default());
    Problem { place: entry.place.clone(), message }
}

/// That settings are of no parameters of a model. Of those that could be set, something else is wrong, which is told elsewhere.
pub fn unknown_settings(settings: &[&Entry], info: &'static ModelInfo) -> Vec<Problem> {
    let problem = |entry: &&Entry| {
        #[cfg(feature = "full")]
        let refusal =
            crate::conventions::settable(&entry.name, settings.iter().map(|other| &*other.name), info).err()?;
        #[cfg(not(feature = "full"))]
        let refusal: Option<String> = None;
        let hint = || nearest(&entry.name, info.parameters.iter().map(|parameter| parameter.name));
        Some(match refusal {
            Some(message) => Problem { place: entry.place.clone(), message },
            None => unknown(entry, info, hint()),
        })
    };
    settings.iter().filter_map(problem).collect()
}

/// What there is to say of a file.
#[derive(Default)]
pub struct Remarks {
    pub problems: Vec<Problem>,
    pub warnings: Vec<String>,
    pub notes: Vec<String>,
    /// Where something is ignored, what, and why.
    ignored: Vec<(Place, Vec<String>, String)>,
}

impl Remarks {
    pub fn new(problems: Vec<Problem>) -> Self {
        Self { problems, ..Self::default() }
    }

    /// What is in one line for one reason is told at once.
    fn ignored(&mut self, place: &Place, name: &str, reason: String) {
        let name = format!("`{name}`");
        match self.ignored.last_mut() {
            Some((last, names, why)) if last == place && *why == reason => names.push(name),
            _ => self.ignored.push((place.clone(), vec![name], reason)),
        }
    }

    /// All notes, in the order in which they were found.
    pub fn all_notes(&self) -> Vec<String> {
        let ignored = self.ignored.iter().map(|(place, names, reason)| {
            let are = if names.len() == 1 { "is" } else { "are" };
            format!("{place}: {} {are} ignored: {reason}", names.join(", "))
        });
        ignored.chain(self.notes.iter().cloned()).collect()
    }
}

/// The entry below the diagonal of a symmetric tensor.
fn is_mirrored(entry: &Entry) -> bool {
    entry.name.ends_with("zx")
}

/// Equal but for the rounding of the last digits.
fn is_close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
}
