//! A file in the names of the paper that says something a second time, in other names: both must say the same.

use std::collections::HashMap;

use carvallo::{ModelInfo, ParameterInfo};

use super::Convention;
use super::geometry::GEOMETRY;
use super::name::{Name, Values};
use super::read::list;
use super::recognise::only;
use super::source::parameter;
use super::twice::{Agreement, Told, is_alias, spelled};
use crate::design::Given;
use crate::failure::Problem;
use crate::input::{Document, Entry, Scope, position, validate};

/// Takes out what only repeats the parameters of the paper, with a note, and tells what contradicts them beyond its digits and
/// theirs; and what others call so. All else stays, and so does everything where parameters are missing.
pub fn hold(document: &mut Document, label: &str, info: &'static ModelInfo) {
    let scope = Scope::new(&document.entries, HashMap::new(), info);
    let own = own(&document.entries, &scope, info);
    let is_given = |at: usize| own.iter().any(|(name, _)| *name == info.parameters[at].name);
    if !(0..info.parameters.len()).all(|at| is_given(at) || !info.parameters[at].used || info.gravity == Some(at)) {
        return;
    }
    let mut file = File { label, info, scope: &scope, own, same: Vec::new(), notes: Vec::new(), problems: Vec::new() };
    let mut left = Vec::new();
    for entry in &document.entries {
        if !file.tells(entry, &document.entries) {
            left.push(entry.clone());
        }
    }
    let File { same, notes, problems, .. } = file;
    if !same.is_empty() {
        let says = if same.len() == 1 { "says" } else { "say" };
        document.notes.push(format!("{label}: {} {says} what the parameters of {} say, too", list(&same), info.name));
    }
    document.entries = left;
    document.notes.extend(notes);
    document.problems.extend(problems);
}

/// The parameters of the paper that have a value, and what manufacturers print.
fn own(entries: &[Entry], scope: &Scope, info: &'static ModelInfo) -> Vec<(&'static str, Given)> {
    let given = |entry: &Entry| {
        let at = position(&entry.name, info);
        let own = at.map(|at| info.parameters[at]).or_else(|| GEOMETRY.parameter(&entry.name).map(parameter))?;
        // What others refer to is found by reading them, so that what is printed comes behind.
        Some((own.name, validate(entry, &own, &|name: &str| scope.value(name)).ok()?))
    };
    let (paper, printed): (Vec<&Entry>, Vec<&Entry>) =
        entries.iter().partition(|entry| position(&entry.name, info).is_some());
    paper.into_iter().chain(printed).filter_map(given).collect()
}

/// A file in the names of the paper that has all of them.
struct File<'a> {
    label: &'a str,
    info: &'static ModelInfo,
    scope: &'a Scope<'a>,
    /// What it has of them, and of what manufacturers print, some of which tells something only together.
    own: Vec<(&'static str, Given)>,
    /// What only repeats others.
    same: Vec<&'a str>,
    notes: Vec<String>,
    problems: Vec<Problem>,
}

impl<'a> File<'a> {
    /// Whether an entry says something a second time, which is told.
    fn tells(&mut self, entry: &'a Entry, entries: &'a [Entry]) -> bool {
        if let Some(at) = position(&entry.name, self.info) {
            let parameter = &self.info.parameters[at];
            let of_it = || entries.iter().filter(|other| position(&other.name, self.info) == Some(at));
            let first = of_it().find(|other| spelled(&other.name) == parameter.name).or_else(|| of_it().next());
            // Underscores alone make no other name.
            let first = first.filter(|first| spelled(&first.name) != spelled(&entry.name));
            return first
                .is_some_and(|first| is_alias(&first.name, &entry.name) && self.repeats(entry, first, parameter));
        }
        // What the parameters refer to says nothing a second time.
        if self.scope.is_used(entry) {
            return false;
        }
        let mut problems = Vec::new();
        let Some((convention, own, name)) = meaning(entry, &mut problems) else { return false };
        if !problems.is_empty() {
            self.problems.append(&mut problems);
            return true;
        }
        let is_printed = *convention == GEOMETRY;
        let given = match validate(&own, &parameter(name), &|name: &str| self.scope.value(name)) {
            Ok(given) => given,
            Err(found) => {
                // Others may well have something else by such a name.
                self.problems.extend(found.into_iter().filter(|_| is_printed));
                return is_printed;
            }
        };
        if let Some(option) = GEOMETRY.together(name.name).filter(|_| is_printed) {
            self.tells_together(entry, option, name);
            return true;
        }
        let tell = |name: &str, values: &Values| convention.tell(name, values, values);
        let sides = ["rear", "front"].map(|side| format!("{side}_{}", name.name));
        // The size of both wheels is told by those of both.
        let names = [name.name, &sides[0], &sides[1]];
        let told = names.iter().filter_map(|name| Told::new(&self.own, &|values| tell(name, values)));
        let told: Vec<Told> = told.collect();
        let other = told.iter().find(|told| told.agreement(&given, Some(name)) == Agreement::Other);
        match other.or(told.first()) {
            None => return false,
            Some(told) if is_printed => {
                self.judge((&entry.name, entry), &given, told, (name.unit, Some(name)), &[&entry.name])
            }
            Some(told) if told.agreement(&given, Some(name)) == Agreement::Same => self.same.push(&entry.name),
            Some(told) => {
                let differs = told.differs(&entry.name, &given, name.unit);
                let is_of = format!("it is a name of {} ({}), and not used", convention.name, convention.title);
                self.notes.push(format!("{}: {differs}; {is_of}", self.label));
            }
        }
        true
    }

    /// The same of another name of a parameter of the paper.
    fn repeats(&mut self, entry: &'a Entry, first: &'a Entry, parameter: &'static ParameterInfo) -> bool {
        let value = |entry: &Entry| validate(entry, parameter, &|name: &str| self.scope.value(name));
        let (Ok(value), Ok(given)) = (value(first), value(entry)) else { return false };
        let told = Told::by_name(&first.name, &value);
        self.judge((&entry.name, entry), &given, &told, (parameter.unit, None), &[]);
        true
    }

    /// What several entries tell only together, such as a wheel base, which is told at the first of them.
    fn tells_together(&mut self, entry: &'a Entry, option: &'static [&'static str], name: &Name) {
        let missing: Vec<&str> = option.iter().copied().filter(|name| self.own(name).is_none()).collect();
        let Some(first) = GEOMETRY.in_place_of(name.name).and_then(|first| GEOMETRY.parameter(first)) else { return };
        if !missing.is_empty() {
            let (called, missing) = (&entry.name, list(&missing));
            let only = format!("`{called}` tells nothing: `{}` follows only with {missing}", first.name);
            self.notes.push(format!("{}: {only}", self.label));
        } else if option.first() == Some(&name.name) {
            let own = first.others.iter().find_map(|name| Some((*name, self.own(name)?.clone())));
            let told = Told::new(&self.own, &|values| {
                let mut others = Values::default();
                values.iter().filter(|(own, _)| *own != first.name).for_each(|(own, value)| others.push(own, value));
                GEOMETRY.tell(first.name, &(GEOMETRY.to_paper)(&others).ok()?, &others)
            });
            if let (Some((called, given)), Some(told)) = (own, told) {
                self.judge((called, entry), &given, &told, (first.unit, Some(first)), option);
            }
        }
    }

    /// A value by its name.
    fn own(&self, name: &str) -> Option<&Given> {
        self.own.iter().find(|(own, _)| *own == name).map(|(_, given)| given)
    }

    /// Whether a value that is called so is the one that follows, at an entry.
    fn judge(
        &mut self,
        (called, entry): (&str, &'a Entry),
        given: &Given,
        told: &Told,
        (unit, name): (&str, Option<&Name>),
        unused: &[&str],
    ) {
        match told.agreement(given, name) {
            Agreement::Same => self.same.push(&entry.name),
            Agreement::Near => self.notes.push(format!("{}: {}", self.label, told.is_near(called, given, unused))),
            Agreement::Other => {
                let message = told.contradicts(called, given, unit);
                self.problems.push(Problem { place: entry.place.clone(), message });
            }
        }
    }
}

/// What an entry is in the convention that its name is of: what manufacturers print, or else the only one that has it.
pub fn meaning(entry: &Entry, problems: &mut Vec<Problem>) -> Option<(&'static Convention, Entry, &'static Name)> {
    let mut of = |convention: &'static Convention| {
        let (mut own, mut found) = (vec![entry.clone()], Vec::new());
        (convention.prepare)(&mut own, &mut found);
        let own = own.pop()?;
        let name = convention.parameter(&own.name)?;
        problems.append(&mut found);
        Some((convention, own, name))
    };
    of(&GEOMETRY).or_else(|| of(only(std::slice::from_ref(entry))?))
}
