//! From a file in some convention to the parameters of the paper.

use std::collections::HashMap;

use carvallo::{Covariance, ModelInfo, ParameterInfo};

use super::contradictions::Settled;
use super::dual::Dual;
use super::express::express;
use super::held::Ranks;
use super::name::Values;
use super::recognise::{only, recognise};
use super::source::{Paper, Source, parameter};
use super::{Convention, PAPER};
use crate::design::Given;
use crate::failure::{Place, Problem};
use crate::input::{Document, Entry, Named, Node, Scope, Value, position, validate, value_of};
use crate::number::shortest;

/// How a file was read that is not in the names of the paper.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The convention that it is in.
    pub convention: &'static Convention,
    /// The parameters of the paper that it does not tell, and that no motion depends on.
    pub assumed: Vec<&'static str>,
    /// What of it was given, by the file or by settings.
    pub(crate) given: Values,
    /// The names of these that are not written as the convention has them.
    called: Vec<(&'static str, String)>,
    /// How the parameters of the model vary together, in its order, if any do.
    pub(crate) covariance: Option<Covariance>,
}

impl Reading {
    /// What was given: as it was called there, what it is and its value.
    pub(crate) fn given(&self) -> impl Iterator<Item = (&str, ParameterInfo, f64)> {
        self.given.iter().filter_map(|(name, value)| {
            let called = self.called.iter().find(|(own, _)| *own == name).map_or(name, |(_, called)| called);
            Some((called, parameter(self.convention.parameter(name)?), value.value))
        })
    }

    /// Whether a parameter of the paper changes where something that was given does.
    pub(crate) fn moves(&self, given: &str, paper: &str) -> bool {
        let at = self.given.iter().position(|(name, _)| name == given);
        let found = at.and_then(|at| (self.convention.to_paper)(&self.given.varied(at)).ok());
        found.and_then(|found| found.get(paper)).is_some_and(|value| value.slope != 0.0)
    }
}

/// Puts the parameters of the paper in the place of those of the convention that a file is in, if it is in another. Settings
/// that are in the same convention take part in it; the others are left, or change what follows if they are in a third one.
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
        None => recognise(&document.entries, info).unwrap_or(PAPER),
    };
    let is_paper = convention.is_paper();
    if is_paper {
        super::beside::hold(document, label, info);
    }
    let convention = if is_paper { express(document, label, info, settings)? } else { convention };
    (convention.prepare)(&mut document.entries, &mut document.problems);
    (convention.prepare)(settings, &mut document.problems);
    let (mut own, others): (Vec<Entry>, Vec<Entry>) =
        std::mem::take(&mut document.entries).into_iter().partition(|entry| convention.known(&entry.name).is_some());
    let (mine, left): (Vec<Entry>, Vec<Entry>) =
        std::mem::take(settings).into_iter().partition(|entry| convention.known(&entry.name).is_some());
    *settings = left;
    document.notes.extend(settle(convention, &mut own, &mine, label));
    let problems = document.problems.len();
    let called = mine.iter().chain(&own).filter_map(|entry| Some((convention.parameter(&entry.name)?.name, entry)));
    let called = called.filter(|(name, entry)| *name != entry.called());
    let called = called.map(|(name, entry)| (name, entry.called().to_owned()));
    let called = called.collect();
    let scope = Scope::new(own.iter().chain(&others), HashMap::new(), crate::model::WHIPPLE.info);
    let source = Source { convention, label, own: &own, others: &others, settings: &mine, scope: &scope };
    let result = source.translate(info, document);
    let Some(Paper { entries: paper, given, written, assumed, covariance }) =
        result.filter(|_| document.problems.len() == problems)
    else {
        // What is wrong is told; nothing is said of what would be missing.
        document.entries = Vec::new();
        return None;
    };
    let found = (convention.to_paper)(&given).unwrap_or_default();
    let settled = Settled { convention, settings: &mine, given: &given, paper: &found };
    document.problems.extend(settled.in_one_place());
    document.problems.extend(settled.by_paper(settings, info));
    let title = convention.title;
    document.notes.push(match is_paper {
        true => format!("{label}: changed in {title}: what is not set of them stays, and those of the paper follow"),
        false => format!("{label}: in {title}; the parameters of the paper are computed from them"),
    });
    if !assumed.is_empty() {
        document.notes.push(format!(
            "{label}: {} are not told by two gyrostats; wheels without mass are taken, with which all motions are the same",
            list(&assumed)
        ));
    }
    let told = check_others(&others, &source, &written, info, document);
    // What the model has beside the parameters of the paper stays; what others are computed from is used, and is no parameter.
    let is_left = |entry: &Entry| match position(&entry.name, info) {
        Some(at) => crate::model::WHIPPLE.info.position(info.parameters[at].name).is_none(),
        None => !scope.is_used(entry),
    };
    let left = others.iter().zip(told).filter(|(entry, is_told)| !is_told && is_left(entry));
    let left: Vec<Entry> = left.map(|(entry, _)| entry.clone()).collect();
    document.entries = paper.into_iter().chain(left).collect();
    if !is_paper && in_another(settings, info) {
        document.parameterization = Some((Place::Nowhere, PAPER.name.to_owned()));
        document.correlations = pairs(covariance.as_ref(), info);
        let others: Vec<Entry> = settings.clone();
        let reading = read(document, label, info, settings)?;
        let scope = Scope::new(&document.entries, HashMap::new(), info);
        let mut changed = Values::default();
        for (name, old) in found.iter() {
            changed.push(name, scope.value(name).and_then(Result::ok).map_or(old, Dual::from));
        }
        let settled = Settled { convention, settings: &mine, given: &given, paper: &found };
        let broken = others.iter().find(|entry| position(&entry.name, info).is_none());
        let broken = broken.and_then(|by| settled.broken(&changed, by));
        document.problems.extend(broken);
        return Some(Reading { assumed, ..reading });
    }
    Some(Reading { convention, assumed, given, called, covariance })
}

/// Whether settings that are not in the names of the paper are all in those of another convention.
fn in_another(settings: &[Entry], info: &ModelInfo) -> bool {
    let is_foreign = |entry: &&Entry| position(&entry.name, info).is_none();
    only(&settings.iter().filter(is_foreign).cloned().collect::<Vec<_>>()).is_some()
}

/// How parameters of the model vary together, as a file says it.
fn pairs(covariance: Option<&Covariance>, info: &ModelInfo) -> Vec<Named> {
    let name = |position: usize| info.parameters[position].name;
    let named = |name: &str, value| Named { name: name.to_owned(), node: Node { place: Place::Nowhere, value } };
    let pairs = covariance.map(Covariance::correlations).unwrap_or_default();
    let pair = |&(a, b, value): &(usize, usize, f64)| {
        named(name(a), Value::Table(vec![named(name(b), Value::Number(shortest(value)))]))
    };
    pairs.iter().map(pair).collect()
}

/// Leaves out what settings stand in the place of. What they need beside them, and follows from the rest, comes in; what is said
/// of settings that need something which is not known.
fn settle(convention: &'static Convention, own: &mut Vec<Entry>, settings: &[Entry], label: &str) -> Option<String> {
    let names = |entries: &[Entry]| -> Vec<&'static str> {
        entries.iter().filter_map(|entry| Some(convention.parameter(&entry.name)?.name)).collect()
    };
    let (mut set, given) = (names(settings), names(own));
    set.retain(|name| convention.has_alternatives(name));
    if set.is_empty() {
        return None;
    }
    let held = convention.held(Ranks { varied: &[], set: &set, given: &given });
    let is_new = |name: &&'static str| !given.contains(name) && !set.contains(name);
    let others = held.iter().any(&is_new).then(|| completed(convention, own)).flatten().unwrap_or_default();
    let missing: Vec<&str> = held.iter().copied().filter(|name| is_new(name) && others.get(name).is_none()).collect();
    let needs_missing = |name: &str| missing.iter().any(|missing| convention.needs(name, missing));
    // These change nothing, unless what they need varies.
    let (idle, set): (Vec<&str>, Vec<&str>) = set.iter().partition(|name| needs_missing(name));
    let gives_way = |name: &str| set.iter().any(|set| convention.are_alternatives(name, set));
    own.retain(|entry| {
        let name = convention.parameter(&entry.name).map(|own| own.name);
        name.is_none_or(|name| held.contains(&name) || !gives_way(name))
    });
    for name in held.iter().filter(|name| !given.contains(name) && !set.contains(name)) {
        if let Some(value) = others.get(name) {
            own.push(Entry::from_text(name, Place::File(label.to_owned()), &shortest(value.value)));
        }
    }
    let first = idle.first().and_then(|name| convention.in_place_of(name))?;
    let (are, them) = if idle.len() == 1 { ("is", "it") } else { ("are", "them") };
    let (idle, missing) = (list(&idle), list(&missing));
    Some(format!("{label}: {idle} {are} set, and `{first}` follows from {them} only with {missing}"))
}

/// What else can be told from entries; nothing where one of them is wrong, which is told elsewhere.
fn completed(convention: &Convention, own: &[Entry]) -> Option<Values> {
    let scope = Scope::new(own, HashMap::new(), crate::model::WHIPPLE.info);
    let mut values = Values::default();
    for entry in own {
        let Some(name) = convention.parameter(&entry.name) else { continue };
        values.push(name.name, value_of(entry, &parameter(name), &|name: &str| scope.value(name)).ok()?.into());
    }
    Some((convention.complete)(&(convention.to_paper)(&values).ok()?, &values))
}

/// Whether a model has the parameters of the paper.
pub fn has_paper(info: &ModelInfo) -> bool {
    crate::model::WHIPPLE.info.parameters.iter().all(|parameter| info.position(parameter.name).is_some())
}

/// Names, as messages have them.
pub fn list(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// Parameters of the paper that stand beside those they follow from must be what follows, and so must what manufacturers print;
/// whether each is told of.
fn check_others(
    others: &[Entry],
    source: &Source,
    written: &[(&'static str, Given)],
    info: &'static ModelInfo,
    document: &mut Document,
) -> Vec<bool> {
    let others = others.iter().map(|entry| match position(&entry.name, info).map(|at| &info.parameters[at]) {
        Some(parameter) => {
            let follows = |values: &Values| (source.convention.to_paper)(values).ok()?.get(parameter.name);
            let Some(told) = source.follows(written, &follows) else { return false };
            match validate(entry, parameter, &|name: &str| source.scope.value(name)) {
                Ok(given) => source.tell((entry, parameter.unit, None), &given, &told, &[entry.called()], document),
                Err(problems) => document.problems.extend(problems),
            }
            true
        }
        None => !source.scope.is_used(entry) && source.tells_printed(entry, written, document),
    });
    others.collect()
}
