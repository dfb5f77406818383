//! A recorded signal: a file with times and values.

use std::path::Path;

use carvallo_design::input::{Named, Node, Value};
use carvallo_design::number::{fixed, shortest};
use carvallo_design::quantity::{Context, Mistake, Reason, Scale, headed, no_names, number, scale};

use super::fit::{Oscillation, fit};

/// Endings of files that are recordings where they stand in the place of a period.
const ENDINGS: [&str; 4] = ["csv", "tsv", "txt", "dat"];

/// Which file, and what of it.
pub struct Recording {
    file: String,
    /// The column of the signal by its name; otherwise the second, or the only one.
    column: Option<String>,
    /// Samples a second, of a file without times.
    rate: Option<f64>,
    /// The times in s between which it is good.
    from: f64,
    to: f64,
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
    /// If the file cannot be read, or there is no oscillation in it.
    pub fn period(&self, beside: &str) -> Result<(Oscillation, String), String> {
        let path = Path::new(beside).parent().unwrap_or(Path::new("")).join(&self.file);
        let shown = path.display();
        let bytes = std::fs::read(&path).map_err(|error| format!("cannot read {shown}: {error}"))?;
        let (times, signal) =
            self.samples(&String::from_utf8_lossy(&bytes)).map_err(|error| format!("{shown}: {error}"))?;
        let found = fit(&times, &signal).map_err(|error| format!("{shown}: {error}"))?;
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

    /// Times in s and values, of what is good of it.
    fn samples(&self, text: &str) -> Result<(Vec<f64>, Vec<f64>), String> {
        let is_data = |(_, line): &(usize, &str)| !line.is_empty() && !line.starts_with(['#', '%']);
        let lines = text.trim_start_matches('\u{feff}').lines().map(str::trim).enumerate().filter(is_data);
        let lines: Vec<(usize, &str)> = lines.collect();
        let separator = separator(lines.last().map_or("", |(_, line)| line));
        let cells = |line: &str| -> Vec<String> {
            let cells: Vec<&str> = match separator {
                Some(sign) => line.split(sign).collect(),
                None => line.split_whitespace().collect(),
            };
            cells.iter().map(|cell| cell.trim().trim_matches('"').to_owned()).collect()
        };
        let value = |cell: &str| {
            // Where commas separate nothing, decimals may stand behind them.
            let cell = if separator == Some(',') { cell.to_owned() } else { cell.replace(',', ".") };
            cell.parse::<f64>().ok()
        };
        let first = lines.first().map(|(_, line)| cells(line)).ok_or("it is empty")?;
        let has_names = first.iter().any(|cell| value(cell).is_none());
        let (time, signal) = self.columns(&first, has_names)?;
        let of_time = first.get(time.unwrap_or(0)).filter(|_| has_names && time.is_some());
        let unit = of_time.map_or(Ok(None), |heading| unit_of_times(heading))?;
        let mut samples = (Vec::new(), Vec::new());
        for (row, (line, text)) in lines.iter().skip(usize::from(has_names)).enumerate() {
            let cells = cells(text);
            let cell = |column: usize| {
                let cell = cells.get(column).map_or("", String::as_str);
                value(cell).ok_or_else(|| format!("line {}: `{cell}`; expected a number", line + 1))
            };
            let at = match (time, self.rate) {
                (Some(column), _) => unit.map_or(cell(column)?, |unit| unit.apply(cell(column).unwrap_or(f64::NAN))),
                (None, Some(rate)) => row as f64 / rate,
                (None, None) => return Err("it has no times; give the samples a second as `rate`".to_owned()),
            };
            if (self.from..=self.to).contains(&at) {
                samples.0.push(at);
                samples.1.push(cell(signal)?);
            }
        }
        Ok(samples)
    }

    /// Which columns have the times, if any does, and the signal.
    fn columns(&self, first: &[String], has_names: bool) -> Result<(Option<usize>, usize), String> {
        let time = if self.rate.is_some() || first.len() == 1 { None } else { Some(0) };
        match &self.column {
            Some(column) if has_names => {
                let found = first.iter().position(|name| name == column || name.starts_with(&format!("{column} ")));
                found.map(|at| (time, at)).ok_or_else(|| format!("there is no column `{column}`"))
            }
            Some(column) => Err(format!("there is no column `{column}`, since its columns have no names")),
            None if first.len() <= 2 => Ok((time, first.len() - 1)),
            None => Err(format!("it has {} columns; give that of the signal as `column`", first.len())),
        }
    }
}

/// A rate of samples without hertz, which are no unit elsewhere, where they might be turns or radians a second.
fn per_second(text: &str) -> String {
    let text = text.trim();
    let hertz = |unit: &str, times: &str| Some(format!("({}){times}", text.strip_suffix(unit)?.trim()));
    hertz("kHz", "*1000").or_else(|| hertz("Hz", "")).unwrap_or_else(|| text.to_owned())
}

/// What separates the cells of a line: nothing but space where it is `None`.
fn separator(line: &str) -> Option<char> {
    [';', '\t', ','].into_iter().find(|sign| line.contains(*sign))
}

/// With as many digits as a deviation tells, and two more.
fn rounded(value: f64, deviation: f64) -> f64 {
    if !(deviation > 0.0 && value.is_finite()) {
        return value;
    }
    let digits = (1.0 - deviation.log10().floor()).clamp(0.0, 15.0) as usize;
    format!("{value:.digits$}").parse().unwrap_or(value)
}

/// The unit in the heading of the times, if there is one: `t [ms]`, `time (ms)`, `t / ms`, `time_ms` or `time ms`.
fn unit_of_times(heading: &str) -> Result<Option<Scale>, String> {
    if let (_, Some(unit)) = headed(heading) {
        let unknown = || format!("the times are headed `{heading}`; `{unit}` is no unit of time");
        return scale(unit, "s").map(Some).ok_or_else(unknown);
    }
    Ok(heading.rsplit_once(['_', ' ']).and_then(|(_, behind)| scale(behind, "s")))
}
