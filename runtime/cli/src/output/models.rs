//! The shipped models at a glance.

use std::fmt::Write as _;

use super::{FAINT, HEADING};
use crate::model::Shipped;

pub fn models(models: &[Shipped]) -> String {
    let rows: Vec<[String; 4]> = models.iter().map(row).collect();
    let headings = ["model", "coordinates", "parameters", "sets"].map(str::to_owned);
    let width = |column: usize| {
        let texts = rows.iter().chain([&headings]).map(|row| row[column].chars().count());
        texts.max().unwrap_or(0) + 2
    };
    let widths = [0, 1, 2].map(width);
    let mut text = String::new();
    // Writing to a string cannot fail.
    let mut line = |[first, second, third, last]: &[String; 4], end: &str| {
        let [a, b, c] = widths;
        let _ = writeln!(text, "{HEADING}{first:<a$}{HEADING:#}{second:<b$}{third:<c$}{last}{end}");
    };
    line(&headings, "");
    for (model, row) in models.iter().zip(&rows) {
        let mut end = String::new();
        for about in [sentence(model.info.docs), model.info.source.to_owned()] {
            if !about.is_empty() {
                let _ = write!(end, "\n  {FAINT}{about}{FAINT:#}");
            }
        }
        line(row, &end);
    }
    text
}

fn row(model: &Shipped) -> [String; 4] {
    let info = model.info;
    let coordinates: Vec<String> = info.coordinates.iter().map(super::equations::coordinate).collect();
    let sets: Vec<&str> = info.sets.iter().map(|set| set.name).collect();
    let sets = match sets[..] {
        _ if model.is_whipple() => "`carvallo bicycles`".to_owned(),
        [] => "-".to_owned(),
        ref sets => sets.join(", "),
    };
    [info.name.to_owned(), coordinates.join(", "), info.parameters.len().to_string(), sets]
}

/// The first sentence of a text, on one line.
fn sentence(docs: &str) -> String {
    let text = docs.split("\n\n").next().unwrap_or_default().split_whitespace().collect::<Vec<_>>().join(" ");
    match text.split_once(". ") {
        Some((first, _)) => format!("{first}."),
        None => text,
    }
}
