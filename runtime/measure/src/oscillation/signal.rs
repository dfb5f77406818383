//! A recorded signal: which file it is in, and what of it.

use std::path::Path;

use carvallo_design::Failure;
use carvallo_design::input::{Named, Node, Value, is_folder, text};
use carvallo_design::number::{fixed, shortest};
use carvallo_design::quantity::{Context, Mistake, Reason, no_names, number};

use super::fit::{Oscillation, fit};

/// Endings of files that are recordings where they stand in the place of a period.
const ENDINGS: [&str; 4] = ["csv", "tsv", "txt", "dat"];

/// Which file, and what of it.
pub struct Recording {
    file: String,
    /// The column of the signal by its name, or its number from 1; otherwise the second, or the only one.
    pub(super) column: Option<String>,
    /// Samples a second, of a file without times.
    pub(super) rate: Option<f64>,
    /// The times in s between which it is good.
    pub(super) from: f64,
    pub(super) to: f64,
}

impl Recording {
    /// `"frame.csv"`, or `{ file = "frame.csv", column = "rate", from = 2, to = "30 s" }`; `None` if it is something else.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn of(value: &Value) -> Option<Result<Self, String>> {
        match value {
            Value::Text(text) => {
                let ending = Path::new(text.trim()).extension()?.to_str()?.to_lowercase();
                ENDINGS.contains(&ending.as_str()).then(|| Ok(Self::new(text.trim())))
            }
            Value::Table(members) if members.iter().any(|member| member.name == "file") => {
                Some(Self::of_table(members))
            }
            _ => None,
        }
    }

    fn new(file: &str) -> Self {
        Self { file: file.to_owned(), column: None, rate: None, from: f64::NEG_INFINITY, to: f64::INFINITY }
    }

    fn of_table(members: &[Named]) -> Result<Self, String> {
        let mut recording = Self::new("");
        for Named { name, node: Node { value, .. } } in members {
            let (Value::Text(text) | Value::Number(text)) = value else {
                return Err(format!("`{name}` of a recording must be a text or a number"));
            };
            let in_unit = |text: &str, unit| {
                number(text, Context { unit, names: &no_names }).map_err(|Mistake { reason, .. }| match reason {
                    Reason::Unit(unknown) => {
                        format!("`{name}` is `{text}`; `{unknown}` is no unit for it: it is in {unit}")
                    }
                    Reason::Other(reason) => format!("`{name}` is `{text}`; expected a number in {unit}: {reason}"),
                })
            };
            match name.as_str() {
                "file" => recording.file.clone_from(text),
                "column" => recording.column = Some(text.clone()),
                "rate" => match in_unit(&per_second(text), "1/s")? {
                    rate if rate > 0.0 => recording.rate = Some(rate),
                    _ => return Err(format!("`rate` is `{text}`; samples a second must be more than 0")),
                },
                "from" => recording.from = in_unit(text, "s")?,
                "to" => recording.to = in_unit(text, "s")?,
                _ => {
                    let known = "`file`, `column`, `rate`, `from` and `to`";
                    return Err(format!("`{name}` is nothing that a recording has, which is {known}"));
                }
            }
        }
        if recording.from >= recording.to {
            let [from, to] = [recording.from, recording.to].map(shortest);
            return Err(format!("the recording is from {from} s to {to} s; these must ascend"));
        }
        Ok(recording)
    }

    /// The oscillation in the file, which is beside the one that names it; and what is said of it.
    ///
    /// # Errors
    /// If there is no such file, it cannot be read, or there is no oscillation in it.
    pub fn period(&self, beside: &str) -> Result<(Oscillation, String), Failure> {
        let path = Path::new(beside).parent().unwrap_or(Path::new("")).join(&self.file);
        let shown = path.display();
        let wrong = |error: &dyn std::fmt::Display| Failure::usage(format!("{shown}: {error}"));
        if !path.exists() {
            return Err(Failure::usage(format!("there is no file {shown}")));
        }
        if path.is_dir() {
            return Err(Failure::usage(is_folder(&shown.to_string())));
        }
        let bytes = std::fs::read(&path).map_err(|error| Failure::Run(format!("cannot read {shown}: {error}")))?;
        let (times, signal) = self.samples(&String::from_utf8_lossy(&text(bytes))).map_err(|error| wrong(&error))?;
        let found = fit(&times, &signal).map_err(|error| wrong(&error))?;
        let Oscillation { period, deviation, decay, samples, periods, r_squared, drift, amplitude, .. } = found;
        let percent = 100.0 * (drift * period / amplitude).abs();
        let drift = match drift {
            0.0 => String::new(),
            _ => format!(", beside a drift of the zero by {} % of the amplitude a period", fixed(percent, 2)),
        };
        let said = format!(
            "{} ± {} s by {shown}: {samples} samples of {periods:.1} periods, decay {} 1/s, R² {r_squared:.5}{drift}",
            shortest(rounded(period, deviation)),
            shortest(rounded(deviation, 0.1 * deviation)),
            shortest(rounded(decay, 0.01 * decay.abs())),
        );
        Ok((found, said))
    }
}

/// A rate of samples without hertz, which are no unit elsewhere, where they might be turns or radians a second.
fn per_second(text: &str) -> String {
    let text = text.trim();
    let hertz = |unit: &str, times: &str| Some(format!("({}){times}", text.strip_suffix(unit)?.trim()));
    hertz("kHz", "*1000").or_else(|| hertz("Hz", "")).unwrap_or_else(|| text.to_owned())
}

/// With as many digits as a deviation tells, and two more.
fn rounded(value: f64, deviation: f64) -> f64 {
    if !(deviation > 0.0 && value.is_finite()) {
        return value;
    }
    let digits = (1.0 - deviation.log10().floor()).clamp(0.0, 15.0) as usize;
    format!("{value:.digits$}").parse().unwrap_or(value)
}
