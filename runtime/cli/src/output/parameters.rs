//! A design as a file: what `show` prints can be edited and analyzed.

use super::FAINT;
use crate::design::Design;
use crate::number::unit;

pub fn render_parameters(design: &Design) -> String {
    let info = design.info();
    let mut text = String::new();
    let mut line = |line: String| text.extend([line.as_str(), "\n"]);
    line(format!("name = {}", quoted(&design.name)));
    line(format!("model = {}", quoted(info.name)));
    for (key, value) in [("kind", &design.kind), ("source", &design.source)] {
        if let Some(value) = value {
            line(format!("{key} = {}", quoted(value)));
        }
    }
    for warning in &design.warnings {
        line(format!("{FAINT}# warning: {warning}{FAINT:#}"));
    }
    line("\n[parameters]".to_owned());
    let entries: Vec<(String, String, &str)> = info
        .parameters
        .iter()
        .zip(&design.parameters)
        .map(|(info, given)| {
            let value = number(&given.written);
            let entry = match &given.deviation {
                Some(deviation) => format!("{{ value = {value}, std = {} }}", number(&deviation.written)),
                None => value,
            };
            let unit = unit(info.unit);
            // What follows explains; the first clause says what it is.
            let docs = info.docs.trim().split([':', ';', '.', '\n']).next().unwrap_or_default();
            (format!("{} = {entry}", info.name), unit, docs)
        })
        .collect();
    let width = entries.iter().map(|(entry, ..)| entry.len()).max().unwrap_or(0);
    let units = entries.iter().map(|(_, unit, _)| unit.chars().count()).fold(6, usize::max);
    for (entry, unit, docs) in entries {
        line(format!("{entry:width$}  {FAINT}# {unit:units$} {docs}{FAINT:#}"));
    }
    text
}

/// Digits stay as they were written; an expression, or a number that TOML writes otherwise, goes in quotes.
fn number(written: &str) -> String {
    let plain = toml::de::DeValue::parse(written).is_ok_and(|value| {
        let value = value.into_inner();
        value.is_float() || value.as_integer().is_some_and(|integer| integer.radix() == 10)
    });
    if plain { written.to_owned() } else { quoted(written) }
}

/// A string in quotes, as TOML reads it.
fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for char in text.chars() {
        match char {
            '"' | '\\' => quoted.extend(['\\', char]),
            char if char.is_control() => quoted.push_str(&format!("\\u{:04x}", u32::from(char))),
            char => quoted.push(char),
        }
    }
    quoted.push('"');
    quoted
}
