//! What a file in some convention has: its values, judged all at once, and what follows from them.

use std::collections::HashMap;

use carvallo::{Covariance, ModelInfo, ParameterInfo};

use super::Convention;
use super::carried::{Carried, deviations};
use super::dual::Dual;
use super::gyrostats::SPLIT;
use super::name::{Name, Need, Values};
use super::read::list;
use super::twice::is_alias;
use crate::design::Given;
use crate::failure::{Place, Problem};
use crate::input::{Document, Entry, Names, Scope, Value, Written, given_twice, resolve_correlations, validate};
use crate::nearest::nearest;
use crate::number::{shortest, with_unit};

/// The parameters of the paper that follow from those of a convention.
pub struct Paper {
    /// As if a file had them.
    pub entries: Vec<Entry>,
    /// What it follows from.
    pub given: Values,
    /// The same as it was written.
    pub written: Vec<(&'static str, Given)>,
    /// Those that are not told, and that no motion depends on.
    pub assumed: Vec<&'static str>,
    /// How the parameters of the model vary together, in its order, if any do.
    pub covariance: Option<Covariance>,
}

/// What is given a second time, by another name.
pub struct Alias<'a> {
    pub entry: &'a Entry,
    /// What both names are of.
    pub name: &'static Name,
    /// How it is called the first time, and its value there.
    pub first: &'a str,
    pub value: Given,
}

/// What a file in a convention has.
pub struct Source<'a> {
    /// Which one.
    pub convention: &'static Convention,
    /// The path of the file as it was given.
    pub label: &'a str,
    /// The entries that belong to the convention.
    pub own: &'a [Entry],
    /// Those that do not.
    pub others: &'a [Entry],
    /// Those of the command line that replace some of them.
    pub settings: &'a [Entry],
    /// What values may refer to.
    pub scope: &'a Scope<'a>,
}

impl Source<'_> {
    /// The parameters of the paper; nothing if something is wrong, which is told.
    pub fn translate(&self, info: &ModelInfo, document: &mut Document) -> Option<Paper> {
        let Self { convention, label, .. } = *self;
        let (given, aliases) = self.values(document);
        let given = self.once(given, document);
        aliases.iter().for_each(|alias| self.judge_alias(alias, &given, document));
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
            self.check_names(&is_given, info, document);
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
        let covariance = self.covariance(&given, document)?;
        let carried = Carried::new(&values, &covariance, convention.to_paper);
        let entry = |(name, value): (&'static str, Dual)| {
            let deviation = carried.deviation(name);
            let mut entry = Entry::from_text(name, file(), &shortest(value.value));
            entry.deviation = (deviation > 0.0).then(|| Written::Text(shortest(deviation)));
            entry
        };
        let assumed = SPLIT.into_iter().filter(|name| convention.is_of_gyrostats() && !is_given(name)).collect();
        Some(Paper {
            given: values,
            written: given.into_iter().map(|(name, given)| (name.name, given)).collect(),
            entries: paper.iter().filter(|(name, _)| info.position(name).is_some()).map(entry).collect(),
            assumed,
            covariance: carried.covariance(info.parameters.iter().map(|parameter| parameter.name)),
        })
    }

    /// Names that nobody has, and that are probably some which are missing.
    fn check_names(&self, is_given: &dyn Fn(&str) -> bool, info: &ModelInfo, document: &mut Document) {
        let needed = self.convention.needed();
        let missing = || needed.iter().filter(|group| !group.iter().any(|name| is_given(name))).flatten().copied();
        let is_used = |entry: &&Entry| info.position(&entry.name).is_some() || self.scope.is_used(entry);
        for entry in self.others.iter().filter(|entry| !is_used(entry)) {
            if let Some(meant) = nearest(&entry.name, missing()) {
                let (name, title) = (&entry.name, self.convention.title);
                document
                    .problem(entry.place.clone(), format!("`{name}` is not known in {title}; did you mean `{meant}`?"));
            }
        }
    }

    /// How the parameters of the file vary together.
    fn covariance(&self, given: &[(&'static Name, Given)], document: &mut Document) -> Option<Covariance> {
        let find = |name: &str| {
            let known = self.convention.parameter(name);
            let position = known.and_then(|known| given.iter().position(|(own, _)| std::ptr::eq(*own, known)));
            position.ok_or_else(|| format!("`{name}` is none of the parameters of the file"))
        };
        let names = Names { find: &find, name: &|position| given[position].0.name };
        let values: Vec<&Given> = given.iter().map(|(_, given)| given).collect();
        let is_set = |position: usize| {
            let name = given[position].0;
            self.settings
                .iter()
                .any(|entry| self.convention.parameter(&entry.name).is_some_and(|own| std::ptr::eq(own, name)))
        };
        let mut members = std::mem::take(&mut document.correlations);
        // What gives way to a setting, or says something a second time, is correlated with nothing any more.
        let set = || self.settings.iter().filter_map(|entry| self.convention.parameter(&entry.name));
        let stays = |name: &str| {
            self.convention.parameter(name).is_none_or(|own| {
                let mut others = set().chain(given.iter().map(|(name, _)| *name));
                given.iter().any(|(name, _)| std::ptr::eq(*name, own))
                    || !others.any(|other| self.convention.are_alternatives(own.name, other.name))
            })
        };
        members.retain(|member| stays(&member.name));
        for member in &mut members {
            if let Value::Table(others) = &mut member.node.value {
                others.retain(|other| stays(&other.name));
            }
        }
        match resolve_correlations(members, &names, &values, &is_set) {
            Ok(Some(covariance)) => Some(covariance),
            Ok(None) => Covariance::independent(&deviations(values)).ok(),
            Err(problems) => {
                document.problems.extend(problems);
                None
            }
        }
    }

    /// The values of its parameters, of which settings replace some; and what stands beside these by another of their names.
    fn values(&self, document: &mut Document) -> (Vec<(&'static Name, Given)>, Vec<Alias<'_>>) {
        let mut aliases = Vec::new();
        let Self { convention, own, settings, scope, .. } = *self;
        let setting_scope = Scope::new(settings, known_values(own, scope), crate::model::WHIPPLE.info);
        let mut given: Vec<(&Name, Given)> = Vec::new();
        let sources = [(settings, &setting_scope), (own, scope)];
        for (from, (entries, scope)) in sources.into_iter().enumerate() {
            let mut seen: Vec<(&Name, &Entry)> = Vec::new();
            for entry in entries {
                let Some(name) = convention.parameter(&entry.name) else { continue };
                if let Some((_, first)) = seen.iter().find(|(own, _)| std::ptr::eq(*own, name)) {
                    let value = given.iter().find(|(own, _)| std::ptr::eq(*own, name)).map(|(_, value)| value);
                    match value.filter(|_| from == 1 && is_alias(first.called(), entry.called())) {
                        Some(value) => {
                            aliases.push(Alias { entry, name, first: first.called(), value: value.clone() });
                        }
                        None => {
                            let message = given_twice(entry.called(), first.called(), &first.place);
                            document.problems.push(Problem { place: entry.place.clone(), message });
                        }
                    }
                    continue;
                }
                seen.push((name, entry));
                if from == 1 && given.iter().any(|(own, _)| std::ptr::eq(*own, name)) {
                    continue;
                }
                match validate(entry, &parameter(name), &|name: &str| scope.value(name)) {
                    Ok(value) => given.push((name, value)),
                    Err(problems) => document.problems.extend(problems),
                }
            }
        }
        (given, aliases)
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
pub fn parameter(name: &'static Name) -> ParameterInfo {
    ParameterInfo::new(name.name, name.unit, name.domain).docs(name.docs)
}
