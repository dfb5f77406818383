//! Forces: `delta=2 N m`, or `delta=torque.csv` with a time and a force in each line.

use std::path::Path;

use carvallo::simulation::{Force, ForceError};
use carvallo_design::number::shortest;
use carvallo_design::quantity::{self, Context, Mistake, Reason, no_names};
use carvallo_design::{Place, Problem, nearest};

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
    let found = channels.iter().position(|channel| channel.names.iter().any(|own| own.eq_ignore_ascii_case(name)));
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
    let text = std::fs::read_to_string(path).map_err(|error| of_file(format!("cannot be read: {error}")))?;
    let mut points: Vec<(f64, f64)> = Vec::new();
    let (mut lines, mut problems) = (Vec::new(), Vec::new());
    for (index, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let line_number = index + 1;
        let line = line.trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        match point(line, unit) {
            Ok(point) => {
                points.push(point);
                lines.push(line_number);
            }
            // The names of the columns.
            Err(_) if points.is_empty() && problems.is_empty() && is_header(line) => {}
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

/// A line with a time and a force, separated by a comma, a semicolon, a tab or spaces.
fn point(line: &str, unit: &str) -> Result<(f64, f64), String> {
    let separator = [',', ';', '\t'].into_iter().find(|separator| line.contains(*separator));
    let fields: Vec<&str> = match separator {
        Some(separator) => line.split(separator).map(str::trim).collect(),
        None => line.split_whitespace().collect(),
    };
    match fields[..] {
        [time, force] if !time.is_empty() && !force.is_empty() => Ok((number(time, "s")?, number(force, unit)?)),
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
    line.split([',', ';', '\t'])
        .all(|field| field.trim().starts_with(|first: char| first.is_alphabetic() || first == '"'))
}

fn number(text: &str, unit: &str) -> Result<f64, String> {
    quantity::number(text, Context { unit, names: &no_names }).map_err(|Mistake { reason, .. }| match reason {
        Reason::Unit(found) => {
            format!("`{text}`: `{found}` is no unit for it; it is in {}", carvallo_design::number::unit(unit))
        }
        Reason::Other(reason) => format!("`{text}` must be a finite number: {reason}"),
    })
}
