//! Forces: `delta=2 N m`, or `delta=torque.csv` with a time and a force in each line.

use std::path::Path;

use carvallo::simulation::{Force, ForceError};
use carvallo_design::input::decode;
use carvallo_design::number::shortest;
use carvallo_design::quantity::{self, Context, Mistake, Reason, no_names};
use carvallo_design::{Failure, Place, Problem, is_called, nearest};

/// A force that may be given: its names, the first of which is its own, and its unit.
#[derive(Clone, Debug)]
pub struct Channel {
    /// Its own first.
    pub names: Vec<String>,
    /// Of the force.
    pub unit: &'static str,
}

/// One force for each channel, zero where nothing is given.
///
/// # Errors
/// Everything that is wrong with the options and with what stands in files.
pub fn forces(
    options: &[String],
    channels: &[Channel],
    duration: f64,
    model: &str,
) -> Result<Vec<Force>, Vec<Problem>> {
    let mut forces = vec![Force::constant(0.0); channels.len()];
    let mut given = vec![false; channels.len()];
    let mut problems = Vec::new();
    for option in options {
        let fail = |message: String| vec![Problem { place: Place::Option(format!("--force {option}")), message }];
        let read = split(option, channels, model).map_err(fail).and_then(|(index, text)| {
            if std::mem::replace(&mut given[index], true) {
                return Err(fail("it is given twice".to_owned()));
            }
            Ok((index, force(text, channels[index].unit, duration, &fail)?))
        });
        match read {
            Ok((index, force)) => forces[index] = force,
            Err(found) => problems.extend(found),
        }
    }
    if problems.is_empty() { Ok(forces) } else { Err(problems) }
}

fn split<'a>(option: &'a str, channels: &[Channel], model: &str) -> Result<(usize, &'a str), String> {
    let (name, text) = option.split_once('=').ok_or("expected NAME=VALUE or NAME=FILE.csv, such as delta=2")?;
    let name = name.trim();
    let found = channels.iter().position(|channel| channel.names.iter().any(|own| is_called(own, own, name)));
    let index = found.ok_or_else(|| {
        let hint = nearest(name, channels.iter().flat_map(|channel| channel.names.iter().map(String::as_str)));
        let hint = hint.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
        let names: Vec<&str> = channels.iter().map(|channel| channel.names[0].as_str()).collect();
        format!("`{name}` is no force on {model}{hint}\nthey are {}", names.join(", "))
    })?;
    Ok((index, text.trim()))
}

fn force(text: &str, unit: &str, duration: f64, fail: &dyn Fn(String) -> Vec<Problem>) -> Result<Force, Vec<Problem>> {
    if is_file(text) {
        return read(text, unit, duration);
    }
    number(text, unit).map(Force::constant).map_err(fail)
}

/// Whether a file is meant, which may be missing.
fn is_file(text: &str) -> bool {
    let path = Path::new(text);
    path.is_file()
        || path
            .extension()
            .is_some_and(|ending| ["csv", "txt", "tsv"].iter().any(|own| ending.eq_ignore_ascii_case(own)))
}

/// The force in a file, from its beginning to the end of the motion.
fn read(path: &str, unit: &str, duration: f64) -> Result<Force, Vec<Problem>> {
    let of_file = |message: String| vec![Problem { place: Place::File(path.to_owned()), message }];
    if !Path::new(path).exists() {
        return Err(vec![Problem { place: Place::Nowhere, message: format!("there is no file {path}") }]);
    }
    let bytes = std::fs::read(path).map_err(|error| of_file(format!("cannot be read: {error}")))?;
    let text = decode(path, bytes).map_err(|failure| match failure {
        Failure::Input(problems) => problems,
        failure => of_file(failure.to_string()),
    })?;
    let mut points: Vec<(f64, f64)> = Vec::new();
    let mut units = [None, None];
    let (mut lines, mut problems) = (Vec::new(), Vec::new());
    for (index, line) in text.lines().enumerate() {
        let line_number = index + 1;
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        match point(line, unit, &units) {
            Ok(point) => {
                points.push(point);
                lines.push(line_number);
            }
            // The names of the columns.
            Err(_) if points.is_empty() && problems.is_empty() && is_header(line) => match header_units(line, unit) {
                Ok(found) => units = found,
                Err(message) => problems.push(Problem { place: Place::Line(path.to_owned(), line_number), message }),
            },
            Err(message) => {
                problems.push(Problem { place: Place::Line(path.to_owned(), line_number), message });
            }
        }
    }
    if !problems.is_empty() {
        return Err(problems);
    }
    let force = Force::through(&points).map_err(|error| {
        let (index, message) = match error {
            ForceError::Empty => return of_file("there is no line with a time and a force".to_owned()),
            ForceError::Unsorted { index, before, time } => {
                let [time, before] = [time, before].map(shortest);
                (index, format!("the time {time} s comes behind {before} s; times must ascend"))
            }
            ForceError::Repeated { index, time } => {
                (index, format!("it is the third line at {} s; a jump has two", shortest(time)))
            }
            ForceError::NotFinite { index, value } => (index, format!("{value} is not finite")),
            other => return of_file(other.to_string()),
        };
        vec![Problem { place: Place::Line(path.to_owned(), lines[index]), message }]
    })?;
    let (first, last) = (points[0].0, points[points.len() - 1].0);
    let covers = |message: String| Err(of_file(message));
    if first > 0.0 {
        return covers(format!("the first time is {} s; it must begin at 0 s, where the motion does", shortest(first)));
    }
    if last < duration && points.len() > 1 {
        let [last, duration] = [last, duration].map(shortest);
        return covers(format!("the last time is {last} s; it must reach {duration} s, where the motion ends"));
    }
    Ok(force)
}

/// The fields of a line, separated by semicolons, tabs, commas or spaces, out of their quotes. Behind the last one there may be
/// another separator; where it is no comma, numbers may have one in the place of the point.
fn fields(line: &str) -> Vec<String> {
    let separator = [';', '\t', ','].into_iter().find(|separator| line.contains(*separator));
    let unquoted = |field: &str| field.trim().trim_matches('"').trim().to_owned();
    let mut fields: Vec<String> = match separator {
        Some(separator) => line.split(separator).map(unquoted).collect(),
        None => line.split_whitespace().map(unquoted).collect(),
    };
    if fields.len() > 2 && fields.last().is_some_and(String::is_empty) {
        fields.pop();
    }
    if separator != Some(',') {
        fields.iter_mut().for_each(|field| *field = field.replacen(',', ".", 1));
    }
    fields
}

/// The units that the names of the columns end with, in parentheses or brackets. Pure numbers have none.
fn header_units(line: &str, unit: &str) -> Result<[Option<String>; 2], String> {
    let mut units = [None, None];
    for ((found, field), unit) in units.iter_mut().zip(fields(line)).zip(["s", unit]) {
        let inner = [('(', ')'), ('[', ']')].into_iter().find_map(|(open, close)| {
            field.strip_suffix(close)?.rsplit_once(open).map(|(_, inner)| inner.trim().to_owned())
        });
        let Some(inner) = inner.filter(|inner| !inner.is_empty() && unit != "1") else { continue };
        number(&format!("1 {inner}"), unit)
            .map_err(|_| format!("`{inner}` is no unit for it; it is in {}", carvallo_design::number::unit(unit)))?;
        *found = Some(inner);
    }
    Ok(units)
}

/// A line with a time and a force, in the units of the columns where they have none of their own.
fn point(line: &str, unit: &str, units: &[Option<String>; 2]) -> Result<(f64, f64), String> {
    let fields = fields(line);
    let value = |index: usize, unit: &str| match &units[index] {
        Some(of_column) if fields[index].parse::<f64>().is_ok() => {
            number(&format!("{} {of_column}", fields[index]), unit)
        }
        _ => number(&fields[index], unit),
    };
    match &fields[..] {
        [time, force] if !time.is_empty() && !force.is_empty() => Ok((value(0, "s")?, value(1, unit)?)),
        [_, _] => Err("there is a gap; expected a time in s and a force".to_owned()),
        _ => {
            let fields = fields.len();
            let noun = if fields == 1 { "field" } else { "fields" };
            Err(format!("the line has {fields} {noun}; expected a time in s and a force"))
        }
    }
}

/// Whether no field of a line begins as a number does.
fn is_header(line: &str) -> bool {
    fields(line).iter().all(|field| field.starts_with(char::is_alphabetic))
}

fn number(text: &str, unit: &str) -> Result<f64, String> {
    quantity::number(text, Context { unit, names: &no_names }).map_err(|Mistake { reason, .. }| match reason {
        Reason::Unit(found) => {
            format!("`{text}`: `{found}` is no unit for it; it is in {}", carvallo_design::number::unit(unit))
        }
        Reason::Other(reason) => format!("`{text}` must be a finite number: {reason}"),
    })
}
