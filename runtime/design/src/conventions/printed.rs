//! What manufacturers print, in a file of another convention: it must be what follows.

use super::beside::meaning;
use super::geometry::GEOMETRY;
use super::name::Values;
use super::source::{Source, parameter};
use super::twice::{Agreement, Told};
use crate::design::Given;
use crate::input::{Document, Entry, validate};

impl Source<'_> {
    /// Whether an entry is what manufacturers print, and what is given of the convention tells it, too: then it is judged.
    pub fn tells_printed(&self, entry: &Entry, given: &[(&'static str, Given)], document: &mut Document) -> bool {
        let mut problems = Vec::new();
        let Some((convention, own, name)) = meaning(entry, &mut problems) else { return false };
        if *convention != GEOMETRY || GEOMETRY.together(name.name).is_some() {
            return false;
        }
        let tell = |name: &str| {
            self.follows(given, &|values: &Values| {
                GEOMETRY.tell(name, &(self.convention.to_paper)(values).ok()?, &Values::default())
            })
        };
        // The size of both wheels is told by those of both.
        let sides = ["rear", "front"].map(|side| format!("{side}_{}", name.name));
        let told: Vec<Told> = [name.name, &sides[0], &sides[1]].into_iter().filter_map(tell).collect();
        if told.is_empty() {
            return false;
        }
        match validate(&own, &parameter(name), &|name: &str| self.scope.value(name)) {
            Ok(value) if problems.is_empty() => {
                let is_other = |told: &&Told| told.agreement(&value, Some(name)) == Agreement::Other;
                let found = told.iter().find(is_other).unwrap_or(&told[0]);
                self.tell((entry, name.unit, Some(name)), &value, found, &[entry.called()], document);
            }
            Ok(_) => document.problems.extend(problems),
            Err(found) => document.problems.extend(found),
        }
        true
    }
}
