//! A design as a file, which can be edited and read again.

use carvallo::{CoordinateInfo, States};

use crate::design::{Design, Given};
use crate::display::DisplayUnit;
use crate::matrices::NAME;
use crate::number::shortest;

/// The parameters as TOML, which reads back to the same design. What is said beside them, such as units, goes through
/// `comment`: a terminal may have it in another style.
pub fn write(design: &Design, comment: &dyn Fn(&str) -> String) -> String {
    write_in(design, &DisplayUnit::declared, comment)
}

/// The same in other units, by what a declared one is shown in. Given matrices stay in those of the SI.
pub fn write_in(design: &Design, unit_of: &dyn Fn(&str) -> DisplayUnit, comment: &dyn Fn(&str) -> String) -> String {
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
    if !design.feedback.is_empty() {
        let laws: Vec<String> = design.feedback.iter().map(|law| quoted(&law.written)).collect();
        line(format!("feedback = [{}]", laws.join(", ")));
    }
    for warning in &design.warnings {
        line(comment(&format!("# warning: {warning}")));
    }
    if info.name == NAME {
        text.push('\n');
        write_matrices(design, comment, &mut text);
        return text;
    }
    line("\n[parameters]".to_owned());
    let rows = info.parameters.iter().zip(&design.parameters).map(|(info, given)| {
        let unit = unit_of(info.unit);
        Row { name: info.name, entry: entry(given, &unit), unit: unit.unit(), docs: info.docs }
    });
    text.push_str(&write_rows(rows.collect(), comment));
    #[cfg(feature = "full")]
    if let Some(covariance) = &design.covariance {
        write_correlations(covariance, &|position| info.parameters[position].name, &mut text);
    }
    text
}

/// A parameter in a line of its own.
pub(crate) struct Row<'a> {
    /// What it is called.
    pub name: &'a str,
    /// Its value, as TOML has it.
    pub entry: String,
    /// The unit of a plain number.
    pub unit: String,
    /// What it is.
    pub docs: &'a str,
}

/// Parameters with what they are behind them, below each other.
pub(crate) fn write_rows(rows: Vec<Row>, comment: &dyn Fn(&str) -> String) -> String {
    let entries: Vec<(String, String, &str)> = rows
        .into_iter()
        .map(|Row { name, entry, unit, docs }| {
            // What follows explains; the first clause says what it is.
            let docs = docs.trim().split([':', ';', '.', '\n']).next().unwrap_or_default();
            (format!("{name} = {entry}"), unit, docs)
        })
        .collect();
    let width = entries.iter().map(|(entry, ..)| entry.len()).max().unwrap_or(0);
    let units = entries.iter().map(|(_, unit, _)| unit.chars().count()).fold(6, usize::max);
    let line = |(entry, unit, docs)| format!("{entry:width$}  {}\n", comment(&format!("# {unit:units$} {docs}")));
    entries.into_iter().map(line).collect()
}

/// Of each pair of parameters that vary together, under the one that is declared later.
#[cfg(feature = "full")]
pub(crate) fn write_correlations(
    covariance: &carvallo::Covariance,
    name: &dyn Fn(usize) -> &'static str,
    text: &mut String,
) {
    text.push_str("\n[correlations]\n");
    for pairs in covariance.correlations().chunk_by(|a, b| a.0 == b.0) {
        let others: Vec<String> = pairs.iter().map(|pair| format!("{} = {}", name(pair.1), shortest(pair.2))).collect();
        text.push_str(&format!("{} = {{ {} }}\n", name(pairs[0].0), others.join(", ")));
    }
}

/// A value with its standard deviation: as they were written, or in another unit.
pub(crate) fn entry(given: &Given, unit: &DisplayUnit) -> String {
    let deviation = given.deviation.as_ref();
    if unit.is_declared() {
        let value = number(&given.written);
        return match deviation {
            Some(deviation) => format!("{{ value = {value}, std = {} }}", number(&deviation.written)),
            None => value,
        };
    }
    let shown = |value: f64| shortest(unit.value(value));
    match deviation {
        Some(deviation) => {
            let [value, deviation] = [given.value, deviation.value].map(shown);
            format!("{{ value = {value}, std = {deviation}, unit = {} }}", quoted(&unit.written))
        }
        None => quoted(&format!("{} {}", shown(given.value), unit.written)),
    }
}

/// Given matrices, with what their coordinates are.
fn write_matrices(design: &Design, comment: &dyn Fn(&str) -> String, text: &mut String) {
    let info = design.info();
    let coordinates = info.coordinates.iter().map(|CoordinateInfo { name, states, .. }| {
        let name = quoted(name);
        match states {
            States::Both => name,
            States::Position => format!("{{ name = {name}, only = \"position\" }}"),
            States::Rate => format!("{{ name = {name}, only = \"rate\" }}"),
        }
    });
    text.push_str(&format!("coordinates = [{}]\n", coordinates.collect::<Vec<_>>().join(", ")));
    let count = info.coordinates.len();
    let matrices = design.model.open.matrices;
    let (entries, gravity) = design.parameters.split_at(matrices.len() * count * count);
    for (matrix, entries) in matrices.iter().zip(entries.chunks(count * count)) {
        let plain = DisplayUnit::declared("1");
        let entries: Vec<String> = entries.iter().map(|given| entry(given, &plain)).collect();
        let width = entries.iter().map(|entry| entry.chars().count()).max().unwrap_or(0);
        let row = |row: &[String]| row.iter().map(|entry| format!("{entry:>width$}")).collect::<Vec<_>>().join(", ");
        let rows: Vec<String> = entries.chunks(count).map(|entries| format!("    [{}],\n", row(entries))).collect();
        text.push_str(&format!("{matrix} = [\n{}]\n", rows.concat()));
    }
    for g in gravity {
        text.push_str(&format!("g = {}  {}\n", entry(g, &DisplayUnit::declared("N/kg")), comment("# N/kg")));
    }
}

/// Digits stay as they were written; an expression, or a number that TOML writes otherwise, goes in quotes.
pub(crate) fn number(written: &str) -> String {
    let plain = toml::de::DeValue::parse(written).is_ok_and(|value| {
        let value = value.into_inner();
        value.is_float() || value.as_integer().is_some_and(|integer| integer.radix() == 10)
    });
    if plain { written.to_owned() } else { quoted(written) }
}

/// A string in quotes, as TOML reads it.
pub(crate) fn quoted(text: &str) -> String {
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
