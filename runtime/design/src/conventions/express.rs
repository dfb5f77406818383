//! A design in the paper's parameters expressed in another convention, so that settings by its names can change it.

use std::collections::HashMap;

use carvallo::{Covariance, ModelInfo};

use super::Convention;
use super::carried::{Carried, deviations};
use super::name::Values;
use super::recognise::only;
use crate::failure::Place;
use crate::input::{
    Document, Entry, Named, Names, Node, Scope, Value, Written, position, resolve_correlations, validate,
};
use crate::number::shortest;
use crate::parameter::find;

/// If some settings are in the names of another convention, and none of the paper's, the parameters in that: everything that is
/// not set stays as it is there. Nothing otherwise, and where a parameter is missing or wrong, which is told elsewhere.
pub fn express(
    document: &mut Document,
    label: &str,
    info: &'static ModelInfo,
    settings: &[Entry],
) -> Option<&'static Convention> {
    let foreign: Vec<Entry> = settings.iter().filter(|entry| position(&entry.name, info).is_none()).cloned().collect();
    let convention = only(&foreign)?;
    let mut values = Values::default();
    let mut given = Vec::new();
    let scope = Scope::new(&document.entries, HashMap::new(), info);
    for parameter in crate::model::WHIPPLE.info.parameters {
        let at = info.position(parameter.name);
        let Some(entry) = document.entries.iter().find(|entry| position(&entry.name, info) == at) else {
            // What no matrix depends on, and gravity, may be missing.
            if !parameter.used || parameter.name == "g" {
                continue;
            }
            return None;
        };
        let value = validate(entry, parameter, &|name: &str| scope.value(name)).ok()?;
        values.push(parameter.name, value.value.into());
        given.push((parameter.name, value));
    }
    let names = Names {
        find: &|name| {
            let own = info.parameters[find(name, info)?].name;
            given.iter().position(|(name, _)| *name == own).ok_or_else(|| format!("`{own}` is not given"))
        },
        name: &|position: usize| given[position].0,
    };
    let parts: Vec<_> = given.iter().map(|(_, given)| given).collect();
    let covariance = resolve_correlations(std::mem::take(&mut document.correlations), &names, &parts, &|_| false);
    let covariance = match covariance {
        Ok(covariance) => covariance.map_or_else(|| Covariance::independent(&deviations(parts)).ok(), Some)?,
        Err(problems) => {
            document.problems.extend(problems);
            return None;
        }
    };
    let place = || Place::File(label.to_owned());
    let expressed = match (convention.from_paper)(&values) {
        Ok(expressed) => expressed,
        Err(message) => {
            document.problem(place(), message);
            return None;
        }
    };
    let carried = Carried::new(&values, &covariance, convention.from_paper);
    let entries: Vec<Entry> = expressed
        .iter()
        .map(|(name, value)| {
            let deviation = carried.deviation(name);
            let mut entry = Entry::from_text(name, place(), &shortest(value.value));
            entry.deviation = (deviation > 0.0).then(|| Written::Text(shortest(deviation)));
            entry
        })
        .collect();
    let named = |name: &str, value| Named { name: name.to_owned(), node: Node { place: place(), value } };
    let name = |position: usize| entries[position].name.as_str();
    let correlations = carried.covariance(expressed.iter().map(|(name, _)| name));
    let pairs = correlations.map(|covariance| covariance.correlations()).unwrap_or_default();
    document.correlations = pairs
        .iter()
        .map(|&(a, b, value)| named(name(a), Value::Table(vec![named(name(b), Value::Number(shortest(value)))])))
        .collect();
    // What the model has beside the paper's parameters stays.
    let is_paper = |entry: &Entry| {
        position(&entry.name, info)
            .is_some_and(|at| crate::model::WHIPPLE.info.position(info.parameters[at].name).is_some())
    };
    document.entries.retain(|entry| !is_paper(entry));
    document.entries.extend(entries);
    Some(convention)
}
