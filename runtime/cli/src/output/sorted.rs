//! The eigenvalues of a model that does not depend on the speed, for people: any number of them, pairs as one.

use std::fmt::Write as _;

use anstyle::Style;
use carvallo::{Complex, ModeValue, Verdict};
use carvallo_design::number::fixed;
use carvallo_plot::analysis::{Eigenvalues, ROUNDING, Row, largest};

use super::columns::{LINE, width};
use super::{GOOD, HEADING};

/// A real eigenvalue, or a pair with the size of its imaginary parts.
struct Entry {
    re: String,
    im: Option<String>,
}

/// Writing to a string cannot fail, so that the results of `write!` are dropped.
pub fn write_eigenvalues(rows: &[Row<Eigenvalues>], text: &mut String) {
    let _ = writeln!(text, "\n{HEADING}Eigenvalues{HEADING:#} (1/s) at every speed: nothing depends on v");
    let entries: Vec<Vec<Entry>> = rows.iter().map(|row| entries(&row.values.values)).collect();
    let all = || entries.iter().flatten();
    let re = width(all().map(|entry| &entry.re), 12);
    let im = width(all().filter_map(|entry| entry.im.as_ref()), 9) - 2;
    let columns = ((LINE - 10) / (re + im + 5)).max(1);
    for (index, row) in rows.iter().enumerate() {
        let verdict = row.values.verdict;
        let style = if verdict == Verdict::Stable { GOOD } else { Style::new() };
        for (line, entries) in entries[index].chunks(columns).enumerate() {
            let verdict = if line == 0 { verdict.to_string() } else { String::new() };
            let _ = write!(text, "{style}  {verdict:<8}");
            for (column, Entry { re: real, im: imaginary }) in entries.iter().enumerate() {
                let _ = match imaginary {
                    Some(imaginary) => write!(text, "{real:>re$} ± {imaginary:>im$} i"),
                    // No spaces stand at the end of a line.
                    None if column + 1 == entries.len() => write!(text, "{real:>re$}"),
                    None => write!(text, "{real:>re$}{:1$}", "", im + 5),
                };
            }
            let _ = writeln!(text, "{style:#}");
        }
    }
}

/// The eigenvalues of each row, pairs as one.
pub fn cells(rows: &[Row<Eigenvalues>]) -> Vec<String> {
    let text = |Entry { re, im }: &Entry| match im {
        Some(im) => format!("{re} ± {im} i"),
        None => re.clone(),
    };
    rows.iter().map(|row| entries(&row.values.values).iter().map(text).collect::<Vec<_>>().join(", ")).collect()
}

/// Pairs stand where their half with the negative imaginary part does.
fn entries(values: &[ModeValue]) -> Vec<Entry> {
    let values = || values.iter().map(|value| value.value);
    let rounding = ROUNDING * largest(values());
    let lower_half = values().filter(|value| value.im <= 0.0);
    let entry = |value: Complex<f64>| {
        let re = if value.re.abs() < rounding { 0.0 } else { value.re };
        Entry { re: fixed(re, 6), im: (value.im < 0.0).then(|| fixed(-value.im, 6)) }
    };
    lower_half.map(entry).collect()
}
