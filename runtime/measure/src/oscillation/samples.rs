//! What is in the file of a recorded signal: a line for each sample.

use carvallo_design::number::shortest;
use carvallo_design::quantity::{Scale, headed, scale};

use super::Recording;

/// Times that are others by this part of a step are not those of a rate.
const SAME: f64 = 1e-2;

impl Recording {
    /// Times in s and values, of what is good of it.
    ///
    /// # Errors
    /// What is wrong with the text; or that it has times, which are others than those of the rate that is given.
    pub(super) fn samples(&self, text: &str) -> Result<(Vec<f64>, Vec<f64>), String> {
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
        let mut has_times = false;
        let rows = || lines.iter().skip(usize::from(has_names)).map(|(_, text)| cells(text));
        if let Some(rate) = self.rate.filter(|_| first.len() > 1 && signal > 0) {
            let heading = if has_names { first[0].as_str() } else { "" };
            let unit = if heading.is_empty() { None } else { unit_of_times(heading).unwrap_or(None) };
            let of_first = rows().filter_map(|cells| value(cells.first()?));
            let column: Vec<f64> = of_first.map(|time| unit.map_or(time, |unit| unit.apply(time))).collect();
            has_times = are_times(&column, heading, rate)?;
        }
        let time = time.or_else(|| has_times.then_some(0));
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
            Some(column) => {
                let is_called = |name: &String| name == column || name.starts_with(&format!("{column} "));
                let named = first.iter().position(|name| has_names && is_called(name));
                let numbered = column.parse().ok().filter(|number| (1..=first.len()).contains(number));
                let found = named.or_else(|| Some(numbered? - 1));
                found.map(|at| (time, at)).ok_or_else(|| match has_names {
                    true => format!("there is no column `{column}`; there are {}", first.join(", ")),
                    false => format!(
                        "there is no column `{column}`: they have no names; give its number, 1 to {}",
                        first.len()
                    ),
                })
            }
            None if first.len() <= 2 => Ok((time, first.len() - 1)),
            None => Err(format!(
                "it has {} columns; give that of the signal as `column`, by its name or its number",
                first.len()
            )),
        }
    }
}

/// Whether a column, by its heading, has the times in s of a rate of samples a second: what ascends all along are times, unless it
/// counts the samples.
///
/// # Errors
/// If they are times at another rate.
fn are_times(column: &[f64], heading: &str, rate: f64) -> Result<bool, String> {
    let ascends = column.len() > 1 && column.windows(2).all(|pair| pair[1] > pair[0]);
    let counts = column.windows(2).all(|pair| pair[1] - pair[0] == 1.0);
    let name = headed(heading).0.to_lowercase();
    let is_named = ["t", "time", "times", "timestamp"].iter().any(|own| name == *own) || name.starts_with("time");
    if !ascends || counts && !is_named {
        return Ok(false);
    }
    let step = (column[column.len() - 1] - column[0]) / (column.len() - 1) as f64;
    if (step * rate - 1.0).abs() <= SAME {
        return Ok(true);
    }
    let which = if heading.is_empty() { String::new() } else { format!(", `{heading}`,") };
    let [step, rate] = [format!("{step:.5e}").parse().unwrap_or(step), rate].map(shortest);
    Err(format!(
        "its first column{which} ascends by {step} a sample, as times in s do, but `rate` is {rate} samples a second; leave `rate` \
         out, or say the unit in the heading of the times, as `time (ms)`"
    ))
}

/// What separates the cells of a line: nothing but space where it is `None`.
fn separator(line: &str) -> Option<char> {
    [';', '\t', ','].into_iter().find(|sign| line.contains(*sign))
}

/// The unit in the heading of the times, if there is one: `t [ms]`, `time (ms)`, `t / ms`, `time_ms` or `time ms`.
fn unit_of_times(heading: &str) -> Result<Option<Scale>, String> {
    if let (_, Some(unit)) = headed(heading) {
        let unknown = || format!("the times are headed `{heading}`; `{unit}` is no unit of time");
        return scale(unit, "s").map(Some).ok_or_else(unknown);
    }
    Ok(heading.rsplit_once(['_', ' ']).and_then(|(_, behind)| scale(behind, "s")))
}
