//! From a file in some convention to the parameters of the paper.

use std::collections::HashMap;

use carvallo::{Domain, ModelInfo, ParameterInfo};

use super::dual::Dual;
use super::name::{Name, Need, Values};
use super::recognise::recognise;
use super::{Convention, SPLIT};
use crate::design::Given;
use crate::failure::{Place, Problem};
use crate::input::{Document, Entry, Scope, position, validate};
use crate::number::{shortest, with_unit};

/// How a file was read that is not in the names of the paper.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The convention that it is in.
    pub convention: &'static Convention,
    /// The parameters of the paper that it does not tell, and that no motion depends on.
    pub assumed: Vec<&'static str>,
}

/// Puts the parameters of the paper in the place of those of the convention that a file is in, if it is in another. Settings
/// that are in the same convention take part in it; the others are left.
pub fn read(
    document: &mut Document,
    label: &str,
    info: &'static ModelInfo,
    settings: &mut Vec<Entry>,
) -> Option<Reading> {
    if !has_paper(info) {
        return None;
    }
    let convention = match &document.parameterization {
        Some((place, name)) => match Convention::find(name) {
            Some(convention) => convention,
            None => {
                let message = Convention::unknown(name);
                document.problems.push(Problem { place: place.clone(), message });
                document.entries = Vec::new();
                return None;
            }
        },
        None => recognise(&document.entries, info)?,
    };
    if convention.is_paper() {
        return None;
    }
    (convention.prepare)(&mut document.entries, &mut document.problems);
    (convention.prepare)(settings, &mut document.problems);
    let (own, others): (Vec<Entry>, Vec<Entry>) =
        std::mem::take(&mut document.entries).into_iter().partition(|entry| convention.known(&entry.name).is_some());
    let (mine, left) = std::mem::take(settings).into_iter().partition(|entry| convention.known(&entry.name).is_some());
    *settings = left;
    let problems = document.problems.len();
    let scope = Scope::new(own.iter().chain(&others), HashMap::new(), crate::model::WHIPPLE.info);
    let source = Source { convention, label, own: &own, settings: &mine, scope: &scope };
    let result = source.translate(info, document);
    let Some((paper, assumed)) = result.filter(|_| document.problems.len() == problems) else {
        // What is wrong is told; nothing is said of what would be missing.
        document.entries = Vec::new();
        return None;
    };
    document
        .notes
        .push(format!("{label}: in {}; the parameters of the paper are computed from them", convention.title));
    if !assumed.is_empty() {
        document.notes.push(format!(
            "{label}: {} are not told by two gyrostats; wheels without mass are taken, with which all motions are the same",
            list(&assumed)
        ));
    }
    check_others(&others, &paper, info, label, document);
    // What others are computed from is used, and is no parameter of the model.
    let is_left = |entry: &Entry| position(&entry.name, info).is_none() && !scope.is_used(entry);
    let left: Vec<Entry> = others.iter().filter(|entry| is_left(entry)).cloned().collect();
    document.entries = paper.into_iter().chain(left).collect();
    Some(Reading { convention, assumed })
}

/// Whether a model has the parameters of the paper.
pub fn has_paper(info: &ModelInfo) -> bool {
    crate::model::WHIPPLE.info.parameters.iter().all(|parameter| info.position(parameter.name).is_some())
}

fn list(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// What a file in a convention has.
struct Source<'a> {
    convention: &'static Convention,
    label: &'a str,
    /// The entries that belong to the convention.
    own: &'a [Entry],
    /// Those of the command line that replace some of them.
    settings: &'a [Entry],
    /// What values may refer to.
    scope: &'a Scope<'a>,
}

impl Source<'_> {
    /// The parameters of the paper as entries, and those that are assumed; nothing if something is wrong, which is told.
    fn translate(&self, info: &ModelInfo, document: &mut Document) -> Option<(Vec<Entry>, Vec<&'static str>)> {
        let Self { convention, label, .. } = *self;
        let given = self.values(document);
        let is_given = |name: &str| given.iter().any(|(own, _)| own.name == name);
        let missing: Vec<String> = convention
            .needed()
            .iter()
            .filter(|group| !group.iter().any(|name| is_given(name)))
            .map(|group| match group[..] {
                [name, other, ..] => format!("`{name}` (or `{other}`)"),
                _ => list(group),
            })
            .collect();
        let file = || Place::File(label.to_owned());
        if !missing.is_empty() && document.problems.is_empty() {
            let message = format!("missing: {}, of {}", missing.join(", "), convention.title);
            document.problem(file(), message);
        }
        self.check_extras(&given, document);
        if !document.problems.is_empty() {
            return None;
        }
        let mut values = Values::default();
        given.iter().for_each(|(name, given)| values.push(name.name, given.value.into()));
        let paper = match (convention.to_paper)(&values) {
            Ok(paper) => paper,
            Err(message) => {
                document.problem(file(), message);
                return None;
            }
        };
        let deviations: Vec<f64> =
            given.iter().map(|(_, given)| given.deviation.as_ref().map_or(0.0, |deviation| deviation.value)).collect();
        let spread = spread(&values, &deviations, convention.to_paper);
        if deviations.iter().any(|deviation| *deviation > 0.0) {
            document.notes.push(format!(
                "{label}: standard deviations are carried to first order, each by itself: without the correlations"
            ));
        }
        let entry = |(name, value): (&'static str, Dual)| {
            let deviation = spread.iter().find(|(own, _)| *own == name).map_or(0.0, |(_, deviation)| *deviation);
            let mut entry = Entry::from_text(name, file(), &shortest(value.value));
            entry.deviation = (deviation > 0.0).then(|| crate::input::Written::Text(shortest(deviation)));
            entry
        };
        let assumed = SPLIT.into_iter().filter(|name| convention.name == "gyrostats" && !is_given(name)).collect();
        let entries = paper.iter().filter(|(name, _)| info.position(name).is_some()).map(entry).collect();
        Some((entries, assumed))
    }

    /// The values of its parameters, of which settings replace some.
    fn values(&self, document: &mut Document) -> Vec<(&'static Name, Given)> {
        let Self { convention, own, settings, scope, .. } = *self;
        let setting_scope = Scope::new(settings, known_values(own, scope), crate::model::WHIPPLE.info);
        let mut given: Vec<(&Name, Given)> = Vec::new();
        let sources = [(settings, &setting_scope), (own, scope)];
        for (from, (entries, scope)) in sources.into_iter().enumerate() {
            let mut seen: Vec<(&Name, &Place)> = Vec::new();
            for entry in entries {
                let Some(name) = convention.parameter(&entry.name) else { continue };
                if let Some((_, first)) = seen.iter().find(|(own, _)| std::ptr::eq(*own, name)) {
                    let message = format!("`{}` is given twice; first at {first}", entry.name);
                    document.problems.push(Problem { place: entry.place.clone(), message });
                    continue;
                }
                seen.push((name, &entry.place));
                if from == 1 && given.iter().any(|(own, _)| std::ptr::eq(*own, name)) {
                    continue;
                }
                match validate(entry, &parameter(name), &|name: &str| scope.value(name)) {
                    Ok(value) => given.push((name, value)),
                    Err(problems) => document.problems.extend(problems),
                }
            }
        }
        given
    }

    /// Whether what files carry along is what it must be.
    fn check_extras(&self, given: &[(&Name, Given)], document: &mut Document) {
        let Self { convention, own, scope, .. } = *self;
        let mut ignored: Vec<(&str, Vec<&str>, Place)> = Vec::new();
        for entry in own {
            let Some(name) = convention.known(&entry.name).filter(|name| !name.is_parameter()) else { continue };
            let (required, reason) = match name.need {
                Need::Zero(reason) => (Some((0.0, "0".to_owned())), reason),
                Need::Equal(other, reason) => {
                    let value = given.iter().find(|(own, _)| own.name == other).map(|(_, given)| given.value);
                    (value.map(|value| (value, format!("that of `{other}`, {}", with_unit(value, name.unit)))), reason)
                }
                Need::Ignored(reason) => (None, reason),
                Need::Required | Need::Optional => continue,
            };
            let Some((required, what)) = required else {
                match ignored.iter_mut().find(|(own, ..)| *own == reason) {
                    Some((_, names, _)) => names.push(&entry.name),
                    None => ignored.push((reason, vec![&entry.name], entry.place.clone())),
                }
                continue;
            };
            match crate::input::value_of(entry, &parameter(name), &|name: &str| scope.value(name)) {
                Ok(value) if (value - required).abs() > 1e-9 * value.abs().max(required.abs()) => {
                    let value = with_unit(value, name.unit);
                    let message = format!("`{}` is {value}; it must be {what}: {reason}", entry.name);
                    document.problems.push(Problem { place: entry.place.clone(), message });
                }
                Ok(_) => {}
                Err(problem) => document.problems.push(problem),
            }
        }
        for (reason, names, place) in ignored {
            let are = if names.len() == 1 { "is" } else { "are" };
            document.notes.push(format!("{}: {} {are} ignored: {reason}", place.file(), list(&names)));
        }
    }
}

fn known_values(entries: &[Entry], scope: &Scope) -> HashMap<String, f64> {
    entries.iter().filter_map(|entry| Some((scope.key(&entry.name), scope.value(&entry.name)?.ok()?))).collect()
}

/// As the model would have it.
fn parameter(name: &'static Name) -> ParameterInfo {
    ParameterInfo::new(name.name, name.unit, Domain::FINITE).docs(name.docs)
}

/// Parameters of the paper that stand beside those they follow from must be what follows.
fn check_others(others: &[Entry], paper: &[Entry], info: &'static ModelInfo, label: &str, document: &mut Document) {
    let scope = Scope::new(others.iter().chain(paper), HashMap::new(), info);
    let found = Scope::new(paper, HashMap::new(), info);
    for entry in others {
        let Some(at) = position(&entry.name, info) else { continue };
        let name = info.parameters[at].name;
        let (Some(Ok(stated)), Some(Ok(found))) = (scope.value(&entry.name), found.value(name)) else { continue };
        if (stated - found).abs() > 1e-6 * stated.abs().max(found.abs()) {
            let [stated, found] = [stated, found].map(|value| with_unit(value, info.parameters[at].unit));
            let message = format!("`{}` is {stated}, but {found} follows from the others in {label}", entry.name);
            document.problems.push(Problem { place: entry.place.clone(), message });
        }
    }
}

/// What standard deviations become to first order, where there are any.
pub fn spread(
    values: &Values,
    deviations: &[f64],
    formulas: fn(&Values) -> Result<Values, String>,
) -> Vec<(&'static str, f64)> {
    let mut spread: Vec<(&str, f64)> = Vec::new();
    for (position, deviation) in deviations.iter().enumerate().filter(|(_, deviation)| **deviation > 0.0) {
        let Ok(varied) = formulas(&values.varied(position)) else { continue };
        for (name, Dual { slope, .. }) in varied.iter() {
            let part = slope * deviation;
            match spread.iter_mut().find(|(own, _)| *own == name) {
                Some((_, sum)) => *sum = sum.hypot(part),
                None => spread.push((name, part.abs())),
            }
        }
    }
    spread
}
