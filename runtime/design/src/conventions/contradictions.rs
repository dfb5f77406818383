//! Settings that cannot all hold: of what stands in each other's place, and of what others follow from.

use std::collections::HashMap;

use carvallo::ModelInfo;

use super::Convention;
use super::name::{Name, Values};
use crate::failure::Problem;
use crate::input::{Entry, Scope, position, value_of};
use crate::number::with_unit;

/// What is set may be off from what follows by so much, relatively.
const SAME: f64 = 1e-6;

/// What settings in a convention come to.
pub struct Settled<'a> {
    /// The convention.
    pub convention: &'static Convention,
    /// The settings in its names.
    pub settings: &'a [Entry],
    /// What of it was given, with the settings.
    pub given: &'a Values,
    /// The parameters of the paper that follow.
    pub paper: &'a Values,
}

impl Settled<'_> {
    /// The settings, each with its name and value in the convention.
    fn set(&self) -> impl Iterator<Item = (&Entry, &'static Name, f64)> {
        self.settings.iter().filter_map(|entry| {
            let name = self.convention.parameter(&entry.name)?;
            Some((entry, name, self.given.get(name.name)?.value))
        })
    }

    /// What stands under a name with these parameters of the paper.
    fn value(&self, name: &str, paper: &Values) -> Option<f64> {
        self.convention.tell(name, paper, self.given).map(|found| found.value)
    }

    /// Settings of which another one, that stands in the same place, makes something else.
    pub fn in_one_place(&self) -> Vec<Problem> {
        let mut problems = Vec::new();
        for (at, (entry, name, value)) in self.set().enumerate() {
            let is_alternative =
                |(_, other, _): &(&Entry, &Name, f64)| self.convention.are_alternatives(name.name, other.name);
            let Some((other, first, of_first)) = self.set().take(at).find(is_alternative) else { continue };
            let holds =
                |name: &str, value: f64| self.value(name, self.paper).is_some_and(|found| is_same(found, value));
            if holds(name.name, value) && holds(first.name, of_first) {
                continue;
            }
            let message = format!(
                "`{}` stands in the place of `{}`, which is set, too, at {}; both cannot hold",
                entry.name, other.name, other.place
            );
            problems.push(Problem { place: entry.place.clone(), message });
        }
        problems
    }

    /// Settings in the names of the paper that change what is set in the convention.
    pub fn by_paper(&self, settings: &[Entry], info: &'static ModelInfo) -> Vec<Problem> {
        let scope = Scope::new(settings, HashMap::new(), info);
        let mut problems = Vec::new();
        for entry in settings {
            let Some(own) = position(&entry.name, info).map(|at| &info.parameters[at]) else { continue };
            // What is wrong with a value is told where it is judged.
            let Ok(value) = value_of(entry, own, &|name: &str| scope.value(name)) else { continue };
            let mut paper = Values::default();
            let changed = |name: &str, old| if name == own.name { value.into() } else { old };
            self.paper.iter().for_each(|(name, old)| paper.push(name, changed(name, old)));
            problems.extend(self.broken(&paper, entry));
        }
        problems
    }

    /// The first setting that does not hold with other parameters of the paper, which come from another setting.
    pub fn broken(&self, paper: &Values, by: &Entry) -> Option<Problem> {
        let (set, name, new) = self.set().find_map(|(set, name, _)| {
            let [old, new] = [self.paper, paper].map(|paper| self.value(name.name, paper));
            let new = old.zip(new).filter(|(old, new)| !is_same(*old, *new))?.1;
            Some((set, name, new))
        })?;
        let new = with_unit(new, name.unit);
        let message = format!(
            "`{}` and `{}`, at {}, cannot both hold: `{}` would be {new}",
            by.name, set.name, set.place, set.name
        );
        Some(Problem { place: by.place.clone(), message })
    }
}

fn is_same(one: f64, other: f64) -> bool {
    (one - other).abs() <= SAME * one.abs().max(other.abs())
}
