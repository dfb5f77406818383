//! A file in some convention that says something in two ways, of which one is used: both must say the same.

use super::dual::Dual;
use super::geometry::GEOMETRY;
use super::name::{Name, Values};
use super::read::list;
use super::source::{Alias, Source, parameter};
use super::twice::{Agreement, Told};
use super::{Alternatives, Convention};
use crate::design::Given;
use crate::failure::Problem;
use crate::input::{Document, Entry, validate};

/// Values with what they are of.
type Named = Vec<(&'static Name, Given)>;

/// Names that say something together, or one that does alone.
type Way = &'static [&'static str];

impl Source<'_> {
    /// Without what says something a second time, which is told. What is set is judged elsewhere.
    pub fn once(&self, mut given: Named, document: &mut Document) -> Named {
        // Of what is missing, or is wrong itself, nothing would follow.
        let has = |group: &Alternatives| {
            group.iter().any(|option| option.iter().all(|name| given.iter().any(|(own, _)| own.name == *name)))
        };
        let is_whole = self.convention.alternatives.iter().all(has);
        for group in self.convention.alternatives {
            let is_given = |name: &&str| given.iter().any(|(own, _)| own.name == *name);
            let whole: Vec<Way> = group.iter().copied().filter(|option| option.iter().all(is_given)).collect();
            group.iter().for_each(|option| self.tell_missing(option, &given, document));
            let Some((first, others)) = whole.split_first().filter(|_| is_whole) else { continue };
            for other in others {
                match [first, other].map(|option| self.is_shared(option)) {
                    // What is of both wheels gives way to what is of one.
                    [false, true] => self.judge_shared(group, [first, other], &given, document),
                    [true, false] => self.judge_shared(group, [other, first], &given, document),
                    _ => self.judge([first, other], &mut given, document),
                }
            }
        }
        given
    }

    /// That a name tells nothing without others, which are missing; where one alone is, it follows.
    fn tell_missing(&self, option: Way, given: &Named, document: &mut Document) {
        let is_given = |name: &&str| given.iter().any(|(own, _)| own.name == *name);
        let (own, missing): (Vec<&str>, Vec<&str>) = option.iter().partition(|name| is_given(name));
        let ([name], [_, _, ..]) = (&own[..], &missing[..]) else { return };
        let is_set = entry(self.convention, self.settings, name).is_some();
        if let Some(first) = self.convention.in_place_of(name).filter(|_| !is_set) {
            let only = format!("`{name}` tells nothing: `{first}` follows only with {}", list(&missing));
            document.notes.push(format!("{}: {only}", self.label));
        }
    }

    /// Whether names stand in the place of several others.
    fn is_shared(&self, option: Way) -> bool {
        self.convention.alternatives.iter().filter(|group| group.contains(&option)).count() > 1
    }

    /// Judges whether two ways of saying something agree, and leaves out the second if it is a name alone.
    fn judge(&self, options: [Way; 2], given: &mut Named, document: &mut Document) {
        let [first, other] = options;
        let is_set = |name: &&str| entry(self.convention, self.settings, name).is_some();
        if first.iter().chain(other).any(is_set) {
            return;
        }
        let alone =
            [other, first].into_iter().filter_map(|option| if let [name] = option { Some(*name) } else { None });
        let Some((told, found)) = alone.filter_map(|name| Some((name, self.told(name, given)?))).next() else { return };
        let Some((name, value)) = given.iter().find(|(own, _)| own.name == told) else { return };
        let Some(entry) = entry(self.convention, self.own, told) else { return };
        let unused: Vec<&str> = match other {
            [name] if *name == told => vec![entry.called()],
            _ => other.to_vec(),
        };
        self.tell((entry, name.unit, Some(name)), value, &found, &unused, document);
        if let [name] = other {
            given.retain(|(own, _)| own.name != *name);
        }
    }

    /// Judges whether what is of one wheel, and counts for it, is what is of both.
    fn judge_shared(&self, group: &Alternatives, options: [Way; 2], given: &Named, document: &mut Document) {
        let [&[own], &[both]] = options else { return };
        if options.iter().any(|option| entry(self.convention, self.settings, option[0]).is_some()) {
            return;
        }
        // `rear_wheel_diameter` is to one what `wheel_diameter` is to both.
        let mut names = group.iter().flat_map(|option| option.iter());
        let name = names.find(|name| **name != both && name.ends_with(both));
        let Some(name) = name.and_then(|name| self.convention.parameter(name)) else { return };
        let Some((_, value)) = given.iter().find(|(name, _)| name.name == both) else { return };
        let Some(entry) = entry(self.convention, self.own, both) else { return };
        let others = given.iter().filter(|(name, _)| !self.convention.are_alternatives(name.name, own));
        let others: Vec<(&'static str, Given)> = others.map(|(name, given)| (name.name, given.clone())).collect();
        let follows =
            |values: &Values| self.convention.tell(name.name, &(self.convention.to_paper)(values).ok()?, values);
        let Some(found) = self.follows(&others, &follows) else { return };
        let name = name.printed("mm");
        if found.agreement(value, Some(&name)) == Agreement::Near {
            let off = found.is_off(entry.called(), value);
            document.notes.push(format!("{}: {off}; it does not count for that wheel", self.label));
        } else {
            self.tell((entry, name.unit, Some(&name)), value, &found, &[], document);
        }
    }

    /// Judges whether another name of something says what is used: that which is given, or, where that is not used, what follows.
    pub fn judge_alias(&self, alias: &Alias, used: &Named, document: &mut Document) {
        let Alias { entry, name, first, value } = alias;
        match validate(entry, &parameter(name), &|name: &str| self.scope.value(name)) {
            Ok(given) => {
                let is_used = used.iter().any(|(own, _)| std::ptr::eq(*own, *name));
                let followed = if is_used { None } else { self.told(name.name, used) };
                let told = followed.unwrap_or_else(|| Told::by_name(first, value));
                // `fork_offset` beside PyDy's `forkoffset` is what manufacturers print.
                let name = GEOMETRY.parameter(entry.called()).unwrap_or(name);
                self.tell((entry, name.unit, Some(name)), &given, &told, &[entry.called()], document);
            }
            Err(problems) => document.problems.extend(problems),
        }
    }

    /// Tells whether a value is the one that follows, in a unit and by a name, if it has one of a convention.
    pub fn tell(
        &self,
        (entry, unit, name): (&Entry, &str, Option<&Name>),
        value: &Given,
        found: &Told,
        unused: &[&str],
        document: &mut Document,
    ) {
        match found.agreement(value, name) {
            Agreement::Same => document.notes.push(format!("{}: {}", self.label, found.is_same(entry.called()))),
            Agreement::Near => {
                let near = found.is_near(entry.called(), value, unused);
                document.notes.push(format!("{}: {near}", self.label));
            }
            Agreement::Other => {
                let message = found.contradicts(entry.called(), value, unit);
                document.problems.push(Problem { place: entry.place.clone(), message });
            }
        }
    }

    /// What follows of a name from all else that is given.
    fn told(&self, name: &str, given: &Named) -> Option<Told> {
        let others = given.iter().filter(|(own, _)| own.name != name);
        let others: Vec<(&'static str, Given)> = others.map(|(name, given)| (name.name, given.clone())).collect();
        self.follows(&others, &|values: &Values| {
            self.convention.tell(name, &(self.convention.to_paper)(values).ok()?, values)
        })
    }

    /// What follows from values of the convention, which are called as they are written.
    pub fn follows(&self, given: &[(&'static str, Given)], formula: &dyn Fn(&Values) -> Option<Dual>) -> Option<Told> {
        let written = |name: &str| {
            let of = |entries| entry(self.convention, entries, name);
            of(self.settings).or_else(|| of(self.own)).map(|entry| entry.called().to_owned())
        };
        Told::new(given, formula).map(|told| told.called(&written))
    }
}

/// Where a name is given.
fn entry<'a>(convention: &Convention, entries: &'a [Entry], name: &str) -> Option<&'a Entry> {
    entries.iter().find(|entry| convention.parameter(&entry.name).is_some_and(|own| own.name == name))
}
