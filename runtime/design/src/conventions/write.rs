//! Parameters in any convention as a file: in every form that is read again.

use super::convert::{Converted, Parameter};
use super::jbike6::{BODIES, JBIKE6};
use crate::design::Design;
use crate::display::DisplayUnit;
use crate::file::{Row, entry, quoted, write_correlations, write_rows};
use crate::model::WHIPPLE;
use crate::number::{shortest, unit};
use crate::units::Units;

/// The form of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// With comments.
    Toml,
    /// An object.
    Json,
    /// A parameter a line.
    Yaml,
    /// A parameter a line, with its unit and its standard deviation in columns.
    Csv,
    /// Assignments.
    Python,
    /// Assignments.
    Matlab,
    /// As BicycleParameters has it, `mB = 85.0+/-5.0`.
    Text,
}

/// The contents of a file, which reads back to the same parameters. What is said beside them goes through `comment`: a terminal
/// may have it in another style. Units other than those of the SI stand in forms that have a place for them.
pub fn write(converted: &Converted, form: Form, units: &Units, comment: &dyn Fn(&str) -> String) -> String {
    match form {
        Form::Toml => write_toml(converted, units, comment),
        Form::Json => write_json(converted, units),
        Form::Yaml => write_yaml(converted, units, comment),
        Form::Csv => write_csv(converted, units),
        Form::Python => write_script(converted, "#", "", comment),
        Form::Matlab => write_script(converted, "%", ";", comment),
        Form::Text => write_text(converted),
    }
}

/// What has no place in such a file, and what else is to be known of it.
pub fn left_out(design: &Design, converted: &Converted, form: Form) -> Vec<String> {
    let mut notes = Vec::new();
    if !design.feedback.is_empty() {
        notes.push("these parameters have no place for feedback: left out".to_owned());
    }
    notes.extend(converted.notes.iter().cloned());
    if !form.has_deviations() && converted.parameters.iter().any(|parameter| parameter.given.deviation.is_some()) {
        notes.push("a script has no place for standard deviations: left out".to_owned());
    }
    if !form.has_correlations() && form.has_deviations() && converted.covariance.is_some() {
        notes.push("only toml and json have a place for correlations: left out".to_owned());
    }
    notes
}

impl Form {
    /// Whether it has standard deviations.
    pub fn has_deviations(self) -> bool {
        !matches!(self, Self::Python | Self::Matlab)
    }

    /// Whether it has correlations.
    pub fn has_correlations(self) -> bool {
        matches!(self, Self::Toml | Self::Json)
    }

    /// Whether it has units.
    pub fn has_units(self) -> bool {
        matches!(self, Self::Toml | Self::Json | Self::Yaml | Self::Csv)
    }
}

impl Parameter {
    /// The unit that it is written in.
    fn shown(&self, units: &Units) -> DisplayUnit {
        units.or(self.name.unit, self.name.printed.filter(|_| units.is_si()))
    }

    /// Value and standard deviation as numbers in a unit; with their digits as they were written where that is the declared one.
    fn numbers(&self, shown: &DisplayUnit) -> (String, Option<String>) {
        let number = |written: &str, value: f64| match written.parse::<f64>() {
            Ok(_) if shown.is_declared() => written.to_owned(),
            _ => shortest(shown.value(value)),
        };
        let deviation = self.given.deviation.as_ref();
        (
            number(&self.given.written, self.given.value),
            deviation.map(|deviation| number(&deviation.written, deviation.value)),
        )
    }
}

/// `name`, `kind` and `source`; and the model and the convention if they are not the usual ones, with their texts.
fn headings(converted: &Converted) -> Vec<(&'static str, &str)> {
    let Converted { convention, model, name, kind, source, .. } = converted;
    let headings = [
        ("name", Some(name.as_str())),
        ("model", Some(*model).filter(|model| *model != WHIPPLE.info.name)),
        ("kind", kind.as_deref()),
        ("source", source.as_deref()),
        ("parameterization", Some(convention.name).filter(|_| !convention.is_paper())),
    ];
    headings.into_iter().filter_map(|(key, text)| Some((key, text?))).collect()
}

fn write_toml(converted: &Converted, units: &Units, comment: &dyn Fn(&str) -> String) -> String {
    let mut text = String::new();
    headings(converted).iter().for_each(|(key, value)| text.push_str(&format!("{key} = {}\n", quoted(value))));
    let rows = converted.parameters.iter().map(|parameter| {
        let shown = parameter.shown(units);
        let entry = entry(&parameter.given, &shown);
        Row { name: parameter.name.name, entry, unit: shown.unit(), docs: parameter.name.docs }
    });
    text.push_str("\n[parameters]\n");
    text.push_str(&write_rows(rows.collect(), comment));
    if let Some(covariance) = &converted.covariance {
        write_correlations(covariance, &|position| converted.parameters[position].name.name, &mut text);
    }
    text
}

fn write_json(converted: &Converted, units: &Units) -> String {
    let entry = |parameter: &Parameter| {
        let shown = parameter.shown(units);
        let (value, deviation) = parameter.numbers(&shown);
        let members: Vec<String> = [
            Some(format!("\"value\": {}", json_number(&value))),
            deviation.map(|deviation| format!("\"std\": {}", json_number(&deviation))),
            (!shown.is_declared()).then(|| format!("\"unit\": {}", quoted(&shown.written))),
        ]
        .into_iter()
        .flatten()
        .collect();
        let value = if members.len() == 1 { json_number(&value) } else { format!("{{{}}}", members.join(", ")) };
        format!("    {}: {value}", quoted(parameter.name.name))
    };
    let headings: String =
        headings(converted).iter().map(|(key, text)| format!("  \"{key}\": {},\n", quoted(text))).collect();
    let entries: Vec<String> = converted.parameters.iter().map(entry).collect();
    let name = |position: usize| quoted(converted.parameters[position].name.name);
    let pairs = converted.covariance.as_ref().map(|covariance| covariance.correlations()).unwrap_or_default();
    let correlated = pairs.chunk_by(|a, b| a.0 == b.0).map(|pairs| {
        let others: Vec<String> = pairs.iter().map(|pair| format!("{}: {}", name(pair.1), shortest(pair.2))).collect();
        format!("    {}: {{{}}}", name(pairs[0].0), others.join(", "))
    });
    let correlations: Vec<String> = correlated.collect();
    let correlations = match correlations.is_empty() {
        true => String::new(),
        false => format!(",\n  \"correlations\": {{\n{}\n  }}", correlations.join(",\n")),
    };
    format!("{{\n{headings}  \"parameters\": {{\n{}\n  }}{correlations}\n}}\n", entries.join(",\n"))
}

/// JSON does not have all spellings of numbers that others have.
fn json_number(written: &str) -> String {
    written.parse().map_or_else(|_| written.to_owned(), shortest)
}

/// A number with its deviation and its unit behind both.
fn measured(parameter: &Parameter, shown: &DisplayUnit) -> String {
    let unit = |text: String| if shown.is_declared() { text } else { format!("{text} {}", shown.written) };
    match parameter.numbers(shown) {
        (value, None) => unit(value),
        (value, Some(deviation)) if shown.is_declared() => format!("{value}+/-{deviation}"),
        (value, Some(deviation)) => unit(format!("({value}+/-{deviation})")),
    }
}

fn write_yaml(converted: &Converted, units: &Units, comment: &dyn Fn(&str) -> String) -> String {
    let mut text = String::new();
    let headings = headings(converted);
    headings.iter().for_each(|(key, value)| text.push_str(&format!("{key}: {}\n", quoted(value))));
    text.push_str("values:\n");
    for parameter in &converted.parameters {
        let shown = parameter.shown(units);
        let value = format!("  {}: {}", parameter.name.name, measured(parameter, &shown));
        text.push_str(&format!(
            "{value:40}  {}\n",
            comment(&format!("# {} {}", shown.unit(), first(parameter.name.docs)))
        ));
    }
    text
}

/// The clause that says what a parameter is.
fn first(docs: &str) -> &str {
    docs.trim().split([':', ';', '.', '\n']).next().unwrap_or_default()
}

fn write_csv(converted: &Converted, units: &Units) -> String {
    let mut text = "name,value,std,unit\n".to_owned();
    let convention = converted.convention;
    if !convention.is_paper() {
        text.push_str(&format!("parameterization,{},,\n", convention.name));
    }
    for parameter in &converted.parameters {
        let shown = parameter.shown(units);
        let (value, deviation) = parameter.numbers(&shown);
        let unit = if shown.written == "1" { "" } else { &shown.written };
        text.push_str(&format!("{},{value},{},{unit}\n", parameter.name.name, deviation.unwrap_or_default()));
    }
    text
}

fn write_text(converted: &Converted) -> String {
    let si = Units::default();
    let line = |parameter: &Parameter| {
        format!("{} = {}\n", parameter.name.name, measured(parameter, &si.of(parameter.name.unit)))
    };
    let convention = converted.convention;
    let heading = (!convention.is_paper()).then(|| format!("parameterization = {}\n", convention.name));
    heading.into_iter().chain(converted.parameters.iter().map(line)).collect()
}

/// Assignments, with what they are in comments.
fn write_script(converted: &Converted, sign: &str, end: &str, comment: &dyn Fn(&str) -> String) -> String {
    let mut text = String::new();
    let quote = |text: &str| if sign == "%" { format!("'{}'", text.replace('\'', "''")) } else { quoted(text) };
    for (key, value) in headings(converted) {
        text.push_str(&format!("{key} = {}{end}\n", quote(value)));
    }
    let is_jbike6 = converted.convention.name == JBIKE6.name && sign == "%";
    let value = |name: &str| {
        let found = converted.parameters.iter().find(|parameter| parameter.name.name == name);
        found.map(|parameter| shortest(parameter.given.value)).unwrap_or_default()
    };
    for parameter in &converted.parameters {
        let name = parameter.name.name;
        let (entry, docs) = match list_of(name).filter(|_| is_jbike6) {
            Some(List::First(body)) => {
                let moments = ["I11", "I22", "Izz"].map(|axis| value(&format!("{axis}{body}")));
                (
                    format!("I{body} = [{}]", moments.join(" ")),
                    "[I11 I22 Izz] about its principal axes 1 and 2, and about z",
                )
            }
            Some(List::Rest) => continue,
            None => (format!("{name} = {}", shortest(parameter.given.value)), first(parameter.name.docs)),
        };
        let unit = unit(parameter.name.unit);
        let unit = if unit.is_empty() { String::new() } else { format!("[{unit}] ") };
        text.push_str(&format!("{:32}  {}\n", format!("{entry}{end}"), comment(&format!("{sign} {unit}{docs}"))));
    }
    text
}

/// What a name is in a list of three moments.
enum List {
    /// The first of those of a body.
    First(&'static str),
    /// One of the others.
    Rest,
}

fn list_of(name: &str) -> Option<List> {
    let of = |axis: &str| BODIES.into_iter().find(|body| name.strip_prefix(axis) == Some(*body));
    of("I11").map(List::First).or_else(|| of("I22").or_else(|| of("Izz")).map(|_| List::Rest))
}
