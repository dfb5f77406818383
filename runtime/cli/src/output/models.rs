//! The shipped models at a glance.

use std::fmt::Write as _;

use carvallo_design::Shipped;

use super::equations::coordinate;
use super::{FAINT, HEADING};

pub fn render_models(models: &[Shipped]) -> String {
    let name = models.iter().map(|model| model.info.name.len()).max().unwrap_or(0) + 2;
    let mut text = format!("{HEADING}{:<name$}{:<13}{:<12}sets{HEADING:#}\n", "model", "coordinates", "parameters");
    for model in models {
        let info = model.info;
        let sets = sets(model);
        let [coordinates, parameters] = [info.coordinates.len(), info.parameters.len()];
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{HEADING}{:<name$}{HEADING:#}{coordinates:<13}{parameters:<12}{sets}", info.name);
        let coordinates: Vec<String> = info.coordinates.iter().map(coordinate).collect();
        let coordinates = format!("q = ({})", coordinates.join(", "));
        for about in [sentence(info.docs), coordinates, info.source.to_owned()] {
            if !about.is_empty() {
                let _ = writeln!(text, "  {FAINT}{about}{FAINT:#}");
            }
        }
    }
    text
}

/// The names of its parameter sets.
pub fn sets(model: &Shipped) -> String {
    let sets: Vec<&str> = model.info.sets.iter().map(|set| set.name).collect();
    match sets[..] {
        _ if model.is_whipple() => "`carvallo bicycles` lists them".to_owned(),
        [] => "-".to_owned(),
        ref sets => sets.join(", "),
    }
}

/// The first sentence of a text, on one line.
pub fn sentence(docs: &str) -> String {
    let paragraph = docs.trim().split("\n\n").next().unwrap_or_default();
    let text = paragraph.split_whitespace().collect::<Vec<_>>().join(" ");
    match text.split_once(". ") {
        Some((first, _)) => format!("{first}."),
        None => text,
    }
}
