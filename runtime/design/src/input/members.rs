//! A value with its members: `{ value = 102, std = 1, unit = "cm" }`, in TOML and JSON.

use super::document::{Document, Entry, Written};
use crate::failure::Place;
use crate::nearest::nearest;
use crate::quantity::{has_deviation, is_unit_alone};

const MEMBERS: [&str; 3] = ["value", "std", "unit"];

impl Document {
    /// A parameter by its members; `without` says what it is that has no value: `a table without `value``.
    pub fn entry_of_members(
        &mut self,
        name: String,
        place: Place,
        members: impl IntoIterator<Item = (String, Written)>,
        without: &'static str,
    ) -> Entry {
        let mut known = [const { None }; MEMBERS.len()];
        let mut problems = Vec::new();
        for (member, written) in members {
            match MEMBERS.iter().position(|known| *known == member) {
                Some(at) if known[at].is_some() => problems.push(format!("`{member}` of `{name}` is given twice")),
                Some(at) => known[at] = Some(written),
                // Among the results of a sensitivity, which are read as parameters.
                None if member == "one_percent" => {}
                None => problems.push(unknown(&member, &name)),
            }
        }
        let [value, deviation, unit] = known;
        let (value, deviation) = match (value, unit) {
            (None, _) => (Written::Other(without), None),
            (Some(value), None) => (value, deviation),
            (Some(value), Some(Written::Text(unit))) if is_unit_alone(unit.trim()) => {
                (value.in_unit(&unit), deviation.map(|deviation| deviation.in_unit(&unit)))
            }
            (Some(value), Some(unit)) => {
                let found = match unit {
                    Written::Text(text) => format!("`{text}`"),
                    Written::Other(found) => found.to_owned(),
                };
                problems.push(format!("the unit of `{name}` is {found}; expected a unit such as `m` or `kg*m^2`"));
                (value, deviation)
            }
        };
        // Of what has no value at all, the members say nothing.
        if !matches!(value, Written::Other(found) if found == without) {
            problems.into_iter().for_each(|message| self.problem(place.clone(), message));
        }
        Entry::new(name, place, value, deviation)
    }
}

impl Written {
    /// The same number, with a unit behind the whole of it.
    fn in_unit(self, unit: &str) -> Self {
        match self {
            Self::Text(text) if has_deviation(&text) => Self::Text(format!("({}) {}", text.trim(), unit.trim())),
            Self::Text(text) => Self::Text(format!("{} {}", text.trim(), unit.trim())),
            other => other,
        }
    }
}

fn unknown(member: &str, name: &str) -> String {
    let meant = match member.to_ascii_lowercase().as_str() {
        "sigma" | "uncertainty" | "error" | "deviation" | "sd" | "stdev" | "stddev" | "std_dev" => Some("std"),
        "units" => Some("unit"),
        _ => nearest(member, MEMBERS),
    };
    let hint = meant.map(|meant| format!("; did you mean `{meant}`?")).unwrap_or_default();
    format!("`{name}` has a member `{member}`; expected `value`, `std` and `unit`{hint}")
}
