//! A bicycle as a file: what `show` prints can be edited and analyzed.

use super::{FAINT, quoted};
use crate::input::{Bicycle, unit, warnings};

pub fn parameters(bicycle: &Bicycle) -> String {
    let info = bicycle.info();
    let mut text = String::new();
    let mut line = |line: String| text.extend([line.as_str(), "\n"]);
    line(format!("name = {}", quoted(&bicycle.name)));
    line(format!("model = {}", quoted(info.name)));
    for (key, value) in [("kind", &bicycle.kind), ("source", &bicycle.source)] {
        if let Some(value) = value {
            line(format!("{key} = {}", quoted(value)));
        }
    }
    let values: Vec<f64> = bicycle.parameters.iter().map(|given| given.value).collect();
    for warning in warnings(info, &values) {
        line(format!("{FAINT}# warning: {warning}{FAINT:#}"));
    }
    line("\n[parameters]".to_owned());
    let entries: Vec<(String, String)> = info
        .parameters
        .iter()
        .zip(&bicycle.parameters)
        .map(|(info, given)| {
            let value = number(&given.written);
            let entry = match &given.deviation {
                Some(deviation) => format!("{{ value = {value}, std = {} }}", number(deviation)),
                None => value,
            };
            let unit = unit(info.unit);
            // What follows explains; the first clause says what it is.
            let docs = info.docs.trim().split([':', ';', '.', '\n']).next().unwrap_or_default();
            (format!("{} = {entry}", info.name), format!("{unit:<6} {docs}"))
        })
        .collect();
    let width = entries.iter().map(|(entry, _)| entry.len()).max().unwrap_or(0);
    for (entry, comment) in entries {
        line(format!("{entry:width$}  {FAINT}# {comment}{FAINT:#}"));
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
