//! Eigenvalues that are followed one by one as a table: a column for each strand of branches.

use std::fmt::Write as _;

use anstyle::Style;
use carvallo::{Complex, Verdict};
use carvallo_design::DisplayUnit;
use carvallo_design::number::fixed;
use carvallo_plot::analysis::strands::{Strand, strands};
use carvallo_plot::analysis::{Eigenvalues, ROUNDING, Row, largest};

use super::columns::{LINE, speeds, width};
use super::{FAINT, GOOD, HEADING};

/// What stands in a column at one speed: a pair, or real ones side by side.
enum Cell {
    Pair { re: String, im: String },
    Others(String),
}

/// The cells of a strand, from top to bottom.
struct Column {
    title: String,
    cells: Vec<Cell>,
    /// The widths of real parts and of imaginary parts of pairs, and of all.
    re: usize,
    im: usize,
    all: usize,
}

/// Where the columns are wider than a line may be, there are several tables, one below the other.
///
/// Writing to a string cannot fail, so that the results of `write!` are dropped.
pub fn write_eigenvalues(rows: &[Row<Eigenvalues>], unit: &DisplayUnit, text: &mut String) {
    let _ = writeln!(text, "\n{HEADING}Eigenvalues{HEADING:#} (1/s)");
    let speeds = speeds(rows, unit);
    let v = width(&speeds, 9);
    let columns: Vec<Column> = strands(rows).into_iter().map(|strand| column(strand, rows)).collect();
    let mut rest = columns.as_slice();
    while !rest.is_empty() {
        let mut taken = 0;
        let mut line = v + 10;
        while taken < rest.len() && (taken == 0 || line + rest[taken].all <= LINE) {
            line += rest[taken].all;
            taken += 1;
        }
        let (now, later) = rest.split_at(taken);
        write_table(now, rows, (&speeds, v, unit), text);
        rest = later;
        if !rest.is_empty() {
            text.push('\n');
        }
    }
}

fn write_table(
    columns: &[Column],
    rows: &[Row<Eigenvalues>],
    (speeds, v, unit): (&[String], usize, &DisplayUnit),
    text: &mut String,
) {
    let titles: String = columns.iter().map(|column| format!("{:>1$}", column.title, column.all)).collect();
    let heading = format!("v ({})", unit.written);
    let _ = writeln!(text, "{FAINT}{heading:>v$}{:10}{titles}{FAINT:#}", "");
    for (index, row) in rows.iter().enumerate() {
        let verdict = row.values.verdict;
        let style = if verdict == Verdict::Stable { GOOD } else { Style::new() };
        let cell = |column: &Column| match &column.cells[index] {
            Cell::Pair { re, im } => {
                let pair = format!("{re:>0$} ± {im:>1$} i", column.re, column.im);
                format!("{pair:>0$}", column.all)
            }
            Cell::Others(others) => format!("{others:>0$}", column.all),
        };
        let cells: String = columns.iter().map(cell).collect();
        let line = format!("{:>v$}  {:<8}{cells}", speeds[index], verdict.to_string());
        let _ = writeln!(text, "{style}{}{style:#}", line.trim_end());
    }
}

/// The title of each strand, and its eigenvalues from top to bottom.
pub fn cells(rows: &[Row<Eigenvalues>]) -> Vec<(String, Vec<String>)> {
    let text = |cell: &Cell| match cell {
        Cell::Pair { re, im } => format!("{re} ± {im} i"),
        Cell::Others(others) => others.clone(),
    };
    let columns = strands(rows).into_iter().map(|strand| column(strand, rows));
    columns.map(|column| (column.title, column.cells.iter().map(text).collect())).collect()
}

fn column(strand: Strand, rows: &[Row<Eigenvalues>]) -> Column {
    let cell = |row: &Row<Eigenvalues>| {
        let rounding = ROUNDING * largest(row.values.values.iter().map(|value| value.value));
        let real = |value: Complex<f64>| fixed(if value.re.abs() < rounding { 0.0 } else { value.re }, 6);
        let mut values: Vec<Complex<f64>> = strand
            .branches
            .iter()
            .map(|&branch| row.values.values[branch].value)
            .filter(|value| value.im >= 0.0)
            .collect();
        values.sort_by(|x, y| x.im.total_cmp(&y.im).then(x.re.total_cmp(&y.re)));
        match values[..] {
            [pair] if pair.im > 0.0 => Cell::Pair { re: real(pair), im: fixed(pair.im, 6) },
            _ => {
                let one = |value: &Complex<f64>| match value.im {
                    0.0 => real(*value),
                    im => format!("{} ± {} i", real(*value), fixed(im, 6)),
                };
                Cell::Others(values.iter().map(one).collect::<Vec<_>>().join(", "))
            }
        }
    };
    let cells: Vec<Cell> = rows.iter().map(cell).collect();
    let widest = |part: &dyn Fn(&Cell) -> usize| cells.iter().map(part).max().unwrap_or(0);
    let count = |text: &String| text.chars().count();
    let re = widest(&|cell| if let Cell::Pair { re, .. } = cell { count(re) } else { 0 });
    let im = widest(&|cell| if let Cell::Pair { im, .. } = cell { count(im) } else { 0 });
    let others = widest(&|cell| if let Cell::Others(others) = cell { count(others) } else { 0 });
    let pair = if im > 0 { re + 3 + im + 2 } else { 0 };
    Column { all: pair.max(others).max(count(&strand.title)) + 3, title: strand.title, cells, re, im }
}
