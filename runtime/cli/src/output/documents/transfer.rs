//! Transfer functions: their poles, and a table for each.

use carvallo::Complex;
use carvallo_design::number::{fixed, shortest, unit};
use carvallo_plot::analysis::transfer::{AtFrequency, Transfer, Transfers};

use super::state_space::at;
use crate::output::typeset::{Cell, Column, Document, Table};

/// The poles that all have in common, and what each has besides.
pub fn of_transfers(transfers: &Transfers) -> Document {
    let at = at(transfers.space);
    let poles = Table {
        title: format!("Poles{at}"),
        columns: ["pole (1/s)", "frequency (rad/s)", "damping ratio"].map(Column::right).into(),
        rows: transfers.poles.iter().filter(|pole| pole.im >= 0.0).map(|pole| modal(*pole)).collect(),
        notes: Vec::new(),
    };
    let each = transfers.channels.iter().map(|channel| table(channel, &at));
    let together = if transfers.are_several() { together(transfers, &at) } else { Vec::new() };
    super::about(transfers.design, [poles].into_iter().chain(together).chain(each).collect())
}

/// What all inputs and outputs have together: transmission zeros, and singular values by decades.
fn together(transfers: &Transfers, at: &str) -> Vec<Table> {
    let is_square = transfers.space.inputs.len() == transfers.space.outputs.len();
    let told = is_square.then(|| match transfers.transmission_zeros.as_deref() {
        None => vec![["all numbers", "", ""].map(Cell::words).to_vec()],
        Some([]) => vec![["none", "", ""].map(Cell::words).to_vec()],
        Some(zeros) => zeros.iter().filter(|zero| zero.im >= 0.0).map(|zero| modal(*zero)).collect(),
    });
    let dependent =
        "At every frequency some direction of inputs does nothing to any of the outputs: these depend on each other.";
    let zeros = told.map(|rows| Table {
        title: format!("Transmission zeros{at}  of all inputs and outputs"),
        columns: ["zero (1/s)", "frequency (rad/s)", "damping ratio"].map(Column::right).into(),
        rows,
        notes: transfers.transmission_zeros.is_none().then(|| dependent.to_owned()).into_iter().collect(),
    });
    let count = transfers.singular_values.first().map_or(0, |at| at.values.len());
    let row = |at: &AtFrequency| {
        let cells = [at.frequency].into_iter().chain(at.values.iter().copied());
        cells.map(|value| Cell::number(significant(value))).collect()
    };
    let singular = Table {
        title: format!("Singular values{at}"),
        columns: ["frequency (rad/s)".to_owned()]
            .into_iter()
            .chain((1..=count).map(|place| format!("σ{place}")))
            .map(Column::right)
            .collect(),
        rows: by_decades(&transfers.singular_values).into_iter().map(row).collect(),
        notes: Vec::new(),
    };
    zeros.into_iter().chain([singular]).collect()
}

/// A few of many: those nearest to powers of ten, and where there are few all.
fn by_decades(all: &[AtFrequency]) -> Vec<&AtFrequency> {
    const FEW: usize = 12;
    if all.len() <= FEW {
        return all.iter().collect();
    }
    let decade = |at: &AtFrequency| at.frequency.log10().round();
    let off = |at: &&AtFrequency| (at.frequency.log10() - decade(at)).abs();
    let groups = all.chunk_by(|a, b| decade(a) == decade(b));
    groups.filter_map(|group| group.iter().min_by(|a, b| off(a).total_cmp(&off(b)))).collect()
}

/// A pole, or a pair, with its natural frequency and damping ratio.
fn modal(pole: Complex<f64>) -> Vec<Cell> {
    let size = pole.norm();
    // Adding zero turns -0 into 0.
    let ratio = if size == 0.0 { "-".to_owned() } else { fixed(0.0 - real(pole) / size + 0.0, 4) };
    [root(pole), fixed(size, 4), ratio].map(Cell::number).to_vec()
}

/// The real part, without what rounding leaves of none.
fn real(root: Complex<f64>) -> f64 {
    const ROUNDING: f64 = 1e-14;
    if root.re.abs() > ROUNDING * root.norm() { root.re } else { 0.0 }
}

/// A real root, or the pair that a root is half of.
fn root(root: Complex<f64>) -> String {
    let re = fixed(real(root), 6);
    if root.im == 0.0 { re } else { format!("{re} ± {} i", fixed(root.im, 6)) }
}

fn table(channel: &Transfer, at: &str) -> Table {
    let Transfer { function, margins, .. } = channel;
    let number = |value: f64| if value == 0.0 { "0".to_owned() } else { fixed(value, 6) };
    let unit = unit(&channel.unit());
    let mut rows: Vec<[String; 2]> = vec![["gain k".to_owned(), number(function.gain)]];
    let rest = function.static_gain().map_or("infinite".to_owned(), |gain| format!("{} {unit}", number(gain)));
    rows.push(["static gain G(0)".to_owned(), rest]);
    rows.push(["zeros (1/s)".to_owned(), roots(&function.zeros)]);
    let cancelled = function.cancelled();
    if !cancelled.is_empty() {
        rows.push(["poles that zeros cancel".to_owned(), roots(&cancelled)]);
    }
    rows.push(["numerator".to_owned(), polynomial(&function.numerator())]);
    rows.push(["denominator".to_owned(), polynomial(&function.denominator())]);
    for margin in &margins.gain {
        let decibels = fixed(20.0 * margin.factor.log10(), 3);
        let text =
            format!("{decibels} dB, a factor of {}, at {} rad/s", fixed(margin.factor, 4), fixed(margin.frequency, 4));
        rows.push(["gain margin".to_owned(), text]);
    }
    for margin in &margins.phase {
        let text = format!("{}° at {} rad/s", fixed(margin.angle.to_degrees(), 3), fixed(margin.frequency, 4));
        rows.push(["phase margin".to_owned(), text]);
    }
    // How large a gain of 1 is depends on the units of both.
    let [u, y] = [&function.input.unit, &function.output.unit].map(|own| match self::unit(own) {
        own if own.is_empty() => "as a number".to_owned(),
        own => format!("in {own}"),
    });
    rows.push(["the loop u = -y".to_owned(), format!("{}, with u {u} and y {y}", margins.closed_loop)]);
    Table {
        title: format!("{}{at}  {} to {}", channel.title(), function.input.label, function.output.label),
        columns: ["", ""].map(Column::left).into(),
        rows: rows.into_iter().map(|[name, text]| vec![Cell::words(name), cell(text)]).collect(),
        notes: Vec::new(),
    }
}

/// Numbers and polynomials are set as such; behind a unit or a margin there are words.
fn cell(text: String) -> Cell {
    let is_number = |c: char| c.is_ascii_digit() || "+-. eis^±,".contains(c);
    if text.chars().all(is_number) { Cell::number(text) } else { Cell::words(text) }
}

fn roots(roots: &[Complex<f64>]) -> String {
    let roots: Vec<String> = roots.iter().filter(|value| value.im >= 0.0).map(|value| root(*value)).collect();
    if roots.is_empty() { "none".to_owned() } else { roots.join(", ") }
}

/// `s² + 3 s + 2`, with the coefficients from the highest power down.
fn polynomial(coefficients: &[f64]) -> String {
    let degree = coefficients.len() - 1;
    let mut text = String::new();
    for (place, coefficient) in coefficients.iter().enumerate().filter(|(_, coefficient)| **coefficient != 0.0) {
        let sign = match (text.is_empty(), *coefficient < 0.0) {
            (true, true) => "-",
            (true, false) => "",
            (false, true) => " - ",
            (false, false) => " + ",
        };
        let power = match degree - place {
            0 => String::new(),
            1 => "s".to_owned(),
            power => format!("s^{power}"),
        };
        let size = coefficient.abs();
        let size = if size == 1.0 && !power.is_empty() { String::new() } else { significant(size) };
        let between = if size.is_empty() || power.is_empty() { "" } else { " " };
        text += &format!("{sign}{size}{between}{power}");
    }
    if text.is_empty() { "0".to_owned() } else { text }
}

/// Six digits.
fn significant(value: f64) -> String {
    let rounded: f64 = format!("{value:.5e}").parse().unwrap_or(value);
    shortest(rounded)
}
