//! The equations of a model in notations that people read and typeset.

mod expression;
mod formula;
mod latex;
mod markup;
mod symbol;
#[cfg(test)]
mod tests;
mod typst;

use std::fmt::Write as _;

pub use self::expression::{Expression, FormulaNumber, Function};
pub use self::formula::Formula;
use self::latex::Latex;
use self::markup::{Markup, Writer};
use self::typst::Typst;
use crate::model::{FormulaInfo, FormulaSubject, ModelInfo};
use crate::system::MatrixName;

/// How equations are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// As a declaration has them.
    Text,
    /// LaTeX, with the package amsmath.
    Latex,
    /// Typst.
    Typst,
}

impl Notation {
    /// A name or a symbol as formulas have it, such as `I_{Bxx}` for `IBxx` and `\lambda` for `λ` in LaTeX, to stand in math
    /// mode.
    ///
    /// Available with feature `std`.
    ///
    /// ```
    /// assert_eq!(carvallo::Notation::Latex.symbol("IBxx"), "I_{Bxx}");
    /// ```
    pub fn symbol(self, name: &str) -> String {
        let symbol = |_: &str| None;
        match self {
            Self::Text => name.to_owned(),
            Self::Latex => Writer { markup: Latex, symbol: &symbol }.name(name),
            Self::Typst => Writer { markup: Typst, symbol: &symbol }.name(name),
        }
    }
}

impl ModelInfo {
    /// The equations of motion: the definitions that the matrices depend on, each in those before it, and the entries that
    /// are not zero, all with their units. Rows and columns are counted from one.
    ///
    /// Available with feature `std`.
    pub fn equations(&self, notation: Notation) -> String {
        match notation {
            Notation::Text => write_text(self),
            Notation::Latex => typeset(self, Latex),
            Notation::Typst => typeset(self, Typst),
        }
    }
}

/// The terms of the equation that a model has, each with its matrix: what multiplies q'', q' and q.
fn terms(info: &ModelInfo, matrix: impl Fn(&str, MatrixName) -> String) -> [Vec<String>; 3] {
    let all = [
        &[("", MatrixName::M)][..],
        &[("1/v", MatrixName::Cm1), ("", MatrixName::C0), ("v", MatrixName::C1)],
        &[("", MatrixName::Kc), ("g", MatrixName::K0), ("v", MatrixName::K1), ("v^2", MatrixName::K2)],
    ];
    all.map(|terms| {
        let own = terms.iter().filter(|(_, name)| info.matrices.contains(name));
        own.map(|(factor, name)| matrix(factor, *name)).collect()
    })
}

/// `M q'' + v C1 q' + (g K0 + v^2 K2) q = f` from its terms.
fn equation(terms: &[Vec<String>; 3], derivatives: [&str; 3]) -> String {
    let sums = terms.iter().zip(derivatives).filter_map(|(terms, q)| match &terms[..] {
        [] => None,
        [term] => Some(format!("{term} {q}")),
        terms => Some(format!("({}) {q}", terms.join(" + "))),
    });
    format!("{} = f", sums.collect::<Vec<String>>().join(" + "))
}

/// A factor before what it multiplies.
fn spaced(factor: &str) -> String {
    if factor.is_empty() { String::new() } else { format!("{factor} ") }
}

fn write_text(info: &ModelInfo) -> String {
    let terms = terms(info, |factor, name| format!("{}{name}", spaced(factor)));
    let coordinates: Vec<&str> = info.coordinates.iter().map(|coordinate| coordinate.name).collect();
    let mut text = equation(&terms, ["q''", "q'", "q"]);
    text.push_str(&format!(", q = ({})\n", coordinates.join(", ")));
    let [definitions, entries] = parts(info);
    for part in [definitions, entries] {
        // Writing to a string cannot fail.
        part.iter().enumerate().for_each(|(index, formula)| {
            let _ = writeln!(text, "{}{formula}", if index == 0 { "\n" } else { "" });
        });
    }
    text
}

/// The definitions, and the entries.
fn parts(info: &ModelInfo) -> [&'static [FormulaInfo]; 2] {
    let is_entry = |formula: &FormulaInfo| matches!(formula.of, FormulaSubject::Entry(_));
    let first = info.formulas.iter().position(is_entry).unwrap_or(info.formulas.len());
    let (definitions, entries) = info.formulas.split_at(first);
    [definitions, entries]
}

/// The lines of an equation: what the formula is of, the lines of the formula, and its unit.
struct Equation {
    of: Vec<String>,
    lines: Vec<String>,
    unit: Option<String>,
}

/// The equations in a language.
fn equations<M: Markup>(info: &ModelInfo, part: &[FormulaInfo], writer: &Writer<'_, M>) -> Vec<Equation> {
    let entry = |(matrix, row, column): &(MatrixName, usize, usize)| {
        let (letter, number) = matrix.name().split_at(1);
        let comma = if info.coordinates.len() > 9 { "," } else { "" };
        let place = format!("{}{comma}{}", row + 1, column + 1);
        let index = if number.is_empty() { place } else { format!("{number},{place}") };
        writer.markup.index(letter, &index)
    };
    let equation = |FormulaInfo { of, unit, text }: &FormulaInfo| Equation {
        of: match of {
            FormulaSubject::Definition(name) | FormulaSubject::Attribute { name, .. } => vec![writer.name(name)],
            FormulaSubject::Entry(places) => places.places.iter().map(entry).collect(),
        },
        // What the compiler writes is a formula; a text of another origin stands as it is.
        lines: Formula::parse(text).map_or_else(|| vec![writer.markup.word(text)], |formula| writer.lines(&formula)),
        unit: (!matches!(*unit, "" | "1")).then(|| writer.markup.unit(unit)),
    };
    part.iter().map(equation).collect()
}

/// The symbols of parameters that are not their names.
fn symbols(info: &ModelInfo) -> impl Fn(&str) -> Option<&'static str> {
    let parameters = info.parameters;
    move |name| parameters.iter().find(|parameter| parameter.name == name).map(|parameter| parameter.symbol)
}

/// The equations for a typesetter: the equation of motion, the definitions, and the entries.
fn typeset<M: Markup>(info: &ModelInfo, markup: M) -> String {
    let symbol = symbols(info);
    let writer = Writer { markup, symbol: &symbol };
    let matrix = |name: MatrixName| match name.name().split_at(1) {
        (letter, "") => letter.to_owned(),
        (letter, number) => format!("{letter}_{number}"),
    };
    let terms = terms(info, |factor, name| format!("{}{}", spaced(factor), matrix(name)));
    let coordinates: Vec<String> = info.coordinates.iter().map(|coordinate| writer.name(coordinate.name)).collect();
    let mut text = writer.markup.head(info.name, &equation(&terms, M::DERIVATIVES), &coordinates.join(", "));
    for part in parts(info).into_iter().filter(|part| !part.is_empty()) {
        let rows = equations(info, part, &writer).into_iter();
        let rows: Vec<String> = rows
            .map(|Equation { of, lines, unit }| writer.markup.row(&of.join(" = "), &lines, unit.as_deref()))
            .collect();
        text.push_str(&writer.markup.block(&rows));
    }
    text
}
