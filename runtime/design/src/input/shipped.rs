//! Parameters that ship with Carvallo: bicycles for the model of Whipple and Carvallo, and the sets of every other model.

use carvallo::SetInfo;
use carvallo_models::BICYCLES;

use super::document::{Document, Entry, File};
use super::toml;
use crate::failure::Place;
use crate::model::{MODELS, Shipped, WHIPPLE};
use crate::nearest::nearest;
use crate::number::shortest;

/// The bicycle that is meant unless another one is named.
pub const DEFAULT_BICYCLE: &str = "benchmark";

/// The names that can be chosen for a model.
pub fn names(model: &Shipped) -> Vec<&'static str> {
    if model.is_whipple() {
        BICYCLES.iter().map(|bicycle| bicycle.name).collect()
    } else {
        model.info.sets.iter().map(|set| set.name).collect()
    }
}

/// The name that is meant unless another one is given; a model may have none.
pub fn default_name(model: &Shipped) -> Option<&'static str> {
    if model.is_whipple() { Some(DEFAULT_BICYCLE) } else { model.info.sets.first().map(|set| set.name) }
}

/// What the machine of a name is, in a few words.
pub fn kind(model: &Shipped, name: &str) -> Option<String> {
    find(model, name)?.kind
}

/// What ships for a model under a name.
pub fn find(model: &Shipped, name: &str) -> Option<Document> {
    if let Some(set) = model.info.set(name).filter(|_| !model.is_whipple()) {
        return Some(document(model, set));
    }
    // A model with all parameters of the bicycles, and perhaps more, can have theirs.
    let parameters = WHIPPLE.info.parameters.iter();
    if parameters.map(|parameter| model.info.position(parameter.name)).any(|position| position.is_none()) {
        return None;
    }
    let bicycle = BICYCLES.iter().find(|bicycle| bicycle.name == name)?;
    Some(toml::read(File { label: name, text: bicycle.toml }))
}

fn document(model: &Shipped, set: &SetInfo) -> Document {
    let text = |text: &str| (!text.is_empty()).then(|| text.to_owned());
    let entries = model.info.parameters.iter().zip(set.values);
    let place = Place::File(set.name.to_owned());
    Document {
        name: text(set.name),
        kind: set.docs.lines().next().and_then(text),
        source: text(set.source),
        model: text(model.info.name),
        entries: entries.map(|(info, value)| Entry::from_text(info.name, place.clone(), &shortest(*value))).collect(),
        ..Document::default()
    }
}

/// That nothing is called so, and what may have been meant.
pub fn unknown(model: &Shipped, name: &str) -> String {
    if name.contains(['/', '\\', '.']) {
        let own = name.split('.').next().filter(|own| names(model).contains(own));
        let hint = own.map(|own| format!("; `{own}` without an ending is the one that ships")).unwrap_or_default();
        return format!("there is no file {name}{hint}");
    }
    let others = MODELS.iter().filter(|other| !other.is_called(model.info.name) && names(other).contains(&name));
    let others: Vec<String> = others.map(|other| format!("`--model {}`", other.info.name)).collect();
    let hint = if !others.is_empty() {
        format!("; it belongs to {}", others.join(" or "))
    } else if let Some(other) = MODELS.iter().find(|other| other.is_called(name)) {
        format!("; it is a model: `--model {}`", other.info.name)
    } else {
        nearest(name, names(model)).map(|name| format!("; did you mean `{name}`?")).unwrap_or_default()
    };
    if model.is_whipple() {
        format!("there is neither a bicycle nor a file `{name}`{hint}\n`carvallo bicycles` lists the bicycles")
    } else {
        let model = model.info.name;
        let list = "`carvallo models` lists the parameter sets";
        format!("there is neither a parameter set of {model} nor a file `{name}`{hint}\n{list}")
    }
}
